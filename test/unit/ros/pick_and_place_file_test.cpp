#include "files/pick_and_place_file.h"

#include <filesystem>
#include <fstream>
#include <future>
#include <sstream>
#include <string>
#include <vector>

#include "source_tree.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

namespace cobot_command::ros_adapter {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// A file with one step; `changed` replaces its line that begins with the same key, or is added.
std::string fileWith(const std::string& changed) {
  std::ostringstream file;
  const std::string key = changed.substr(0, changed.find(':') + 1);
  bool replaced = false;
  file << "dwell: 2.5\nsteps:\n  -\n";
  for (const std::string line :
       {"movement_command: LINE", "data_format: CAP", "target_position: [430, -220.5, 260, 180, 0, 90]",
        "speed: 150", "accel_time: 300"}) {
    const bool replace = line.compare(0, key.size(), key) == 0;
    replaced = replaced || replace;
    file << "    " << (replace ? changed : line) << "\n";
  }
  if (!replaced) file << "    " << changed << "\n";
  return file.str();
}

blocks::PickAndPlaceStep stepWith(const std::string& changed) {
  const auto steps = parsePickAndPlace(fileWith(changed), "cell.yaml");
  if (steps && steps->size() == 1) return steps->front();
  ADD_FAILURE() << (steps ? "not one step" : steps.error());
  return {};
}

std::string errorOf(const std::string& text) {
  const auto steps = parsePickAndPlace(text, "cell.yaml");
  return steps ? "no error" : steps.error();
}

TEST(PickAndPlaceFile, theCycleOfTheThesisIsReadAsItStands) {
  const auto steps = readPickAndPlaceFile(test_support::inSourceTree("config/pick_and_place.yaml"));
  ASSERT_TRUE(steps) << steps.error();
  ASSERT_EQ(steps->size(), 6U);
  const auto& above = steps->at(0);
  EXPECT_EQ(above.move.movement_command, static_cast<int>(blocks::Movement::Ptp));
  EXPECT_EQ(above.move.data_format, static_cast<int>(blocks::AbsoluteFormat::Cpp));
  EXPECT_THAT(above.move.target, ElementsAre(430, -220, 380, 180, 0, 90));
  EXPECT_EQ(above.move.speed, 60);
  EXPECT_EQ(above.move.accel_time, 400);
  EXPECT_FALSE(above.move.disable_precise_positioning);
  EXPECT_TRUE(above.move.robot_pose_enable);
  EXPECT_THAT(above.move.robot_pose, ElementsAre(0, 2, 4));
  EXPECT_FALSE(steps->at(1).move.robot_pose_enable);
  std::vector<double> dwells;
  for (const auto& step : *steps) dwells.push_back(step.dwell);
  EXPECT_THAT(dwells, ElementsAre(0, 0, 2, 0, 0, 2));
}

TEST(PickAndPlaceFile, aStepMayLeaveTheListenNode) {
  EXPECT_TRUE(stepWith("exit_node: true").move.exit_node);
  EXPECT_FALSE(stepWith("exit_node: false").move.exit_node);
  EXPECT_FALSE(stepWith("name: without").move.exit_node);
  EXPECT_THAT(errorOf(fileWith("exit_node: perhaps")),
              HasSubstr("exit_node is something else; it must be true or false"));
}

TEST(PickAndPlaceFile, aDwellIsTheFilesOwnOrANumber) {
  EXPECT_EQ(stepWith("dwell: true").dwell, 2.5);
  EXPECT_EQ(stepWith("dwell: false").dwell, 0);
  EXPECT_EQ(stepWith("dwell: 0.75").dwell, 0.75);
  EXPECT_EQ(stepWith("name: without").dwell, 0);
}

TEST(PickAndPlaceFile, theUsualDwellIsThatOfTheThesisWhenTheFileHasNone) {
  std::string text = fileWith("dwell: true");
  text.erase(0, text.find('\n') + 1);
  const auto steps = parsePickAndPlace(text, "cell.yaml");
  ASSERT_TRUE(steps) << steps.error();
  EXPECT_EQ(steps->front().dwell, 2);
}

TEST(PickAndPlaceFile, anOutputIsSetAfterTheMove) {
  const auto output = stepWith("output: {module: EndModule, output: 1, value: true}").output;
  ASSERT_TRUE(output);
  EXPECT_EQ(output->module, "EndModule");
  EXPECT_EQ(output->output, 1);
  EXPECT_TRUE(output->value);
  EXPECT_FALSE(stepWith("name: without").output);
}

TEST(PickAndPlaceFile, whatAStepMayHaveIsRead) {
  EXPECT_EQ(stepWith("command_id: 4").move.command_id, 4);
  EXPECT_TRUE(stepWith("blending_enable: true").move.blending_enable);
  EXPECT_EQ(stepWith("blending_value: 40").move.blending_value, 40);
  EXPECT_TRUE(stepWith("disable_precise_positioning: true").move.disable_precise_positioning);
  EXPECT_FALSE(stepWith("disable_precise_positioning: false").move.disable_precise_positioning);
  EXPECT_THAT(stepWith("robot_pose: [LEFTY, BELOW, FLIP]").move.robot_pose, ElementsAre(1, 3, 5));
}

TEST(PickAndPlaceFile, theKeyThatHasChangedItsSenseIsRefusedWithWhatToWriteInstead) {
  for (const char* old : {"precise_positioning: true", "precise_positioning: false"}) {
    EXPECT_THAT(errorOf(fileWith(old)),
                AllOf(StartsWith("cell.yaml:9:"), HasSubstr("write disable_precise_positioning: true")));
  }
}

TEST(PickAndPlaceFile, anErrorNamesTheFileAndTheLine) {
  EXPECT_THAT(
      errorOf(fileWith("speed: fast")),
      AllOf(StartsWith("cell.yaml:7:"), HasSubstr("speed is something else"), HasSubstr("a whole number")));
}

TEST(PickAndPlaceFile, anUnknownKeyIsAnErrorThatListsTheKnownOnes) {
  EXPECT_THAT(errorOf(fileWith("sped: 5")),
              AllOf(StartsWith("cell.yaml:9: unknown key in a step"), HasSubstr("speed, accel_time")));
  EXPECT_THAT(errorOf("dwel: 3\nsteps: []\n"), AllOf(StartsWith("cell.yaml:1:"), HasSubstr("dwell, steps")));
  EXPECT_THAT(errorOf(fileWith("output: {module: EndModule, pin: 1, value: true}")),
              AllOf(StartsWith("cell.yaml:9: unknown key in output"), HasSubstr("module, output, value")));
}

TEST(PickAndPlaceFile, aKeyThatStandsTwiceIsAnError) {
  EXPECT_THAT(errorOf("dwell: 1\ndwell: 2\nsteps: []\n"),
              AllOf(StartsWith("cell.yaml:2:"), HasSubstr("twice")));
}

TEST(PickAndPlaceFile, aMissingKeyIsAnError) {
  EXPECT_THAT(errorOf("steps:\n  - movement_command: PTP\n"),
              AllOf(StartsWith("cell.yaml:2:"), HasSubstr("data_format is missing")));
  EXPECT_THAT(errorOf("dwell: 2\n"), HasSubstr("steps is missing"));
  EXPECT_THAT(errorOf(fileWith("output: {module: EndModule, value: true}")), HasSubstr("output is missing"));
}

TEST(PickAndPlaceFile, aValueOfTheWrongTypeIsAnError) {
  EXPECT_THAT(errorOf(fileWith("speed: 1.5")), HasSubstr("a whole number"));
  EXPECT_THAT(errorOf(fileWith("speed: [1]")), HasSubstr("speed is a list"));
  EXPECT_THAT(errorOf(fileWith("blending_enable: 2")), HasSubstr("true or false"));
  EXPECT_THAT(errorOf(fileWith("dwell: long")), HasSubstr("a number of seconds"));
  EXPECT_THAT(errorOf(fileWith("target_position: [1, 2, x, 4, 5, 6]")),
              HasSubstr("target_position[2] is something else"));
  EXPECT_THAT(errorOf(fileWith("target_position: [1, 2, 3]")),
              HasSubstr("a list of 3; it must be a list of 6"));
  EXPECT_THAT(errorOf(fileWith("target_position: 7")), HasSubstr("target_position is something else"));
  EXPECT_THAT(errorOf(fileWith("speed:")), HasSubstr("speed is empty"));
  EXPECT_THAT(errorOf(fileWith("name: {}")), HasSubstr("name is a map"));
  EXPECT_THAT(errorOf("steps: 5\n"), HasSubstr("it must be a list"));
  EXPECT_THAT(errorOf("steps: [5]\n"), HasSubstr("a step is something else"));
}

TEST(PickAndPlaceFile, anEnumerationIsGivenByName) {
  EXPECT_THAT(errorOf(fileWith("movement_command: 1")),
              AllOf(HasSubstr("movement_command is something else"), HasSubstr("LINE, PTP")));
  EXPECT_THAT(errorOf(fileWith("data_format: cpp")), HasSubstr("one of: CPP, CPR, CAP, CAR")) << "of a line";
  EXPECT_THAT(errorOf(fileWith("robot_pose: [ABOVE, ABOVE, FLIP]")),
              AllOf(HasSubstr("robot_pose[0] is something else"), HasSubstr("RIGHTY, LEFTY")));
}

TEST(PickAndPlaceFile, aTextThatIsNoYamlIsAnErrorWithItsLine) {
  EXPECT_THAT(errorOf("steps:\n  - [1, 2\n"), StartsWith("cell.yaml:"));
  EXPECT_THAT(errorOf(""), HasSubstr("the file is empty"));
  EXPECT_THAT(errorOf("\x01\x02\xff"), StartsWith("cell.yaml"));
}

TEST(PickAndPlaceFile, aListWithoutStepsIsReadAndLeftToTheBlockToRefuse) {
  const auto steps = parsePickAndPlace("steps: []\n", "cell.yaml");
  ASSERT_TRUE(steps) << steps.error();
  EXPECT_TRUE(steps->empty());
}

/// The fields of a faulty file that an error must never show.
TEST(PickAndPlaceFile, anErrorNeverShowsWhatStandsInTheFile) {
  const std::string secret = "hunter2";
  for (const std::string& text :
       {secret, "root:x:0:0:" + secret, secret + ": 1\nsteps: []\n", "steps: " + secret,
        "steps: [" + secret + "]", fileWith("speed: " + secret), fileWith("data_format: " + secret),
        fileWith(secret + ": 1"), fileWith("output: {" + secret + ": 1}"),
        fileWith("robot_pose: [" + secret + ", ABOVE, FLIP]"), "*" + secret,
        "&" + secret + " &" + secret + " 1", "\"\\" + secret + "\"", "%YAML " + secret, "!<" + secret,
        "steps:\n\t" + secret + ": [", fileWith("name: [" + secret)}) {
    EXPECT_THAT(errorOf(text), AllOf(StartsWith("cell.yaml"), Not(HasSubstr(secret)))) << text;
  }
}

TEST(PickAndPlaceFile, anErrorIsShortWhateverTheFileIs) {
  for (const std::string& text :
       {std::string(1000000, 'x'), std::string(1000000, '['), std::string(100000, '-') + " ",
        std::string(1000000, '{'), "steps: " + std::string(500000, '['),
        fileWith("speed: " + std::string(1000000, '9')), std::string(1000000, '\0'),
        std::string("\x7F\x45\x4C\x46\x02\x01\x01")}) {
    EXPECT_LT(errorOf(text).size(), 1000U);
  }
}

TEST(PickAndPlaceFile, aliasesMakeNoLongListsOfAShortFile) {
  std::string bomb = "a: &a [x, x, x, x, x, x, x, x, x]\n";
  for (char c = 'b'; c <= 'z'; ++c) {
    bomb += fmt::format("{0}: &{0} [*{1}, *{1}, *{1}, *{1}, *{1}, *{1}, *{1}, *{1}, *{1}]\n", c, char(c - 1));
  }
  EXPECT_THAT(errorOf(bomb + "steps: *z\n"), HasSubstr("unknown key"));
  std::string many =
      "steps:\n  - &a {movement_command: LINE, data_format: CAP, target_position: [1, 2, 3, 4, 5, 6], "
      "speed: 1, accel_time: 1}\n";
  for (int i = 0; i < 2000; ++i) many += "  - *a\n";
  EXPECT_THAT(errorOf(many), HasSubstr("steps is a list of 2001"));
}

TEST(PickAndPlaceFile, hasAsManyStepsAsAGoalMayHaveAndNoMore) {
  std::string file =
      "steps:\n  - &a {movement_command: LINE, data_format: CAP, target_position: [1, 2, 3, 4, 5, 6], "
      "speed: 1, accel_time: 1}\n";
  for (std::size_t i = 1; i < blocks::PickAndPlaceGoal::kMostSteps; ++i) file += "  - *a\n";
  EXPECT_EQ(errorOf(file), "no error");
  EXPECT_THAT(errorOf(file + "  - *a\n"), HasSubstr("steps is a list of 51; it must have 1..50 steps"));
}

std::string locationError(const std::string& location) {
  const auto steps = readPickAndPlaceFile(location);
  return steps ? "no error" : steps.error();
}

/// A folder that is gone at the end.
class Folder {
 public:
  Folder() : path_(std::filesystem::temp_directory_path() / fmt::format("steps_{}", getpid())) {
    std::filesystem::create_directory(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
    return path_ / name;
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

TEST(PickAndPlaceFile, aLocationThatIsNoneIsNamed) {
  EXPECT_THAT(locationError("cell.yaml"), HasSubstr("an absolute path, or package://"));
  EXPECT_THAT(locationError("package://no_such_package_at_all/a.yaml"),
              HasSubstr("package 'no_such_package_at_all' is not found"));
  EXPECT_THAT(locationError("package://"), HasSubstr("package '' is not found"));
  EXPECT_THAT(locationError("package://roscpp"), HasSubstr("the path in the package is missing"));
  EXPECT_THAT(locationError("package://roscpp/no/such.yaml"), HasSubstr("there is no such file"));
  EXPECT_THAT(locationError(std::string("/etc/passwd\0.yaml", 17)), HasSubstr("a path must not contain NUL"));
  EXPECT_LT(locationError("/" + std::string(1000000, 'x')).size(), 1000U);
  EXPECT_THAT(locationError("/\xFF\n"), HasSubstr("/\\xFF\\n: there is no such file"));
}

TEST(PickAndPlaceFile, aPathInAPackageStaysInIt) {
  for (const char* location :
       {"package://roscpp/../../../etc/passwd", "package://roscpp/..", "package://roscpp//etc/passwd",
        "package://roscpp/a/../../x.yaml", "package://roscpp/./../x.yaml"}) {
    EXPECT_THAT(locationError(location), HasSubstr("leads out of the package; give an absolute path"))
        << location;
  }
  for (const char* location :
       {"package://roscpp/a/../x.yaml", "package://roscpp/..x.yaml", "package://roscpp/./x.yaml"}) {
    EXPECT_THAT(locationError(location), HasSubstr("there is no such file")) << location;
  }
}

TEST(PickAndPlaceFile, packagesAreFoundByManyThreadsAtOnce) {
  constexpr int kThreads = 8;
  std::vector<std::future<std::string>> errors;
  for (int i = 0; i < kThreads; ++i) {
    errors.push_back(std::async(std::launch::async, [i] {
      return locationError(i % 2 == 0 ? "package://roscpp/no/such.yaml" : "package://no_such_package/a.yaml");
    }));
  }
  for (int i = 0; i < kThreads; ++i) {
    EXPECT_THAT(errors[static_cast<std::size_t>(i)].get(),
                HasSubstr(i % 2 == 0 ? "there is no such file" : "is not found"));
  }
}

TEST(PickAndPlaceFile, whatIsWrongWithALocationIsNotToldOnStandardErrorBesides) {
  ::testing::internal::CaptureStderr();
  const std::string error = locationError("package://no_such_package_at_all/a.yaml");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_THAT(error, HasSubstr("is not found"));
}

TEST(PickAndPlaceFile, whatIsNoRegularFileIsRefusedByItsKindAndNeverOpened) {
  const Folder folder;
  const auto fifo = folder.path() / "fifo";
  const auto dangling = folder.path() / "dangling";
  ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
  std::filesystem::create_symlink(folder.path() / "gone", dangling);
  EXPECT_THAT(locationError(folder.path() / "gone"), HasSubstr("gone: there is no such file"));
  EXPECT_THAT(locationError(folder.path()), HasSubstr("it is a folder"));
  EXPECT_THAT(locationError(fifo), HasSubstr("it is a FIFO"));
  EXPECT_THAT(locationError(dangling), HasSubstr("a link to a file that does not exist"));
  EXPECT_THAT(locationError("/dev/zero"), HasSubstr("it is a device"));
  EXPECT_THAT(locationError(folder.file("plain", "") + "/below"), HasSubstr("it cannot be read"));
}

TEST(PickAndPlaceFile, aFileWhoseReadFailsIsRefused) {
  EXPECT_THAT(locationError("/proc/self/mem"), HasSubstr("/proc/self/mem: it cannot be read"));
}

TEST(PickAndPlaceFile, aFileWithoutPermissionIsRefused) {
  const Folder folder;
  const std::string file = folder.file("closed.yaml", "steps: []\n");
  std::filesystem::permissions(file, std::filesystem::perms::none);
  if (geteuid() == 0) GTEST_SKIP() << "root may read all";
  EXPECT_THAT(locationError(file), HasSubstr("it cannot be read: Permission denied"));
}

TEST(PickAndPlaceFile, moreThanAMebibyteIsNotRead) {
  const Folder folder;
  EXPECT_THAT(locationError(folder.file("large.yaml", std::string((1 << 20) + 1, '#'))),
              HasSubstr("it is larger than 1048576 bytes"));
  const std::string sparse = folder.file("sparse.yaml", "");
  std::filesystem::resize_file(sparse, std::uintmax_t{1} << 30);
  EXPECT_THAT(locationError(sparse), HasSubstr("it is larger than"));
  // It says that it is empty, and has gigabytes, for who reads in whole entries.
  EXPECT_THAT(locationError("/proc/self/pagemap"), HasSubstr("it cannot be read"));
  EXPECT_THAT(locationError(folder.file("largest.yaml", "steps: []\n#" + std::string((1 << 20) - 11, '#'))),
              HasSubstr("no error"));
}

}  // namespace
}  // namespace cobot_command::ros_adapter
