// The findings of the fixtures of test/data/rapid: of all kinds, each must have its own and no other.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "checked_text.h"
#include "source_tree.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "cobot_command/rapid/checks/check.h"

namespace cobot_command::rapid {
namespace {

using ::testing::ElementsAreArray;

std::string pathOf(const std::string& name) {
  return test_support::inSourceTree("test/data/rapid/" + name);
}

std::string contentOf(const std::string& name) {
  std::ifstream file(pathOf(name), std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Those that need no arm, and are more than formatted.
std::vector<std::string> fixtures() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(pathOf(""))) {
    const std::string name = entry.path().stem();
    const bool is_other = name == "16_format" || name == "17_motion_checks";
    if (entry.path().extension() == ".json" && !is_other) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

SignalType signalType(const std::string& name) {
  for (const SignalType type :
       {SignalType::Di, SignalType::Do, SignalType::Gi, SignalType::Go, SignalType::Ai, SignalType::Ao}) {
    if (toString(type) == name) return type;
  }
  throw std::invalid_argument(name);
}

CheckOptions optionsOf(const nlohmann::json& fixture) {
  CheckOptions options;
  const auto signals = fixture.value("signals", nlohmann::json::object());
  for (const auto& [name, row] : signals.items()) {
    Signal signal;
    signal.name = name;
    signal.folded = folded(name);
    signal.type = signalType(row.at("type").get<std::string>());
    options.signals.push_back(std::move(signal));
  }
  return options;
}

/// "E201 12:12"
std::vector<std::string> expectedFindings(const nlohmann::json& fixture) {
  std::vector<std::string> lines;
  for (const auto& row : fixture.value("diagnostics", nlohmann::json::array())) {
    lines.push_back(row.at("id").get<std::string>() + " " + std::to_string(row.at("line").get<int>()) + ":" +
                    std::to_string(row.at("column").get<int>()));
  }
  return lines;
}

class RapidCheckedFixture : public ::testing::TestWithParam<std::string> {};

TEST_P(RapidCheckedFixture, hasExactlyItsFindings) {
  const auto fixture = nlohmann::json::parse(contentOf(GetParam() + ".json"));
  const auto dialect = dialectNamed(fixture.value("dialect", "irc5"));
  ASSERT_TRUE(dialect);
  std::vector<CheckedFile> files;
  for (const auto& module : fixture.at("modules")) {
    const auto name = module.get<std::string>();
    files.push_back({name, std::make_shared<const Source>(readSource(contentOf(name), {*dialect}))});
  }
  const CheckedProgram checked = check(files, optionsOf(fixture));
  std::vector<std::string> found;
  for (std::size_t i = 0; i < files.size(); ++i) {
    for (std::string& line : idsAndPlaces(*files[i].source, checked.findings[i])) {
      found.push_back(std::move(line));
    }
  }
  EXPECT_THAT(found, ElementsAreArray(expectedFindings(fixture)));
}

INSTANTIATE_TEST_SUITE_P(All, RapidCheckedFixture, ::testing::ValuesIn(fixtures()),
                         [](const auto& fixture) { return "f" + fixture.param; });

}  // namespace
}  // namespace cobot_command::rapid
