// A robot that still moves when a link is made: told, stopped, and nothing queues behind it in silence.

#include "core_rig.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kWords = "no goal of this layer requested it";

link::LinkSettings leaveIt() {
  link::LinkSettings settings;
  settings.stop_orphaned_motion = false;
  return settings;
}

/// Connected to a robot of which the first frame says this.
GoalId connectTo(CoreRig& rig, const std::vector<protocol::StatusItem>& first_frame) {
  const GoalId id = rig.submit(CoreRig::robot());
  rig.open();
  rig.open(link::Channel::Status);
  rig.status(first_frame);
  return id;
}

TEST(OrphanedMotion, isToldAndStoppedWhenTheLinkIsMade) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  connectTo(rig, StatusFrames().moving());
  EXPECT_THAT(rig.latest().diagnosis, HasSubstr(kWords));
  ASSERT_FALSE(rig.warnings.empty());
  EXPECT_THAT(rig.warnings.back(), HasSubstr(kWords));
  const auto stop = rig.takeScript();
  EXPECT_EQ(stop.script, "StopAndClearBuffer()");
  rig.reply(stop.id);
  rig.stream(StatusFrames());
  EXPECT_THAT(rig.latest().diagnosis, Not(HasSubstr(kWords)));
  rig.submit(CoreRig::move());
  EXPECT_THAT(rig.takeScript().script, HasSubstr("PTP"));
}

TEST(OrphanedMotion, isStoppedBeforeTheNextGoalIsSent) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  connectTo(rig, StatusFrames().moving());
  const auto stop = rig.takeScript();
  const GoalId goal = rig.submit(CoreRig::move());
  EXPECT_TRUE(rig.nothingSent());
  EXPECT_THAT(rig.progress(goal).back().text, HasSubstr(kWords));
  rig.reply(stop.id);
  rig.status(StatusFrames().moving());
  EXPECT_TRUE(rig.nothingSent());
  rig.stream(StatusFrames());
  EXPECT_THAT(rig.takeScript().script, HasSubstr("PTP"));
}

TEST(OrphanedMotion, isFoundAgainAfterEachLoss) {
  link::LinkSettings settings;
  settings.auto_reconnect = true;
  CoreRig rig(std::nullopt, settings);
  connectTo(rig, StatusFrames());
  rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id);
  rig.status(StatusFrames().moving());
  rig.close("cable pulled");
  rig.status(StatusFrames().moving());
  rig.pass(100ms);
  rig.open();
  EXPECT_EQ(rig.takeScript().script, "StopAndClearBuffer()");
  EXPECT_THAT(rig.latest().diagnosis, HasSubstr(kWords));
}

TEST(OrphanedMotion, isLeftAloneOnRequestAndThenHoldsBackWhatWouldQueueBehindIt) {
  CoreRig rig(std::nullopt, leaveIt());
  connectTo(rig, StatusFrames().moving());
  EXPECT_TRUE(rig.nothingSent());
  EXPECT_THAT(rig.latest().diagnosis, HasSubstr(kWords));
  const GoalId refused = rig.submit(CoreRig::move());
  ASSERT_NE(rig.outcome(refused), nullptr);
  EXPECT_EQ(rig.outcome(refused)->error_id, own_error::kOrphanMoves);
  const GoalId waiting = rig.submit(CoreRig::move(BufferMode::Buffered));
  EXPECT_TRUE(rig.nothingSent());
  EXPECT_THAT(rig.progress(waiting).back().text, HasSubstr(kWords));
  rig.status(StatusFrames());
  EXPECT_THAT(rig.takeScript().script, HasSubstr("PTP"));
}

TEST(OrphanedMotion, isTakenOverWithAStop) {
  CoreRig rig(std::nullopt, leaveIt());
  connectTo(rig, StatusFrames().moving());
  const GoalId goal = rig.submit(CoreRig::move(BufferMode::Aborting));
  const auto stop = rig.takeScript();
  EXPECT_EQ(stop.script, "StopAndClearBuffer()");
  rig.reply(stop.id);
  rig.stream(StatusFrames());
  EXPECT_TRUE(rig.accepted(goal));
  EXPECT_THAT(rig.takeScript().script, HasSubstr("PTP"));
}

/// A stream that is gone shows nothing, so also no robot that stands.
TEST(OrphanedMotion, holdsEverythingBackUntilTheRobotIsSeenToStandAlsoWhenTheStreamIsLost) {
  CoreRig rig(std::nullopt, leaveIt());
  connectTo(rig, StatusFrames().moving());
  rig.submit(CoreRig::move(BufferMode::Buffered));
  rig.close("reset", link::Channel::Status);
  EXPECT_TRUE(rig.nothingSent());
  EXPECT_THAT(rig.latest().diagnosis, HasSubstr("moved when it was last seen"));
  const GoalId refused = rig.submit(CoreRig::move());
  EXPECT_EQ(rig.outcome(refused)->error_id, motion_error::kOtherBlockBusy);
  rig.pass(100ms);
  rig.open(link::Channel::Status);
  EXPECT_TRUE(rig.nothingSent());
  rig.status(StatusFrames().without("Joint_Speed"));
  EXPECT_TRUE(rig.nothingSent()) << "of one frame without speeds nobody can say";
  rig.status(StatusFrames().moving());
  EXPECT_THAT(rig.latest().diagnosis, HasSubstr(kWords));
  EXPECT_TRUE(rig.nothingSent());
  rig.status(StatusFrames());
  EXPECT_THAT(rig.takeScript().script, HasSubstr("PTP"));
}

