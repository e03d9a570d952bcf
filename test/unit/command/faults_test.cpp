// What goes wrong while a motion is Busy, and which ErrorID it ends with.

#include "core_rig.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using protocol::CommunicationErrorCode;
using protocol::TagState;
using ::testing::HasSubstr;

void expectAborted(const CoreRig& rig, GoalId goal, int error_id, const std::string& words) {
  const Outcome* outcome = rig.outcome(goal);
  ASSERT_NE(outcome, nullptr);
  EXPECT_EQ(outcome->ending, Ending::Aborted);
  EXPECT_EQ(outcome->error_id, error_id);
  EXPECT_THAT(outcome->error_description, HasSubstr(words));
  EXPECT_FALSE(outcome->remedy.empty());
  EXPECT_TRUE(rig.outputs(kBlock<MoveAbsoluteGoal>).error);
}

class Fault : public ::testing::Test {
 protected:
  Fault() : rig(std::nullopt, link::LinkSettings{}) {
    rig.connect();
    rig.status(StatusFrames());
  }
  /// A motion that was accepted.
  GoalId moving() {
    const GoalId goal = rig.submit(CoreRig::move());
    rig.reply(rig.takeScript().id);
    return goal;
  }
  /// Lets time pass while the status stream goes on.
  void stream(Duration duration, const StatusFrames& frame) { rig.streamFor(duration, frame, 500ms); }
  void expectStopSent() { EXPECT_EQ(rig.takeScript().script, "StopAndClearBuffer()"); }
  CoreRig rig;
};

TEST_F(Fault, rejectedByTheControllerNamesTheLine) {
  const GoalId goal = rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id, false, {1, 2});
  expectAborted(rig, goal, motion_error::kRejected, "line 1: PTP(\"CPP\",417.5");
  EXPECT_THAT(rig.outcome(goal)->error_description, HasSubstr("line 2: QueueTag(1,0)"));
}

/// A long sequence is planned in the event that sends it.
TEST(NoFault, isAReplyThatHadNoTimeBecausePlanningTookIt) {
  CoreRig rig;
  rig.connect();
  const GoalId goal = rig.submit(CoreRig::move());
  const auto script = rig.takeScript();
  rig.now += 20s;
  rig.core.advance(rig.now);
  rig.pump();
  EXPECT_EQ(rig.outcome(goal), nullptr);
  rig.pass(900ms);
  rig.reply(script.id);
  EXPECT_EQ(rig.outcome(goal), nullptr);
  rig.tag(1);
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Done) << rig.outcome(goal)->error_description;
}

TEST_F(Fault, notInTheListenNodeAnyMore) {
  const GoalId goal = rig.submit(CoreRig::move());
  rig.takeScript();
  rig.say(protocol::CommunicationError{CommunicationErrorCode::NotListening});
  expectAborted(rig, goal, own_error::kNotListening, "Cobot is not in Listen Node");
  EXPECT_EQ(rig.latest().link, CommandStatus::LinkState::NotListening);
}

/// It carries no id: the controller may have the script all the same, and the robot may move.
TEST_F(Fault, communicationErrorGoesToTheOldestFrameAndStopsTheRobot) {
  for (const auto code : {CommunicationErrorCode::Packet, CommunicationErrorCode::Checksum,
                          CommunicationErrorCode::Header, CommunicationErrorCode::Data}) {
    const GoalId goal = rig.submit(CoreRig::move());
    rig.takeScript();
    rig.say(protocol::CommunicationError{code});
    expectAborted(rig, goal, own_error::kCommunication, "error");
    const auto stop = rig.takeScript();
    EXPECT_EQ(stop.script, "StopAndClearBuffer()");
    rig.reply(stop.id);
    rig.stream(StatusFrames());
  }
}

TEST_F(Fault, communicationErrorOfWhatDoesNotMoveStopsNothing) {
  const GoalId goal = rig.submit(ChangeBaseGoal{});
  rig.takeScript();
  rig.say(protocol::CommunicationError{CommunicationErrorCode::Data});
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->error_id, own_error::kCommunication);
  EXPECT_TRUE(rig.nothingSent());
}

TEST_F(Fault, noReplyInTimeStopsTheRobot) {
  const GoalId goal = rig.submit(CoreRig::move());
  const auto script = rig.takeScript();
  rig.pass(999ms);
  EXPECT_EQ(rig.outcome(goal), nullptr);
  rig.pass(1ms);
  expectAborted(rig, goal, motion_error::kReceiveReply, "no reply");
  expectStopSent();
  const auto late = rig.latest().late_replies;
  rig.reply(script.id);
  rig.tag(1);
  EXPECT_EQ(rig.latest().late_replies, late + 2) << "what comes late is counted and not applied";
}

