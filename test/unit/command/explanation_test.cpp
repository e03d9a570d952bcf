// The script port tells first that something failed, the status stream a frame later why: the end waits for
// it.

#include "block_goals.h"
#include "core_rig.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using protocol::TagState;
using ::testing::HasSubstr;

class Explanation : public ::testing::Test {
 protected:
  Explanation() : rig(std::nullopt, link::LinkSettings{}) {
    connect = rig.connect();
    rig.status(StatusFrames());
    motion = rig.submit(CoreRig::move());
    rig.reply(rig.takeScript().id);
    rig.status(StatusFrames().moving());
  }
  void frame(const StatusFrames& frame) {
    rig.pass(15ms);
    rig.status(frame);
  }
  void expectEnd(GoalId id, int error_id, const std::string& words) {
    ASSERT_NE(rig.outcome(id), nullptr);
    EXPECT_EQ(rig.outcome(id)->ending, Ending::Aborted);
    EXPECT_EQ(rig.outcome(id)->error_id, error_id);
    EXPECT_THAT(rig.outcome(id)->error_description, HasSubstr(words));
  }
  CoreRig rig;
  GoalId connect = 0;
  GoalId motion = 0;
};

TEST_F(Explanation, ofAFalseTagIsTheErrorOfTheController) {
  rig.tag(1, TagState::Incomplete);
  EXPECT_EQ(rig.takeScript().script, "StopAndClearBuffer()") << "the stop waits for nothing";
  EXPECT_EQ(rig.outcome(motion), nullptr);
  frame(StatusFrames().error(0x1405A, "Joint outside its range"));
  expectEnd(motion, own_error::kRobotError, "0x1405A: Joint outside its range");
  EXPECT_TRUE(rig.nothingSent());
}

TEST_F(Explanation, isNotToBeHadWhenTheStreamGoesOnWithoutOne) {
  rig.tag(1, TagState::Incomplete);
  for (int i = 0; i < 2; ++i) frame(StatusFrames().moving());
  EXPECT_EQ(rig.outcome(motion), nullptr);
  frame(StatusFrames());
  expectEnd(motion, motion_error::kMotionFailed, "tag 1 was reported false");
  rig.discardSent();
}

TEST_F(Explanation, maySitBehindAHeapOfFramesThatComeInOnePiece) {
  rig.tag(1, TagState::Incomplete);
  for (int i = 0; i < 20; ++i) rig.status(StatusFrames().moving());
  rig.pass(1ms);
  for (int i = 0; i < 20; ++i) rig.status(StatusFrames().moving());
  rig.status(StatusFrames().error(0x13, "PTP"));
  expectEnd(motion, own_error::kRobotError, "0x13");
  rig.discardSent();
}

TEST_F(Explanation, isNotWaitedForWhenTheStreamHangs) {
  rig.tag(1, TagState::Incomplete);
  rig.pass(499ms);
  EXPECT_EQ(rig.outcome(motion), nullptr);
  rig.pass(1ms);
  expectEnd(motion, motion_error::kMotionFailed, "false");
  rig.discardSent();
}

TEST_F(Explanation, isNotWaitedForWhenTheStreamStops) {
  rig.tag(1, TagState::Incomplete);
  rig.close("gone", link::Channel::Status);
  expectEnd(motion, motion_error::kMotionFailed, "false");
  rig.discardSent();
}

/// The controller closes the script port before the frame that shows the emergency stop.
TEST_F(Explanation, ofALostLinkIsTheEmergencyStop) {
  rig.close("the connection was closed by the peer");
  EXPECT_EQ(rig.outcome(motion), nullptr);
  EXPECT_EQ(rig.outcome(connect), nullptr);
  frame(StatusFrames().moving());
  frame(StatusFrames().emergencyStop());
  expectEnd(motion, motion_error::kLinkDropped, "emergency stop");
  EXPECT_THAT(rig.outcome(motion)->remedy, HasSubstr("Release the emergency stop"));
  expectEnd(connect, connect_error::kDisconnected, "emergency stop");
  EXPECT_THAT(rig.outcome(connect)->remedy, HasSubstr("Release the emergency stop"));
  EXPECT_FALSE(rig.connectionOpen(link::Channel::Status));
}

