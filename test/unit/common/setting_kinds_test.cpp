// What each kind of setting takes, and what it says of all else.
#include "cobot_command/common/setting_kinds.h"

#include <limits>

#include <gmock/gmock.h>

#include "cobot_command/common/units.h"

namespace cobot_command::setting_kinds {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// "" when the value is taken.
std::string answer(const SettingKind& kind, const Given& given) {
  return kind.take(given).value_or("");
}

TEST(SettingKinds, areWholeNumbersOnlyForWholeOnes) {
  int value = 1;
  const SettingKind kind = port(value);
  EXPECT_EQ(answer(kind, {5890}), "");
  EXPECT_EQ(value, 5890);
  EXPECT_EQ(answer(kind, {5890.7}), "is 5890.7");
  EXPECT_EQ(answer(kind, {5890.0}), "is 5890.0");
  EXPECT_EQ(answer(kind, {65536}), "is 65536");
  EXPECT_EQ(answer(kind, {-1}), "is -1");
  EXPECT_EQ(answer(kind, {kNan}), "is nan");
  EXPECT_EQ(answer(kind, {true}), "is true");
  EXPECT_EQ(answer(kind, {"5890"}), "is the text \"5890\"");
  EXPECT_EQ(answer(kind, {""}), "is an empty text");
  EXPECT_EQ(answer(kind, {GivenList{{1}, {2}}}), "is a list of 2");
  EXPECT_EQ(answer(kind, {OtherKind{"a date"}}), "is a date");
  EXPECT_EQ(value, 5890) << "what is refused changes nothing";
  EXPECT_EQ(allowedBy(kind), "a whole number, 0 to 65535");
}

TEST(SettingKinds, areFiniteNumbersForRealOnes) {
  double value = 1;
  const SettingKind kind = real(value, 0.5, 100, "Hz");
  for (const Given& good : {Given{2}, Given{2.5}, Given{0.5}, Given{100.0}}) {
    EXPECT_EQ(answer(kind, good), "");
  }
  EXPECT_EQ(value, 100);
  for (const double bad : {kNan, kInfinity, -kInfinity, 0.4999, 100.001, 1e308, -0.0}) {
    EXPECT_THAT(answer(kind, {bad}), HasSubstr("is ")) << bad;
  }
  EXPECT_EQ(answer(kind, {false}), "is false");
  EXPECT_EQ(value, 100);
  EXPECT_EQ(allowedBy(kind), "a number, 0.5 to 100 Hz");
}

TEST(SettingKinds, areNumbersInTheUnitsOfPeople) {
  double radians = degToRad(180);
  const SettingKind kind = realIn(radians, 1, 360, "deg", radToDeg(1));
  EXPECT_EQ(kind.show(), "180");
  EXPECT_EQ(answer(kind, {90}), "");
  EXPECT_DOUBLE_EQ(radians, degToRad(90));
  EXPECT_EQ(answer(kind, {0.5}), "is 0.5");
  EXPECT_EQ(allowedBy(kind), "a number, 1 to 360 deg");
}

TEST(SettingKinds, areDurationsInSecondsOrMilliseconds) {
  Duration value{};
  const SettingKind kind = seconds(value, 0.001, 60);
  EXPECT_EQ(answer(kind, {1.5}), "");
  EXPECT_EQ(value, 1500ms);
  EXPECT_EQ(kind.show(), "1.5");
  EXPECT_EQ(answer(kind, {60.1}), "is 60.1");
  EXPECT_EQ(answer(kind, {kNan}), "is nan");
  EXPECT_EQ(answer(kind, {"1.5"}), "is the text \"1.5\"");
  const SettingKind in_ms = kind.in_milliseconds();
  EXPECT_EQ(answer(in_ms, {15}), "");
  EXPECT_EQ(value, 15ms);
  EXPECT_EQ(in_ms.show(), "15");
  EXPECT_EQ(answer(in_ms, {0.5}), "is 0.5");
  EXPECT_EQ(allowedBy(in_ms), "a number, 1 to 60000 ms");
}

TEST(SettingKinds, areDurationsThatMayBeNever) {
  std::optional<Duration> value = 1s;
  const SettingKind kind = secondsOrNever(value, 0, 60);
  EXPECT_EQ(answer(kind, {-1}), "");
  EXPECT_EQ(value, std::nullopt);
  EXPECT_EQ(kind.show(), "-1");
  EXPECT_EQ(answer(kind.in_milliseconds(), {250}), "");
  EXPECT_EQ(value, Duration(250ms));
  EXPECT_EQ(answer(kind, {-0.5}), "is -0.5");
  EXPECT_EQ(answer(kind, {-kInfinity}), "is -inf");
  EXPECT_EQ(value, Duration(250ms));
  EXPECT_EQ(allowedBy(kind), "a number, 0 to 60 s; or -1: never");
}

TEST(SettingKinds, areFlagsForTrueAndFalseAndTheirDigits) {
  bool value = false;
  const SettingKind kind = flag(value);
  EXPECT_EQ(answer(kind, {true}), "");
  EXPECT_TRUE(value);
  EXPECT_EQ(answer(kind, {0}), "");
  EXPECT_FALSE(value);
  EXPECT_EQ(answer(kind, {1}), "");
  EXPECT_TRUE(value);
  EXPECT_EQ(answer(kind, {2}), "is 2");
  EXPECT_EQ(answer(kind, {-1}), "is -1");
  EXPECT_EQ(answer(kind, {0.0}), "is 0.0");
  EXPECT_EQ(answer(kind, {"yes"}), "is the text \"yes\"");
  EXPECT_TRUE(value);
}

TEST(SettingKinds, areNamesThatStandOnALine) {
  std::string value = "before";
  const SettingKind kind = text(value, name(8));
  EXPECT_EQ(allowedBy(kind), "a text of 1 to 8 bytes without control characters");
  for (const std::string& bad :
       {std::string(), std::string("a\nb"), std::string("\x1b[2J"), std::string("a\0b", 3),
        std::string("\x7f"), std::string("\xff"), std::string(9, 'x')}) {
    EXPECT_THAT(answer(kind, {bad}), HasSubstr("is ")) << bad;
  }
  EXPECT_EQ(value, "before");
  for (const char* good : {"Listen1", "a\\b", "\"\"", "Zelle \xc3\xa4"}) {
    EXPECT_EQ(answer(kind, {good}), "");
    EXPECT_EQ(value, good);
  }
}

TEST(SettingKinds, areTextsByARule) {
  std::string value;
  const SettingKind kind = text(value, orEmpty(oneOf({"a", "b", "c"})));
  EXPECT_EQ(answer(kind, {"b"}), "");
  EXPECT_EQ(value, "b");
  EXPECT_EQ(answer(kind, {"d"}), "is the text \"d\"");
  EXPECT_EQ(answer(kind, {1}), "is 1, no text");
  EXPECT_EQ(value, "b");
  EXPECT_EQ(answer(kind, {""}), "");
  EXPECT_EQ(value, "");
  EXPECT_EQ(allowedBy(kind), "a, b or c, or empty");
}

TEST(SettingKinds, areWordsForTheValuesOfAnEnumeration) {
  enum class Colour { Red, Green };
  Colour value = Colour::Red;
  const SettingKind kind = choice(value, Words<Colour>{{"red", Colour::Red}, {"green", Colour::Green}});
  EXPECT_EQ(kind.show(), "red");
  EXPECT_EQ(answer(kind, {"green"}), "");
  EXPECT_EQ(value, Colour::Green);
  EXPECT_EQ(answer(kind, {"blue"}), "is the text \"blue\"");
  EXPECT_EQ(answer(kind, {""}), "is an empty text");
  EXPECT_EQ(allowedBy(kind), "red or green");
}

TEST(SettingKinds, quoteNoMoreThanALineOfForeignText) {
  std::string value;
  const SettingKind kind = text(value, oneOf({"a"}));
  EXPECT_EQ(answer(kind, {"a\n\x1b[31m\xff"}), R"(is the text "a\n\x1B[31m\xFF")");
  EXPECT_LT(answer(kind, {std::string(1000000, 'x')}).size(), 100U);
}

}  // namespace
}  // namespace cobot_command::setting_kinds