TEST_F(Fault, tagReportedFalse) {
  const GoalId goal = moving();
  rig.tag(1, TagState::Incomplete);
  expectStopSent();
  for (int i = 0; i < 3; ++i) {
    rig.pass(15ms);
    rig.status(StatusFrames());
  }
  expectAborted(rig, goal, motion_error::kMotionFailed, "tag 1");
}

TEST(FaultWithoutStatus, linkLostAtEachStep) {
  for (std::size_t i = 0; i < 5; ++i) {
    CoreRig other;
    const GoalId connect = other.connect();
    const GoalId goal = other.submit(CoreRig::move());
    const auto script = other.takeScript();
    if (i == 1 || i == 3) other.reply(script.id);
    if (i == 2) other.tag(1);
    if (i >= 3) other.cancel(goal);
    other.discardSent();
    other.close("reset");
    expectAborted(other, goal, motion_error::kLinkDropped, "reset");
    EXPECT_EQ(other.outcome(connect)->error_id, connect_error::kDisconnected);
    EXPECT_TRUE(other.latest().open_tags.empty());
  }
}

TEST_F(Fault, emergencyStopEndsTheMotionAtOnce) {
  const GoalId goal = moving();
  rig.status(StatusFrames().emergencyStop());
  expectAborted(rig, goal, motion_error::kLinkDropped, "emergency stop");
  expectStopSent();
  const GoalId next = rig.submit(CoreRig::move());
  ASSERT_NE(rig.outcome(next), nullptr);
  EXPECT_EQ(rig.outcome(next)->error_id, own_error::kEmergencyStop);
}

TEST_F(Fault, robotErrorTellsCodeAndText) {
  const GoalId goal = moving();
  rig.status(StatusFrames().error(0x1405A, "Joint outside its range"));
  expectAborted(rig, goal, own_error::kRobotError, "error 0x1405A: Joint outside its range");
  expectStopSent();
  const GoalId next = rig.submit(CoreRig::move());
  ASSERT_NE(rig.outcome(next), nullptr);
  EXPECT_EQ(rig.outcome(next)->ending, Ending::Rejected);
  EXPECT_EQ(rig.outcome(next)->error_id, own_error::kRobotError);
}

TEST_F(Fault, overdueMotionIsDoneWhenTheControllerSaysSo) {
  const GoalId goal = moving();
  stream(300s, StatusFrames().moving());
  EXPECT_EQ(rig.takeTagQuery().tag, 1);
  EXPECT_EQ(rig.outcome(goal), nullptr);
  rig.tag(1);
  rig.status(StatusFrames());
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Done);
}

TEST_F(Fault, overdueMotionGetsMoreTimeWhileTheRobotMoves) {
  const GoalId goal = moving();
  stream(300s, StatusFrames().moving());
  for (int i = 0; i < 5; ++i) {
    rig.takeTagQuery();
    rig.tag(1, TagState::Incomplete);
    EXPECT_EQ(rig.outcome(goal), nullptr);
    stream(2s, StatusFrames().moving());
  }
  rig.takeTagQuery();
  rig.tag(1);
  rig.status(StatusFrames());
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Done);
}

TEST_F(Fault, overdueMotionFailedWhenTheRobotStands) {
  const GoalId goal = moving();
  stream(300s, StatusFrames());
  rig.takeTagQuery();
  rig.tag(1, TagState::Incomplete);
  expectAborted(rig, goal, motion_error::kMotionFailed, "standstill");
  expectStopSent();
}

/// Frames of a controller that starves show the arm where it was, and no motion that it is in.
TEST_F(Fault, overdueMotionIsNotJudgedByOneFrame) {
  const GoalId goal = moving();
  stream(300s, StatusFrames().moving());
  rig.takeTagQuery();
  rig.status(StatusFrames());
  rig.tag(1, TagState::Incomplete);
  EXPECT_EQ(rig.outcome(goal), nullptr);
  stream(2s, StatusFrames());
  rig.takeTagQuery();
  rig.tag(1, TagState::Incomplete);
  expectAborted(rig, goal, motion_error::kMotionFailed, "standstill");
  expectStopSent();
}

