// A whole path as one PVT: thousands of points in a frame of some MB.
#include "long_pvt.h"

#include <cmath>

#include "simulated_robot.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::simulator::test {
namespace {

using testing::LongPvt;

class LongPvtTest : public ::testing::Test {
 protected:
  SimulatedRobot robot;
  ClientId client = robot.connect();
};

TEST_F(LongPvtTest, isMadeWithEachPointAtItsTimeAndATagOnItsWay) {
  const LongPvt path(6000);
  robot.script(client, "1", path.script());
  EXPECT_EQ(robot.heard(client), ok("1"));
  for (const int point : {1, 1234, 3000, 5999}) {
    robot.waitUntil(Instant{} + point * LongPvt::kSegment);
    EXPECT_NEAR(robot.joints()[0], LongPvt::angle(point), 1e-6) << "point " << point;
  }
  robot.waitUntilIdle();
  EXPECT_NEAR(toSeconds(robot.now() - Instant{}), toSeconds(6000 * LongPvt::kSegment), 1e-6);
  EXPECT_EQ(robot.heard(client), tag("01,true") + tag("02,true"));
  EXPECT_NEAR(robot.joints()[0], LongPvt::angle(6000), 1e-9);
}

TEST_F(LongPvtTest, mayHaveTwentyThousandPointsThatComeInPiecesOfAFrame) {
  const LongPvt path(20000);
  const std::string frame = protocol::encodeFrame("TMSCT", "1," + path.script());
  ASSERT_GT(frame.size(), 3'000'000U);
  constexpr std::size_t kPiece = 1460;
  for (std::size_t at = 0; at < frame.size(); at += kPiece) robot.send(client, frame.substr(at, kPiece));
  EXPECT_EQ(robot.heard(client), ok("1"));
  robot.waitUntilIdle();
  EXPECT_NEAR(toSeconds(robot.now() - Instant{}), toSeconds(20000 * LongPvt::kSegment), 1e-6);
  EXPECT_EQ(robot.heard(client), tag("01,true") + tag("02,true"));
}

TEST_F(LongPvtTest, waitsBehindTheOneThatIsMadeWhileBothAreNoMoreThanThat) {
  robot.script(client, "1", "Pause()");
  robot.script(client, "2", LongPvt(10000).script());
  robot.script(client, "3", LongPvt(10000).script());
  EXPECT_EQ(robot.heard(client), ok("1") + ok("2") + ok("3"));
  robot.script(client, "4", LongPvt(1).script());
  EXPECT_EQ(robot.heard(client), error("4", "2"));
}

}  // namespace
}  // namespace cobot_command::simulator::test
