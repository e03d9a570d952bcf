#include "cobot_command/protocol/item_content.h"

#include <cmath>
#include <cstring>
#include <limits>

#include <gmock/gmock.h>

namespace cobot_command::protocol {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using namespace std::string_literals;
using Floats = std::vector<float>;
using Strings = std::vector<std::string>;

constexpr ItemFormat kFormats[] = {ItemFormat::Binary, ItemFormat::String, ItemFormat::Json};

struct Named {
  std::string name;
  ItemValue value;
};

std::string content(ItemFormat format, const std::vector<Named>& values) {
  std::vector<StatusItem> items;
  for (const Named& named : values) items.push_back({named.name, encodeValue(format, named.value)});
  return encodeItems(format, items);
}

TEST(ItemContent, isWrittenAsInTheManualsFrames) {
  const std::vector<Named> values{{"Robot_Link", std::uint8_t{0}},
                                  {"TCP_Value", Floats{1, 1, 1, 0.1F, 0.2F, 0.1F}},
                                  {"Ctrl_DO0", std::uint8_t{1}},
                                  {"g_ss", Strings{"Hi", "TM", "Robot"}}};
  EXPECT_EQ(content(ItemFormat::String, values),
            "Robot_Link=0\r\nTCP_Value={1,1,1,0.1,0.2,0.1}\r\nCtrl_DO0=1\r\ng_ss={\"Hi\",\"TM\",\"Robot\"}");
  EXPECT_EQ(content(ItemFormat::Json, values),
            R"([{"Item":"Robot_Link","Value":0},{"Item":"TCP_Value","Value":[1.0,1.0,1.0,0.1,0.2,0.1]},)"
            R"({"Item":"Ctrl_DO0","Value":1},{"Item":"g_ss","Value":["Hi","TM","Robot"]}])");
  EXPECT_EQ(content(ItemFormat::Binary, {{"g_ss", Strings{"Hello", "World"}}}),
            "\x04\0g_ss\x0C\0Hello\0\0World"s);
}

TEST(ItemContent, isTheSameInBinaryItemByItem) {
  const std::vector<Named> values{{"bit", true},
                                  {"byte", std::uint8_t{200}},
                                  {"number", std::int32_t{-5}},
                                  {"real", 0.1F},
                                  {"double", 0.1},
                                  {"text", "Hello"s},
                                  {"bits", std::vector<bool>{true, false}},
                                  {"bytes", std::vector<std::uint8_t>{1, 2, 3}},
                                  {"numbers", std::vector<std::int32_t>{-1, 70000}},
                                  {"reals", Floats{1, -0.1F}},
                                  {"doubles", std::vector<double>{1, -0.1}},
                                  {"texts", Strings{"Hi", "", "TM"}},
                                  {"none", Floats{}}};
  std::string appended;
  for (const Named& named : values) EXPECT_TRUE(appendBinaryItem(appended, named.name, named.value));
  EXPECT_EQ(appended, content(ItemFormat::Binary, values));
}

TEST(ItemContent, leavesOutWhatBinaryCannotSay) {
  std::string appended;
  EXPECT_TRUE(appendBinaryItem(appended, "longest", std::string(kMaxItemBytes, 'x')));
  const std::string before = appended;
  EXPECT_FALSE(appendBinaryItem(appended, "longer", std::string(kMaxItemBytes + 1, 'x')));
  EXPECT_EQ(appended, before);
}

TEST(ItemContent, hasTheDigitsOfACapturedController) {
  // From a real robot: Coord_Robot_Tool, and texts of public drivers' logs.
  for (const char* digits : {"-179.400269", "343.784576", "224.894272", "-158.372284", "-9.714196",
                             "-122.428917", "125.000435", "-1.29178234E-05"}) {
    const auto value = parseValue(ItemFormat::String, digits, 0.0F);
    ASSERT_TRUE(value) << digits;
    EXPECT_EQ(encodeValue(ItemFormat::String, *value), digits);
    EXPECT_EQ(encodeValue(ItemFormat::Json, *value), digits);
  }
}

TEST(ItemContent, hasSevenDigitsOfAFloatWhereTheseMakeTheSameElseNine) {
  const std::vector<std::pair<float, std::string>> written = {{0.1F, "0.1"},
                                                              {0.0001F, "0.0001"},
                                                              {0.00001F, "1E-05"},
                                                              {16777216.F, "16777216"},
                                                              {1234567.F, "1234567"},
                                                              {12345678.F, "12345678"},
                                                              {1e7F, "1E+07"},
                                                              {3.4028235e38F, "3.40282347E+38"},
                                                              {1.17549435e-38F, "1.17549435E-38"},
                                                              {1.F / 3, "0.333333343"},
                                                              {-0.F, "0"},
                                                              {-2.5F, "-2.5"}};
  for (const auto& [value, text] : written) {
    EXPECT_EQ(encodeValue(ItemFormat::String, value), text);
    const bool is_whole = text.find_first_of(".E") == std::string::npos;
    EXPECT_EQ(encodeValue(ItemFormat::Json, value), is_whole ? text + ".0" : text);
  }
  EXPECT_EQ(encodeValue(ItemFormat::Json, std::numeric_limits<float>::quiet_NaN()), "null");
}

TEST(ItemContent, hasFifteenDigitsOfADoubleWhereTheseMakeTheSameElseSeventeen) {
  EXPECT_EQ(encodeValue(ItemFormat::Json, 0.1), "0.1");
  EXPECT_EQ(encodeValue(ItemFormat::Json, 90.0), "90.0");
  EXPECT_EQ(encodeValue(ItemFormat::String, 1.0 / 3), "0.33333333333333331");
}

TEST(ItemContent, ofAnyFloatIsReadAsTheSame) {
  std::uint32_t bits = 1;
  for (int i = 0; i < 20000; ++i) {
    bits = bits * 1664525U + 1013904223U;
    float value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value)) continue;
    for (const ItemFormat format : {ItemFormat::String, ItemFormat::Json}) {
      EXPECT_EQ(parseValue(format, encodeValue(format, value), 0.0F), ItemValue(value)) << bits;
    }
  }
}