TEST_F(Fault, overdueMotionFailsInASlowStreamAsWell) {
  const GoalId goal = moving();
  stream(300s, StatusFrames().moving());
  for (int question = 0; question < 8 && rig.outcome(goal) == nullptr; ++question) {
    while (rig.nothingSent()) rig.streamFor(900ms, StatusFrames(), 900ms);
    rig.takeTagQuery();
    rig.tag(1, TagState::Incomplete);
  }
  expectAborted(rig, goal, motion_error::kMotionFailed, "standstill");
  expectStopSent();
}

TEST_F(Fault, overdueMotionIsNotJudgedByAFrameFromBeforeTheQuestion) {
  const GoalId goal = moving();
  stream(299500ms, StatusFrames());
  rig.pass(500ms);
  rig.takeTagQuery();
  rig.tag(1, TagState::Incomplete);
  EXPECT_EQ(rig.outcome(goal), nullptr);
  rig.status(StatusFrames());
  stream(2s, StatusFrames());
  rig.takeTagQuery();
  rig.tag(1, TagState::Incomplete);
  expectAborted(rig, goal, motion_error::kMotionFailed, "standstill");
  expectStopSent();
}

TEST_F(Fault, overdueMotionIsLostWhenTheControllerDoesNotKnowItsTag) {
  const GoalId goal = moving();
  stream(300s, StatusFrames());
  rig.takeTagQuery();
  rig.tag(1, TagState::Unknown);
  expectAborted(rig, goal, own_error::kTagLost, "does not know tag 1");
  expectStopSent();
}

TEST_F(Fault, overdueMotionIsAnErrorWhenTheQuestionGetsNoAnswer) {
  for (const bool refused : {false, true}) {
    const GoalId goal = moving();
    const int tag = rig.latest().open_tags.at(0);
    stream(300s, StatusFrames());
    EXPECT_EQ(rig.takeTagQuery().tag, tag);
    if (refused) {
      rig.say(protocol::CommunicationError{CommunicationErrorCode::Data});
    } else {
      rig.pass(1s);
    }
    expectAborted(rig, goal, motion_error::kReceiveTag, refused ? "error" : "no answer");
    expectStopSent();
    rig.pass(2s);
    rig.discardSent();
    if (!rig.connectionOpen(link::Channel::Status)) rig.open(link::Channel::Status);
    stream(1s, StatusFrames());  // nobody answered the stop: until then it holds back the next motion
  }
}

TEST(FaultWithoutStatus, overdueMotionIsLostWhenNobodyCanTell) {
  CoreRig rig;
  rig.connect();
  const GoalId goal = rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id);
  rig.pass(300s);
  rig.takeTagQuery();
  rig.tag(1, TagState::Incomplete);
  expectAborted(rig, goal, own_error::kTagLost, "still not complete");
  EXPECT_EQ(rig.takeScript().script, "StopAndClearBuffer()");
}

TEST_F(Fault, aPauseDoesNotCountAsTime) {
  const GoalId goal = moving();
  stream(299s, StatusFrames().moving());
  stream(1000s, StatusFrames().paused());
  EXPECT_TRUE(rig.nothingSent());
  rig.status(StatusFrames().moving());
  stream(1s, StatusFrames().moving());
  EXPECT_EQ(rig.takeTagQuery().tag, 1);
  rig.tag(1);
  rig.status(StatusFrames());
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Done);
}

TEST_F(Fault, duplicatesAndStrangersAreCountedAndChangeNothing) {
  const GoalId goal = rig.submit(CoreRig::move());
  const auto script = rig.takeScript();
  rig.reply(script.id);
  const auto late = rig.latest().late_replies;
  rig.reply(script.id);
  rig.reply(script.id, false, {1});
  rig.reply("77");
  rig.reply("PTPJ");
  EXPECT_EQ(rig.latest().late_replies, late + 4);
  EXPECT_EQ(rig.outcome(goal), nullptr);
  rig.tag(1);
  rig.tag(1);
  rig.status(StatusFrames());
  EXPECT_EQ(rig.latest().late_replies, late + 5);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Done);
}

TEST_F(Fault, garbageBetweenFramesIsCountedAndPassedOver) {
  const GoalId goal = rig.submit(CoreRig::move());
  const auto script = rig.takeScript();
  rig.receive("noise");
  rig.receive("$TMSCT,4,1,OK,*00\r\n");
  rig.reply(script.id);
  rig.receive("$TMSTA,99999999999999999999,01,01,true,*6D\r\n");
  rig.tag(1);
  rig.status(StatusFrames());
  EXPECT_GE(rig.latest().decode_faults, 3u);
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Done);
}

}  // namespace
}  // namespace cobot_command::testing
