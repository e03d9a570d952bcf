// The fixtures of test/data/rapid, as far as they need no check and no run.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "source_tree.h"
#include "tree_text.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "cobot_command/rapid/source/printer.h"
#include "cobot_command/rapid/types/predefined.h"

namespace cobot_command::rapid {
namespace {

using ::testing::ElementsAreArray;
using ::testing::IsEmpty;

const std::string kFixtures = "test/data/rapid/";

/// `path`: from the root of the sources.
std::string bytesOf(const std::string& path) {
  std::ifstream file(test_support::inSourceTree(path), std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string contentOf(const std::string& name) {
  return bytesOf(kFixtures + name);
}

nlohmann::json fixture(const std::string& name) {
  return nlohmann::json::parse(contentOf(name + ".json"));
}

/// "error E201 12:12"
std::vector<std::string> diagnosticsOf(const nlohmann::json& fixture) {
  std::vector<std::string> lines;
  for (const auto& row : fixture.at("diagnostics")) {
    lines.push_back(fmt::format("{} {} {}:{}", row.at("severity").get<std::string>(),
                                row.at("id").get<std::string>(), row.at("line").get<int>(),
                                row.at("column").get<int>()));
  }
  return lines;
}

std::vector<std::string> diagnosticsOf(const Source& source) {
  std::vector<std::string> lines;
  for (const Finding& finding : source.findings()) {
    const Place place = source.placeOf(finding.span.begin);
    lines.push_back(
        fmt::format("{} {} {}:{}", toString(finding.severity()), finding.id, place.line, place.column));
  }
  return lines;
}

/// Files of the fixtures that end so, in the order of their names.
std::vector<std::string> modules() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(test_support::inSourceTree(kFixtures))) {
    if (entry.path().extension() == ".mod") names.push_back(entry.path().filename());
  }
  std::sort(names.begin(), names.end());
  return names;
}

class RapidFixtures : public ::testing::TestWithParam<const char*> {};

TEST_P(RapidFixtures, haveExactlyTheirFindings) {
  const nlohmann::json expected = fixture(GetParam());
  const auto dialect = dialectNamed(expected.at("dialect").get<std::string>());
  ASSERT_TRUE(dialect);
  for (const auto& module : expected.at("modules")) {
    const Source source = readSource(contentOf(module.get<std::string>()), {*dialect});
    EXPECT_THAT(diagnosticsOf(source), ElementsAreArray(diagnosticsOf(expected)));
  }
}

INSTANTIATE_TEST_SUITE_P(OfReading, RapidFixtures,
                         ::testing::Values("01_lexical", "11_syntax_errors", "18_irc5", "18_s4c"));

TEST(RapidFormatFixture, isPrintedInCanonicalForm) {
  const nlohmann::json expected = fixture("16_format");
  const std::string output = contentOf(expected.at("output").get<std::string>());
  const Source input = readSource(contentOf(expected.at("modules").at(0).get<std::string>()));
  EXPECT_EQ(print(input, predefinedNames()), output);
  EXPECT_EQ(print(readSource(output), predefinedNames()), output);
}

TEST(RapidFormatFixture, hasTheTreeOfItsCanonicalForm) {
  const auto tree_of = [](const std::string& name) {
    const Source source = readSource(contentOf(name));
    return folded(treeText(source, Tree::kRoot));
  };
  EXPECT_EQ(tree_of("16_format_in.mod"), tree_of("16_format_out.mod"));
}

TEST(RapidFixtureModules, haveNoSyntaxErrorUnlessTheirFixtureSaysSo) {
  ASSERT_FALSE(modules().empty());
  for (const std::string& name : modules()) {
    const bool is_broken = name == "11_syntax_errors.mod";
    EXPECT_EQ(readSource(contentOf(name)).isBroken(), is_broken) << name;
  }
}

TEST(RapidFixtureModules, areTheSameAfterFormattingTwice) {
  for (const std::string& name : modules()) {
    const Source source = readSource(contentOf(name));
    if (source.isBroken()) continue;
    const std::string once = print(source, predefinedNames());
    const Source again = readSource(once);
    EXPECT_EQ(print(again, predefinedNames()), once) << name;
    EXPECT_THAT(tokenTexts(again), ElementsAreArray(tokenTexts(source))) << name;
  }
}

TEST(RapidFixtureModules, includeACatalogueThatCanBeRead) {
  const Source source = readSource(bytesOf("src/rapid/types/catalogue.rapid"), {Dialect::Irc5, false});
  EXPECT_THAT(source.findings(), IsEmpty());
}

}  // namespace
}  // namespace cobot_command::rapid