TEST_F(Explanation, isLookedForByABlockThatIsNotActiveAnyMore) {
  EXPECT_TRUE(rig.outputs(kBlock<MoveAbsoluteGoal>).active);
  rig.close("closed by the peer");
  EXPECT_TRUE(rig.outputs(kBlock<MoveAbsoluteGoal>).busy);
  EXPECT_FALSE(rig.outputs(kBlock<MoveAbsoluteGoal>).active);
  EXPECT_EQ(rig.progress(motion).back().phase, Phase::Stopping);
  EXPECT_THAT(rig.progress(motion).back().text,
              HasSubstr("failed, the connection was closed: closed by the peer"));
  EXPECT_TRUE(rig.outputs(kBlock<ConnectGoal>).busy);
  EXPECT_FALSE(rig.outputs(kBlock<ConnectGoal>).active);
  EXPECT_EQ(rig.progress(connect).back().phase, Phase::Connecting);
  EXPECT_THAT(rig.progress(connect).back().text, HasSubstr("the link was lost, the connection was closed"));
  frame(StatusFrames().moving());
  EXPECT_FALSE(rig.outputs(kBlock<MoveAbsoluteGoal>).active);
}

TEST_F(Explanation, ofALostLinkIsTheErrorOfAProjectThatStopsWithIt) {
  rig.close("closed by the peer");
  frame(StatusFrames().error(0x13, "PTP"));
  expectEnd(motion, own_error::kRobotError, "0x13");
  expectEnd(connect, connect_error::kDisconnected, "0x13: PTP");
}

TEST_F(Explanation, ofALostLinkIsTheProjectThatWasStopped) {
  const auto stopped = StatusFrames().with(protocol::item::ofBool("Project_Run", false));
  rig.close("closed by the peer");
  for (int i = 0; i < 3; ++i) frame(stopped);
  expectEnd(motion, motion_error::kLinkDropped, "the project was stopped");
  EXPECT_THAT(rig.outcome(motion)->remedy, HasSubstr("Start the project"));
  expectEnd(connect, connect_error::kDisconnected, "the project was stopped");
  EXPECT_THAT(rig.outcome(connect)->remedy, HasSubstr("Start the project"));
}

/// Each frame shows it.
TEST_F(Explanation, thatTheProjectWasStoppedIsToldOnceToWhatHasNothingAtTheController) {
  const Goal goals[] = {with<LoadPathGoal>([](auto& g) {
                          g.number_of_moves = 1;
                          g.path[0].termination_type = static_cast<int>(path::Termination::Blend);
                          g.path[0].command_tolerance = 2;
                        }),
                        with<FollowJointTrajectoryGoal>([](auto& g) { g.starts_in = 5; }),
                        good<WaitForInputGoal>(), good<WaitTimeGoal>(), with<PickAndPlaceGoal>([](auto& g) {
                          g.steps = {{CoreRig::move(), std::nullopt, std::nullopt, 60}};
                        })};
  for (const Goal& goal : goals) {
    CoreRig other(*arm::ArmModel::named("tm5-900"), link::LinkSettings{});
    other.connect();
    other.status(StatusFrames().input("Ctrl_DI3", false));
    const GoalId id = other.submit(goal);
    if (std::holds_alternative<PickAndPlaceGoal>(goal)) {
      other.reply(other.takeScript().id);
      other.tag(1);
      other.stream(StatusFrames());
    }
    ASSERT_TRUE(other.nothingSent() && other.outcome(id) == nullptr) << toString(blockOf(goal));
    other.close("closed by the peer");
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(other.outcome(id), nullptr);
      other.pass(15ms);
      other.status(StatusFrames().with(protocol::item::ofBool("Project_Run", false)));
    }
    ASSERT_NE(other.outcome(id), nullptr) << toString(blockOf(goal));
    const std::string told = other.outcome(id)->error_description;
    EXPECT_THAT(told, HasSubstr("the project was stopped: ")) << toString(blockOf(goal));
    EXPECT_EQ(told.find("the project"), told.rfind("the project")) << told;
    EXPECT_THAT(other.outcome(id)->remedy, HasSubstr("Start the project")) << toString(blockOf(goal));
    other.discardSent();
  }
}

