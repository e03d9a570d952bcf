#include "cobot_command/protocol/float_payload.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>

namespace cobot_command::protocol {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using namespace std::string_literals;

std::string faultOf(std::string_view payload, std::size_t count) {
  const auto floats = parseFloats(payload, count);
  return floats ? "none" : floats.error().message;
}

// I848-E-03 7.4: ListenSend(91,data) of the float[] {1,2,3,4}.
TEST(FloatPayload, isReadAsTheManualHasIt) {
  const auto floats = parseFloats("\x00\x00\x80\x3f\x00\x00\x00\x40\x00\x00\x40\x40\x00\x00\x80\x40"s, 4);
  ASSERT_TRUE(floats) << floats.error().message;
  EXPECT_THAT(*floats, ElementsAre(1.0F, 2.0F, 3.0F, 4.0F));
}

TEST(FloatPayload, isReadAsItWasWritten) {
  const std::vector<float> all{0.0F,
                               -180.0F,
                               0.001F,
                               1e9F,
                               std::numeric_limits<float>::max(),
                               std::numeric_limits<float>::denorm_min()};
  const auto read = parseFloats(floatPayload(all), all.size());
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, all);
}

TEST(FloatPayload, mayBeEmptyWhenNothingIsExpected) {
  const auto floats = parseFloats("", 0);
  ASSERT_TRUE(floats);
  EXPECT_TRUE(floats->empty());
}

TEST(FloatPayload, hasFourBytesForEachNumber) {
  EXPECT_EQ(faultOf("", 1), "expected 1 float in 4 bytes, found 0 bytes");
  EXPECT_EQ(faultOf("abc", 1), "expected 1 float in 4 bytes, found 3 bytes");
  EXPECT_EQ(faultOf(std::string(25, 'x'), 6), "expected 6 floats in 24 bytes, found 25 bytes");
  EXPECT_EQ(faultOf(std::string(48, 'x'), 6), "expected 6 floats in 24 bytes, found 48 bytes")
      << "six doubles";
  EXPECT_EQ(faultOf("x", 0), "expected 0 floats in 0 bytes, found 1 byte");
}

TEST(FloatPayload, isFinite) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity()}) {
    EXPECT_THAT(faultOf(floatPayload({1, bad, 3}), 3), HasSubstr("number 2 of 3 is "));
  }
  EXPECT_EQ(faultOf(floatPayload({-std::numeric_limits<float>::infinity()}), 1),
            "expected finite numbers, number 1 of 1 is -inf");
}

TEST(FloatPayload, isNotTakenForOneWhenTheCountIsAbsurd) {
  EXPECT_THAT(faultOf("abcd", std::numeric_limits<std::size_t>::max() / 2 + 1), HasSubstr("found 4 bytes"));
}

}  // namespace
}  // namespace cobot_command::protocol
