// Programs as integrators write them, of several modules, with their signal files: they check clean.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "checked_text.h"
#include "source_tree.h"
#include <gmock/gmock.h>

#include "cobot_command/rapid/checks/signal_file.h"

namespace cobot_command::rapid {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::NotNull;

std::string contentOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// The signals of a file; `without`: a name that is left out.
std::vector<Signal> signalsOf(const std::filesystem::path& path, const std::string& without = "") {
  auto signals = readSignalFile(contentOf(path));
  EXPECT_TRUE(signals) << path << (signals ? "" : signals.error().text);
  if (!signals) return {};
  signals->erase(std::remove_if(signals->begin(), signals->end(),
                                [&](const Signal& signal) { return signal.name == without; }),
                 signals->end());
  return *std::move(signals);
}

/// "E401 3:5" of each finding of a program: of a signal file and the modules whose names begin as its own.
std::vector<std::string> findingsOf(const std::filesystem::path& signal_file,
                                    const std::string& without = "") {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(signal_file.parent_path())) {
    const std::string name = entry.path().filename();
    const bool is_module =
        entry.path().extension() == ".mod" && name.rfind(signal_file.stem().string(), 0) == 0;
    if (is_module) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<CheckedFile> files;
  for (const auto& path : paths) {
    files.push_back({path.filename(), std::make_shared<const Source>(readSource(contentOf(path)))});
  }
  CheckOptions options;
  options.signals = signalsOf(signal_file, without);
  const CheckedProgram checked = check(files, options);
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < files.size(); ++i) {
    for (std::string& line : idsAndPlaces(*files[i].source, checked.findings[i])) {
      lines.push_back(files.size() == 1 ? line : files[i].name + " " + line);
    }
  }
  return lines;
}

TEST(RapidPrograms, checkClean) {
  int programs = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(test_support::inSourceTree("test/data/rapid/programs"))) {
    if (entry.path().extension() != ".yaml") continue;
    EXPECT_THAT(findingsOf(entry.path()), IsEmpty()) << entry.path();
    ++programs;
  }
  EXPECT_EQ(programs, 5);
}

TEST(RapidPrograms, ofRobotAHasOldConfigurationsAndNoOtherFinding) {
  const auto file = test_support::inSourceTree("config/rapid/robot_a.yaml");
  EXPECT_THAT(findingsOf(file), ElementsAre("W322 14:20", "W322 18:19", "W322 22:20", "W322 26:20"));
}

TEST(RapidPrograms, ofRobotAMissesItsSemaphoreWhereItIsUsed) {
  const auto all = findingsOf(test_support::inSourceTree("config/rapid/robot_a.yaml"), "O_Semaphore");
  std::vector<std::string> ids;
  for (const std::string& line : all) ids.push_back(line.substr(0, 4));
  EXPECT_THAT(ids, ElementsAre("W322", "W322", "W322", "W322", "E419", "E419", "E419"));
}

}  // namespace
}  // namespace cobot_command::rapid
