// A controller in error: motions are refused until somebody answers for it, with a stop; the next motion
// clears it then.

#include "core_rig.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::HasSubstr;

struct Rig : CoreRig {
  Rig() : CoreRig(std::nullopt, link::LinkSettings{}) {
    connect();
    status(StatusFrames());
  }
  /// The stop block, accepted; the robot stands in its error.
  void acknowledge(int code = 0x13) {
    const GoalId stop = submit(StopGoal{});
    reply(takeScript().id);
    stream(StatusFrames().error(code, "PTP"));
    ASSERT_NE(outcome(stop), nullptr);
    EXPECT_EQ(outcome(stop)->ending, Ending::Done);
  }
};

void expectRefused(Rig& rig) {
  const GoalId id = rig.submit(CoreRig::move());
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Rejected);
  EXPECT_EQ(rig.outcome(id)->error_id, own_error::kRobotError);
  EXPECT_THAT(rig.outcome(id)->remedy, HasSubstr("Execute stop"));
}

TEST(RobotError, isAcknowledgedByAStopAndClearedByTheNextMotion) {
  Rig rig;
  rig.status(StatusFrames().error(0x13, "PTP"));
  expectRefused(rig);
  EXPECT_THAT(rig.latest().diagnosis, HasSubstr("execute stop"));
  rig.acknowledge();
  EXPECT_THAT(rig.latest().diagnosis, HasSubstr("acknowledged"));
  const GoalId id = rig.submit(CoreRig::move());
  EXPECT_TRUE(rig.accepted(id));
  rig.reply(rig.takeScript().id);
  rig.status(StatusFrames().error(0x13, "PTP"));
  EXPECT_EQ(rig.outcome(id), nullptr) << "the old error fails no new motion";
  rig.status(StatusFrames());
  rig.tag(rig.latest().open_tags.at(0));
  rig.status(StatusFrames());
  rig.status(StatusFrames());
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Done);
}

TEST(RobotError, countsAgainWhenItComesAgainOrIsAnotherOne) {
  for (const bool gone_between : {true, false}) {
    Rig rig;
    rig.status(StatusFrames().error(0x13, "PTP"));
    rig.acknowledge();
    const GoalId id = rig.submit(CoreRig::move());
    rig.reply(rig.takeScript().id);
    if (gone_between) rig.status(StatusFrames());
    rig.status(StatusFrames().error(gone_between ? 0x13 : 0x14, "once more"));
    ASSERT_NE(rig.outcome(id), nullptr);
    EXPECT_EQ(rig.outcome(id)->error_id, own_error::kRobotError);
    rig.discardSent();
  }
}

TEST(RobotError, hasToBeAcknowledgedAnewAfterAMotionThatFailedInIt) {
  Rig rig;
  rig.status(StatusFrames().error(0x13, "PTP"));
  rig.acknowledge();
  const GoalId id = rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id, false, {1});
  ASSERT_NE(rig.outcome(id), nullptr);
  expectRefused(rig);
}

TEST(RobotError, isTheReasonOfAMotionThatItFailsThoughItWasAcknowledged) {
  Rig rig;
  rig.status(StatusFrames().error(0x13, "PTP"));
  rig.acknowledge();
  const GoalId id = rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id);
  rig.tag(rig.latest().open_tags.at(0), protocol::TagState::Incomplete);
  rig.status(StatusFrames().error(0x13, "PTP"));
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->error_id, own_error::kRobotError);
  EXPECT_THAT(rig.outcome(id)->error_description, HasSubstr("0x13"));
  rig.discardSent();
}

/// A stop that the layer sends by itself is nobody's answer for an error.
TEST(RobotError, isNotAcknowledgedByACancelOrByTheStopBehindAFailure) {
  Rig rig;
  rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id);
  rig.status(StatusFrames().error(0x13, "PTP"));
  rig.reply(rig.takeScript().id);
  rig.stream(StatusFrames().error(0x13, "PTP"));
  expectRefused(rig);
}

TEST(RobotError, isNotAcknowledgedByAStopThatFailed) {
  Rig rig;
  rig.status(StatusFrames().error(0x13, "PTP"));
  rig.submit(StopGoal{});
  rig.reply(rig.takeScript().id, false, {1});
  expectRefused(rig);
}

}  // namespace
}  // namespace cobot_command::testing
