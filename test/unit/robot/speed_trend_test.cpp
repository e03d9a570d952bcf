// Whether the tool gets faster or slower, by what was streamed in the last 100 ms.
#include "cobot_command/robot/speed_trend.h"

#include <gtest/gtest.h>

namespace cobot_command::robot {
namespace {

using namespace std::chrono_literals;

class SpeedTrends : public ::testing::Test {
 protected:
  /// Frames 20 ms apart, of these speeds [m/s].
  void stream(std::initializer_list<double> speeds) {
    for (const double speed : speeds) {
      link::RobotStatus status;
      status.received = now += 20ms;
      status.tool_speed = speed;
      trends.see(status);
    }
  }
  SpeedTrend trends;
  Instant now{100s};
};

TEST_F(SpeedTrends, areUnknownUntilThereIsEnoughOfThem) {
  stream({0, 0, 0, 0, 0});
  EXPECT_EQ(trends.trend(), std::nullopt);
  stream({0});
  EXPECT_EQ(trends.trend(), Trend::Standing);
}

TEST_F(SpeedTrends, areSeenOverATenthOfASecond) {
  stream({0, 0, 0, 0.004, 0.008, 0.012});
  EXPECT_EQ(trends.trend(), Trend::Accelerating);
  stream({0.012, 0.012, 0.012, 0.012, 0.012});
  EXPECT_EQ(trends.trend(), Trend::ConstantVelocity);
  stream({0.001});
  EXPECT_EQ(trends.trend(), Trend::Decelerating);
  stream({0, 0, 0, 0, 0});
  EXPECT_EQ(trends.trend(), Trend::Standing);
}

TEST_F(SpeedTrends, areUnknownWithoutASpeed) {
  stream({0, 0, 0, 0, 0, 0});
  trends.see(link::RobotStatus());
  EXPECT_EQ(trends.trend(), std::nullopt);
}

}  // namespace
}  // namespace cobot_command::robot