TEST(ItemContent, isReadAsWhatItWasWrittenAs) {
  const std::vector<ItemValue> values{true,
                                      std::uint8_t{200},
                                      std::numeric_limits<std::int32_t>::min(),
                                      -1.29178234E-05F,
                                      0.1,
                                      "a \"quoted\" text,\r\nof {two} lines, \xC3\xA4"s,
                                      ""s,
                                      std::vector<bool>{true, false},
                                      std::vector<std::uint8_t>{0, 255},
                                      std::vector<std::int32_t>{-1, 1},
                                      Floats{417.5F, 1e30F},
                                      std::vector<double>{1e300},
                                      Strings{"a,b", "}\"{", "\r\n"}};
  for (const ItemFormat format : kFormats) {
    for (const ItemValue& value : values) {
      const std::string all = content(format, {{"First", value}, {"Second", std::int32_t{7}}});
      const auto items = parseItems(format, all);
      ASSERT_TRUE(items) << all << ": " << items.error().message;
      ASSERT_EQ(items->size(), 2U) << all;
      EXPECT_EQ(items->at(0).name, "First");
      EXPECT_EQ(parseValue(format, items->at(0).value, value), value) << all;
      EXPECT_EQ(parseValue(format, items->at(1).value, std::int32_t{}), ItemValue(std::int32_t{7})) << all;
    }
  }
}

TEST(ItemContent, readsNamesAlone) {
  EXPECT_THAT(parseItemNames(ItemFormat::Binary, "\x01\0A\x02\0Bc"s).value(), ElementsAre("A", "Bc"));
  EXPECT_THAT(parseItemNames(ItemFormat::String, "A\r\nBc").value(), ElementsAre("A", "Bc"));
  EXPECT_THAT(parseItemNames(ItemFormat::String, "A\r\n").value(), ElementsAre("A"));
  EXPECT_THAT(parseItemNames(ItemFormat::Json, R"([ {"Item":"A"}, {"Item":"Bc"} ])").value(),
              ElementsAre("A", "Bc"));
}

TEST(ItemContent, readsTheNamesThatARequestAsksFor) {
  const std::vector<std::string> names = {"Robot_Model", "ControlBox_SN"};
  EXPECT_EQ(parseItemNames(ItemFormat::Binary, encodeBinaryNames(names)).value(), names);
}

