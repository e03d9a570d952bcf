// What a robot takes of what supervisors tell, and for how long that can be relied on.
#include "agent/state_watch.h"

#include <gmock/gmock.h>

namespace cobot_command::cell {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

class StateWatchTest : public testing::Test {
 protected:
  StateWatchTest() {
    state.hash = "0123456789";
    state.instance = 7;
    state.epoch = 3;
    RobotStatus other;
    other.name = "RB";
    RobotStatus mine;
    mine.name = "RA";
    mine.session = 11;
    mine.report = 1;
    mine.acknowledged = 5;
    state.robots = {other, mine};
  }

  CellStatus state;
  Instant now = Instant(1h);
  StateWatch watch{"RA", 11, "0123456789", 500ms};
};

TEST_F(StateWatchTest, knowsNothingBeforeAnythingWasHeard) {
  EXPECT_EQ(watch.mine(), nullptr);
  EXPECT_EQ(watch.instance(), 0U);
  EXPECT_THAT(*watch.objection(now), HasSubstr("no message of a supervisor was received"));
}

TEST_F(StateWatchTest, reliesOnAStateUntilTheLeaseIsOver) {
  watch.told(1, now);
  EXPECT_TRUE(watch.hear(state, 1, now));
  ASSERT_NE(watch.mine(), nullptr);
  EXPECT_EQ(watch.mine()->acknowledged, 5U);
  EXPECT_EQ(watch.instance(), 7U);
  EXPECT_EQ(watch.objection(now + 500ms), std::nullopt);
  EXPECT_NE(watch.objection(now + 500ms + Duration(1)), std::nullopt);
  EXPECT_THAT(*watch.objection(now + 600ms), HasSubstr("no message of the supervisor for 0.6 s"));
}

TEST_F(StateWatchTest, isToldNothingByAnOldState) {
  EXPECT_TRUE(watch.hear(state, 10, now));
  state.robots[1].acknowledged = 4;
  EXPECT_FALSE(watch.hear(state, 10, now + 400ms)) << "the same once more";
  EXPECT_FALSE(watch.hear(state, 9, now + 400ms));
  EXPECT_EQ(watch.mine()->acknowledged, 5U);
  EXPECT_NE(watch.objection(now + 600ms), std::nullopt) << "it renews no lease";
}

TEST_F(StateWatchTest, takesANewerEpochWhateverItsNumber) {
  EXPECT_TRUE(watch.hear(state, 10, now));
  ++state.epoch;
  EXPECT_TRUE(watch.hear(state, 1, now));
  --state.epoch;
  EXPECT_FALSE(watch.hear(state, 11, now)) << "of before the restart";
}

TEST_F(StateWatchTest, keepsToTheSupervisorThatItHeardFirstAndObjectsWhileThereIsASecond) {
  EXPECT_TRUE(watch.hear(state, 1, now));
  state.instance = 8;
  state.robots[1].acknowledged = 99;
  EXPECT_FALSE(watch.hear(state, 2, now + 100ms));
  EXPECT_EQ(watch.instance(), 7U);
  EXPECT_EQ(watch.mine()->acknowledged, 5U);
  EXPECT_THAT(*watch.objection(now + 100ms), HasSubstr("second supervisor"));
  state.instance = 7;
  EXPECT_TRUE(watch.hear(state, 2, now + 200ms));
  EXPECT_THAT(*watch.objection(now + 600ms), HasSubstr("second supervisor"));
  watch.told(1, now + 600ms);
  EXPECT_TRUE(watch.hear(state, 3, now + 601ms));
  EXPECT_EQ(watch.objection(now + 601ms), std::nullopt);
}

TEST_F(StateWatchTest, takesNothingOfAnotherArtifact) {
  state.hash = "9876543210";
  EXPECT_FALSE(watch.hear(state, 1, now));
  EXPECT_EQ(watch.mine(), nullptr);
  EXPECT_THAT(*watch.objection(now), HasSubstr("another artifact (98765432, this node has 01234567)"));
}

TEST_F(StateWatchTest, isOfNoRobotThatTheStateDoesNotHave) {
  state.robots.pop_back();
  EXPECT_TRUE(watch.hear(state, 1, now));
  EXPECT_EQ(watch.mine(), nullptr);
}

/// A network that keeps messages brings them all at once.
TEST_F(StateWatchTest, reliesOnNoStateThatKnowsOnlyOldReports) {
  watch.told(1, now);
  state.robots[1].report = 1;
  EXPECT_TRUE(watch.hear(state, 1, now + 100ms));
  EXPECT_EQ(watch.objection(now + 500ms), std::nullopt);
  watch.told(2, now + 400ms);
  EXPECT_TRUE(watch.hear(state, 2, now + 600ms));
  EXPECT_THAT(*watch.objection(now + 600ms),
              HasSubstr("the supervisor's last report of the robot is 0.6 s old"));
  state.robots[1].report = 2;
  EXPECT_TRUE(watch.hear(state, 3, now + 700ms));
  EXPECT_EQ(watch.objection(now + 900ms), std::nullopt);
  EXPECT_NE(watch.objection(now + 901ms), std::nullopt);
}

TEST_F(StateWatchTest, reliesOnNoStateThatNeverKnewANewReport) {
  watch.told(1, now);
  watch.told(2, now + 2s);
  EXPECT_TRUE(watch.hear(state, 1, now + 2s));
  EXPECT_EQ(watch.silence(now + 2s), std::nullopt);
  EXPECT_THAT(*watch.objection(now + 2s), HasSubstr("has not received the robot's last reports"));
}

TEST_F(StateWatchTest, isToldNothingByReportsOfAnotherSession) {
  watch.told(1, now);
  state.robots[1].report = 1;
  EXPECT_TRUE(watch.hear(state, 1, now));
  state.robots[1].session = 12;
  EXPECT_TRUE(watch.hear(state, 2, now + 600ms));
  EXPECT_EQ(watch.objection(now + 600ms), std::nullopt) << "whether it is let in is said elsewhere";
}

}  // namespace
}  // namespace cobot_command::cell
