#include "pick_and_place_file.h"

#include <fstream>
#include <sstream>

#include "source_tree.h"
#include <gmock/gmock.h>

namespace cobot_command::ros_adapter {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

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
  EXPECT_TRUE(above.move.precise_positioning);
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
  EXPECT_THAT(errorOf(fileWith("exit_node: perhaps")), HasSubstr("exit_node is 'perhaps'"));
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
  EXPECT_FALSE(stepWith("precise_positioning: false").move.precise_positioning);
  EXPECT_THAT(stepWith("robot_pose: [LEFTY, BELOW, FLIP]").move.robot_pose, ElementsAre(1, 3, 5));
}

TEST(PickAndPlaceFile, anErrorNamesTheFileAndTheLine) {
  EXPECT_THAT(errorOf(fileWith("speed: fast")),
              AllOf(StartsWith("cell.yaml:7:"), HasSubstr("speed is 'fast'"), HasSubstr("a whole number")));
}

TEST(PickAndPlaceFile, anUnknownKeyIsAnErrorThatListsTheKnownOnes) {
  EXPECT_THAT(errorOf(fileWith("sped: 5")),
              AllOf(StartsWith("cell.yaml:9:"), HasSubstr("'sped'"), HasSubstr("speed, accel_time")));
  EXPECT_THAT(errorOf("dwel: 3\nsteps: []\n"), AllOf(StartsWith("cell.yaml:1:"), HasSubstr("dwell, steps")));
  EXPECT_THAT(errorOf(fileWith("output: {module: EndModule, pin: 1, value: true}")), HasSubstr("'pin'"));
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
              HasSubstr("target_position[2] is 'x'"));
  EXPECT_THAT(errorOf(fileWith("target_position: [1, 2, 3]")),
              HasSubstr("a list of 3; it must be a list of 6"));
  EXPECT_THAT(errorOf(fileWith("target_position: 7")), HasSubstr("target_position is '7'"));
  EXPECT_THAT(errorOf(fileWith("speed:")), HasSubstr("speed is nothing"));
  EXPECT_THAT(errorOf(fileWith("name: {}")), HasSubstr("name is a map"));
  EXPECT_THAT(errorOf("steps: 5\n"), HasSubstr("it must be a list"));
  EXPECT_THAT(errorOf("steps: [5]\n"), HasSubstr("a step is '5'"));
}

TEST(PickAndPlaceFile, anEnumerationIsGivenByName) {
  EXPECT_THAT(errorOf(fileWith("movement_command: 1")),
              AllOf(HasSubstr("movement_command is '1'"), HasSubstr("LINE, PTP")));
  EXPECT_THAT(errorOf(fileWith("data_format: cpp")), HasSubstr("JPP, CPP, CPR, CAP, CAR"));
  EXPECT_THAT(errorOf(fileWith("robot_pose: [ABOVE, ABOVE, FLIP]")),
              AllOf(HasSubstr("robot_pose[0] is 'ABOVE'"), HasSubstr("RIGHTY, LEFTY")));
}

TEST(PickAndPlaceFile, aTextThatIsNoYamlIsAnErrorWithItsLine) {
  EXPECT_THAT(errorOf("steps:\n  - [1, 2\n"), StartsWith("cell.yaml:"));
  EXPECT_THAT(errorOf(""), HasSubstr("the file is nothing"));
  EXPECT_THAT(errorOf("\x01\x02\xff"), StartsWith("cell.yaml"));
}

TEST(PickAndPlaceFile, aListWithoutStepsIsReadAndLeftToTheBlockToRefuse) {
  const auto steps = parsePickAndPlace("steps: []\n", "cell.yaml");
  ASSERT_TRUE(steps) << steps.error();
  EXPECT_TRUE(steps->empty());
}

std::string locationError(const std::string& location) {
  const auto steps = readPickAndPlaceFile(location);
  return steps ? "no error" : steps.error();
}

TEST(PickAndPlaceFile, aLocationThatIsNoFileIsNamed) {
  EXPECT_THAT(locationError("/no/such.yaml"), HasSubstr("/no/such.yaml: there is no such file"));
  EXPECT_THAT(locationError("/dev/zero"), HasSubstr("no such file"));
  EXPECT_THAT(locationError("cell.yaml"), HasSubstr("an absolute path, or package://"));
  EXPECT_THAT(locationError("package://no_such_package_at_all/a.yaml"),
              HasSubstr("no package 'no_such_package_at_all'"));
  EXPECT_THAT(locationError("package://"), HasSubstr("no package ''"));
}

}  // namespace
}  // namespace cobot_command::ros_adapter