TEST(ItemContent, ofAnotherFormatIsRefused) {
  for (const ItemFormat format : kFormats) {
    EXPECT_FALSE(parseItems(format, ""));
    EXPECT_FALSE(parseItemNames(format, ""));
    EXPECT_FALSE(parseItems(format, "[{}]"));
  }
  for (const char* text : {"Ctrl_DO0", "=1", "A=1\r\nB", "\r\n"}) {
    EXPECT_FALSE(parseItems(ItemFormat::String, text));
  }
  for (const char* text :
       {"Ctrl_DO0=1", "{}", "[]", "[1]", "[{}]", R"([{"Item":7,"Value":1}])", R"([{"Item":"A"}])",
        R"([{"Item":"","Value":1}])", R"([{"Item":"A","Value":[[1]]}])", "[{\"Item\":\"\xFF\"}]",
        R"([{"Item":"A","Value":1})"}) {
    EXPECT_FALSE(parseItems(ItemFormat::Json, text)) << text;
  }
  EXPECT_FALSE(parseItemNames(ItemFormat::Binary, "\x05\0abc"s));
  EXPECT_FALSE(parseItemNames(ItemFormat::Binary, "\0\0"s));
  EXPECT_THAT(parseItems(ItemFormat::String, "A=1\r\nB").error().message, HasSubstr("line 2"));
}

TEST(ItemContent, isBounded) {
  EXPECT_FALSE(parseItems(ItemFormat::Json, std::string(1000000, '[')));
  std::vector<Named> many(kMaxRequestedItems, {"A", std::int32_t{1}});
  for (const ItemFormat format : kFormats) EXPECT_TRUE(parseItems(format, content(format, many)));
  many.push_back({"A", std::int32_t{1}});
  for (const ItemFormat format : kFormats) {
    EXPECT_THAT(parseItems(format, content(format, many)).error().message, HasSubstr("at most 1024"));
  }
}

TEST(ItemValueText, ofAnotherTypeIsNoValue) {
  for (const ItemFormat format : {ItemFormat::String, ItemFormat::Json}) {
    for (const char* text :
         {"\"on\"", "256", "-1", "1.5", "{1,2}", "[1,2]", "", "x", "true", "null", "1,2", "{}"}) {
      EXPECT_FALSE(parseValue(format, text, std::uint8_t{})) << text;
    }
    for (const char* text : {"1e39", "\"1\"", "nan", "1,5", "+1", "\"", "{1}"}) {
      EXPECT_FALSE(parseValue(format, text, 0.0F)) << text;
    }
    for (const char* text : {"2", "1.0", "True", "\"true\""}) {
      EXPECT_FALSE(parseValue(format, text, false)) << text;
    }
    for (const char* text : {"2147483648", "5.0"}) {
      EXPECT_FALSE(parseValue(format, text, std::int32_t{})) << text;
    }
    for (const char* text : {"1", "x", "\"a\"b\"", "\"\xFF\""}) {
      EXPECT_FALSE(parseValue(format, text, ""s)) << text;
    }
  }
  for (const char* text : {"{1,}", "{,1}", "{1 2}", "{1", "{{1}}", "1"}) {
    EXPECT_FALSE(parseValue(ItemFormat::String, text, std::vector<std::int32_t>{})) << text;
  }
}

TEST(ItemValueText, takesBoolsAsBitsAndFloatsAsIntegers) {
  for (const ItemFormat format : {ItemFormat::String, ItemFormat::Json}) {
    EXPECT_EQ(parseValue(format, "1", false), ItemValue(true));
    EXPECT_EQ(parseValue(format, "false", true), ItemValue(false));
    EXPECT_EQ(parseValue(format, "2", 0.0F), ItemValue(2.0F));
  }
  EXPECT_EQ(parseValue(ItemFormat::String, "{ 1, 2.5 }", Floats{}), ItemValue(Floats{1, 2.5F}));
  EXPECT_EQ(parseValue(ItemFormat::String, "{}", Floats{1}), ItemValue(Floats{}));
}

TEST(ItemValueBytes, ofAnotherSizeAreNoValue) {
  EXPECT_FALSE(parseValue(ItemFormat::Binary, "\1\0\0\0"s, std::uint8_t{}));
  EXPECT_FALSE(parseValue(ItemFormat::Binary, "", true));
  EXPECT_FALSE(parseValue(ItemFormat::Binary, "\1\0\0"s, std::int32_t{}));
  EXPECT_FALSE(parseValue(ItemFormat::Binary, "\1\0\0\0\1"s, std::vector<std::int32_t>{}));
  EXPECT_FALSE(parseValue(ItemFormat::Binary, "\0\0\xC0\x7F"s, 0.0F));  // not a number
}

TEST(ItemValue, knowsHowManyElementsItHas) {
  EXPECT_EQ(elementCount(std::int32_t{3}), 1U);
  EXPECT_EQ(elementCount("text"s), 1U);
  EXPECT_EQ(elementCount(Floats{1, 2, 3}), 3U);
}

}  // namespace
}  // namespace cobot_command::protocol