TEST(OrphanedMotion, isEndedByAStopWhereNoStreamComesBack) {
  CoreRig rig(std::nullopt, leaveIt());
  connectTo(rig, StatusFrames().moving());
  rig.close("gone", link::Channel::Status);
  const GoalId refused = rig.submit(CoreRig::move());
  ASSERT_NE(rig.outcome(refused), nullptr);
  EXPECT_EQ(rig.outcome(refused)->error_id, own_error::kOrphanMoves);
  const GoalId stop = rig.submit(StopGoal{});
  rig.reply(rig.takeScript().id);
  EXPECT_EQ(rig.outcome(stop)->ending, Ending::Done);
  rig.submit(CoreRig::move());
  EXPECT_THAT(rig.takeScript().script, HasSubstr("PTP"));
}

TEST(OrphanedMotion, isNoneWhenTheRobotStandsOrWasCommandedSince) {
  CoreRig standing(std::nullopt, link::LinkSettings{});
  connectTo(standing, StatusFrames());
  standing.status(StatusFrames().moving());
  EXPECT_TRUE(standing.nothingSent());
  EXPECT_THAT(standing.latest().diagnosis, Not(HasSubstr(kWords)));

  CoreRig commanded(std::nullopt, link::LinkSettings{});
  connectTo(commanded, {});
  commanded.submit(CoreRig::move());
  commanded.reply(commanded.takeScript().id);
  commanded.status(StatusFrames().moving());
  EXPECT_TRUE(commanded.nothingSent());
}

/// What moves the robot then is the project, which has come to its Listen node.
TEST(OrphanedMotion, isNoneWhenTheFlowWasElsewhereFirst) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  rig.listening = false;
  connectTo(rig, StatusFrames().moving());
  rig.listening = true;
  rig.say(protocol::ListenNodeEntered{"Listen1"});
  rig.status(StatusFrames().moving());
  EXPECT_EQ(rig.latest().link, CommandStatus::LinkState::Ready);
  EXPECT_TRUE(rig.nothingSent());
}

TEST(HeldFromBefore, isStoppedWhenTheLinkIsMade) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  connectTo(rig, StatusFrames().paused());
  EXPECT_THAT(rig.latest().diagnosis, HasSubstr("motions queued before this connection may continue"));
  const auto stop = rig.takeScript();
  EXPECT_EQ(stop.script, "StopAndClearBuffer()");
  const GoalId goal = rig.submit(CoreRig::move(BufferMode::Buffered));
  EXPECT_TRUE(rig.nothingSent());
  rig.reply(stop.id);
  rig.stream(StatusFrames().paused());
  EXPECT_THAT(rig.takeScript().script, HasSubstr("PTP"));
  EXPECT_TRUE(rig.accepted(goal));
}

TEST(HeldFromBefore, isLeftAndNothingQueuesBehindItUnseen) {
  CoreRig rig(std::nullopt, leaveIt());
  connectTo(rig, StatusFrames().paused());
  EXPECT_TRUE(rig.nothingSent());
  const GoalId refused = rig.submit(CoreRig::move());
  ASSERT_NE(rig.outcome(refused), nullptr);
  EXPECT_EQ(rig.outcome(refused)->error_id, own_error::kOrphanMoves);
  const GoalId waits = rig.submit(CoreRig::move(BufferMode::Buffered));
  EXPECT_TRUE(rig.nothingSent());
  EXPECT_EQ(rig.outcome(waits), nullptr);
  rig.stream(StatusFrames().moving());
  EXPECT_TRUE(rig.nothingSent());
  rig.stream(StatusFrames());
  EXPECT_THAT(rig.takeScript().script, HasSubstr("PTP"));
}

TEST(HeldFromBefore, isStoppedByATakeOver) {
  CoreRig rig(std::nullopt, leaveIt());
  connectTo(rig, StatusFrames().paused());
  rig.submit(CoreRig::move(BufferMode::Aborting));
  const auto stop = rig.takeScript();
  EXPECT_EQ(stop.script, "StopAndClearBuffer()");
  rig.reply(stop.id);
  rig.stream(StatusFrames().paused());
  EXPECT_THAT(rig.takeScript().script, HasSubstr("PTP"));
}

TEST(HeldFromBefore, isNotWhatIsHeldLater) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  connectTo(rig, StatusFrames());
  rig.stream(StatusFrames().paused());
  EXPECT_TRUE(rig.nothingSent());
  rig.submit(CoreRig::move());
  EXPECT_THAT(rig.takeScript().script, HasSubstr("PTP"));
}

}  // namespace
}  // namespace cobot_command::testing
