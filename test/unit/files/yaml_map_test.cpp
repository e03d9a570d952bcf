#include "cobot_command/files/yaml_map.h"

#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

namespace cobot_command::files {
namespace {

using ::testing::HasSubstr;

const std::vector<std::string> kKeys{"speed", "time"};

FileFault faultIn(const std::string& text, const std::function<void(const YamlMap&)>& use) {
  const auto read = tryYaml<int>(text, "a.yaml", [&use](const YAML::Node& node) {
    use(YamlMap(node, "the file", kKeys));
    return 0;
  });
  return read ? FileFault{} : read.error();
}
FileFault faultIn(const std::string& text) {
  return faultIn(text, [](const YamlMap&) {});
}

TEST(YamlMap, namesBothLinesOfAKeyThatStandsTwice) {
  const FileFault fault = faultIn("speed: 1\ntime: 2\nspeed: 3\n");
  EXPECT_EQ(describe(fault), "a.yaml:3: speed is twice in the file, first in line 1");
  EXPECT_EQ(fault.finding.field, "speed");
}

TEST(YamlMap, tellsWhichKeyAnUnknownOneMayHaveBeen) {
  const FileFault fault = faultIn("speeed: 1\n");
  EXPECT_EQ(describe(fault), "a.yaml:1: unknown key in the file; known: speed, time");
  EXPECT_EQ(fault.finding.field, "speeed");
  EXPECT_EQ(fault.finding.advice, "write speed");
  EXPECT_EQ(fault.finding.allowed, "speed, time");
  EXPECT_EQ(faultIn("colour: 1\n").finding.advice, "");
  EXPECT_EQ(faultIn("? [1]\n: 1\n").finding.field, "a list");
}

TEST(YamlMap, tellsWhatStandsInPlaceOfANumber) {
  const auto number = [](const YamlMap& map) { static_cast<void>(map.number("speed")); };
  EXPECT_EQ(faultIn("speed: fast\n", number).finding.found, "is \"fast\"");
  EXPECT_EQ(faultIn("speed: [1, 2]\n", number).finding.found, "is a list of 2");
  EXPECT_EQ(faultIn("speed:\n", number).finding.found, "is empty");
  EXPECT_EQ(faultIn("time: 1\n", number).finding.found, "is missing");
  for (const char* none : {".inf", "inf", "nan", ".nan", "1e999", "1,5", "0x"}) {
    EXPECT_EQ(faultIn(std::string("speed: \"") + none + "\"\n", number).finding.allowed, "a number") << none;
  }
}

/// To some programs 010 is 8.
TEST(YamlMap, refusesANumberWithALeadingZero) {
  const auto number = [](const YamlMap& map) { static_cast<void>(map.number("speed")); };
  const auto whole = [](const YamlMap& map) { static_cast<void>(map.whole("speed")); };
  for (const char* text : {"010", "060", "-01", "+07", "00", "030.5", "08"}) {
    const std::string file = std::string("speed: ") + text + "\n";
    EXPECT_EQ(faultIn(file, whole).what, "speed has a leading zero; it must be a whole number without one")
        << text;
    EXPECT_EQ(faultIn(file, number).what, "speed has a leading zero; it must be a number without one")
        << text;
  }
  const std::vector<std::pair<const char*, int>> plain{{"0", 0}, {"-0", 0}, {"10", 10}, {"0x10", 16}};
  for (const auto& [text, value] : plain) {
    const auto is_so = [expected = value](const YamlMap& map) { EXPECT_EQ(map.whole("speed"), expected); };
    EXPECT_EQ(faultIn(std::string("speed: ") + text + "\n", is_so).what, "") << text;
  }
  EXPECT_EQ(faultIn("speed: 0.5\n", [](const YamlMap& map) { EXPECT_EQ(map.number("speed"), 0.5); }).what,
            "");
}

TEST(YamlMap, refusesASecondDocument) {
  EXPECT_EQ(describe(faultIn("speed: 1\n---\nspeed: 2\n")),
            "a.yaml:2: a second document begins here; the file must have one");
  EXPECT_EQ(faultIn("---\nspeed: 1\n...\n").what, "");
}

TEST(YamlMap, readsWhatItsErrorsAreAbout) {
  EXPECT_EQ(faultIn("speed: 2.5\n", [](const YamlMap& map) { EXPECT_EQ(map.number("speed"), 2.5); }).what,
            "");
}

Given givenBy(const std::string& text) {
  return toGiven(YAML::Load(text));
}

TEST(YamlValue, isGivenAsItsType) {
  EXPECT_EQ(describe(givenBy("20")), "20");
  EXPECT_EQ(describe(givenBy("2.5")), "2.5");
  EXPECT_EQ(describe(givenBy("true")), "true");
  EXPECT_EQ(describe(givenBy("auto")), "the text \"auto\"");
  EXPECT_EQ(describe(givenBy("\"20\"")), "the text \"20\"") << "in quotes";
  EXPECT_EQ(describe(givenBy("[1, 2]")), "a list of 2");
  EXPECT_EQ(describe(givenBy("{a: 1}")), "a map");
  EXPECT_EQ(describe(givenBy("")), "nothing");
  EXPECT_EQ(describe(givenBy("020")), "20.0") << "and not 16";
}

TEST(YamlMap, ofNamesIsRefusedWhereOneStandsTwice) {
  const auto read = tryYaml<int>("a: 1\nb: 2\na: 3\n", "a.yaml", [](const YAML::Node& node) {
    requireOwnKeys(node, "stations");
    return 0;
  });
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().line, 3);
  EXPECT_THAT(read.error().finding.found, HasSubstr("twice in stations, first in line 1"));
}

}  // namespace
}  // namespace cobot_command::files