TEST_F(Explanation, ofALostLinkWithoutOneIsTheLossItself) {
  rig.close("cable pulled");
  for (int i = 0; i < 3; ++i) frame(StatusFrames().moving());
  expectEnd(motion, motion_error::kLinkDropped, "cable pulled");
  expectEnd(connect, connect_error::kDisconnected, "cable pulled");
}

TEST_F(Explanation, ofALostLinkIsNotWaitedForWhenTheStreamHangs) {
  rig.close("cable pulled");
  rig.pass(500ms);
  expectEnd(motion, motion_error::kLinkDropped, "cable pulled");
  expectEnd(connect, connect_error::kDisconnected, "cable pulled");
}

TEST_F(Explanation, ofALostLinkIsNotWaitedForWhenTheStreamStopsToo) {
  rig.close("power off");
  rig.close("power off", link::Channel::Status);
  expectEnd(motion, motion_error::kLinkDropped, "power off");
  expectEnd(connect, connect_error::kDisconnected, "power off");
}

TEST_F(Explanation, comesAlsoToAMotionThatIsBeingStopped) {
  rig.cancel(motion);
  rig.takeScript();
  rig.close("closed by the peer");
  frame(StatusFrames().emergencyStop());
  expectEnd(motion, motion_error::kLinkDropped, "emergency stop");
}

TEST_F(Explanation, isNotWaitedForWhenTheLayerShutsDown) {
  rig.tag(1, TagState::Incomplete);
  rig.takeScript();
  rig.shutDown();
  ASSERT_NE(rig.outcome(motion), nullptr);
  EXPECT_EQ(rig.outcome(motion)->ending, Ending::CommandAborted);
  EXPECT_TRUE(rig.nothingSent());
}

TEST_F(Explanation, holdsBackWhatWaits) {
  const GoalId waiting = rig.submit(CoreRig::move(BufferMode::Buffered));
  rig.tag(1, TagState::Incomplete);
  rig.reply(rig.takeScript().id);
  frame(StatusFrames().error(0x13, "PTP"));
  EXPECT_EQ(rig.outcome(waiting)->ending, Ending::CommandAborted);
  EXPECT_TRUE(rig.nothingSent());
}

TEST_F(Explanation, comesAlsoToACycleInItsDwell) {
  for (const bool pressed : {true, false}) {
    CoreRig other(std::nullopt, link::LinkSettings{});
    other.connect();
    other.status(StatusFrames());
    PickAndPlaceGoal goal;
    goal.steps.push_back({CoreRig::move(), std::nullopt, std::nullopt, 60});
    const GoalId cycle = other.submit(goal);
    other.reply(other.takeScript().id);
    other.tag(1);
    other.status(StatusFrames());
    ASSERT_EQ(other.progress(cycle).back().phase, Phase::Dwelling);
    EXPECT_TRUE(other.outputs(kBlock<PickAndPlaceGoal>).active);
    other.close("closed by the peer");
    EXPECT_FALSE(other.outputs(kBlock<PickAndPlaceGoal>).active);
    EXPECT_EQ(other.progress(cycle).back().phase, Phase::Stopping);
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(other.outcome(cycle), nullptr);
      other.pass(15ms);
      other.status(pressed && i == 2 ? StatusFrames().emergencyStop() : StatusFrames());
    }
    ASSERT_NE(other.outcome(cycle), nullptr);
    EXPECT_EQ(other.outcome(cycle)->error_id, motion_error::kLinkDropped);
    EXPECT_THAT(other.outcome(cycle)->error_description,
                HasSubstr(pressed ? "emergency stop" : "closed by the peer"));
  }
}

TEST_F(Explanation, isNotWaitedForInADwellWhenTheStreamHangs) {
  rig.tag(1);
  rig.status(StatusFrames());
  PickAndPlaceGoal goal;
  goal.steps.push_back({CoreRig::move(), std::nullopt, std::nullopt, 60});
  const GoalId cycle = rig.submit(goal);
  rig.reply(rig.takeScript().id);
  rig.tag(2);
  rig.status(StatusFrames());
  rig.close("closed by the peer");
  rig.pass(500ms);
  ASSERT_NE(rig.outcome(cycle), nullptr);
  EXPECT_THAT(rig.outcome(cycle)->error_description, HasSubstr("closed by the peer"));
}

}  // namespace
}  // namespace cobot_command::testing
