// A target in a tf frame, and a frame that moves while the goal waits: a pallet, or the robot on its vehicle.

#include <functional>

#include "block_goals.h"
#include "core_rig.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::AllOf;
using ::testing::HasSubstr;

FramedPose onTheTable() {
  FramedPose pose = framedPose();
  pose.latest = true;
  return pose;
}

/// The robot, with an active base that is known: targets in frames need one.
StatusFrames standing() {
  return StatusFrames().with(protocol::item::ofFloats("Base_Value", {0, 0, 0, 0, 0, 0}));
}

MoveAbsoluteGoal toTheTable() {
  MoveAbsoluteGoal goal = CoreRig::move(BufferMode::Buffered);
  goal.target_pose = onTheTable();
  return goal;
}

PickAndPlaceGoal cycleWithTheTableIn(std::size_t step) {
  PickAndPlaceGoal goal;
  goal.steps.resize(3);
  for (auto& each : goal.steps) each.move = CoreRig::move();
  goal.steps[step].move.target_pose = onTheTable();
  goal.buffer_mode = static_cast<int>(BufferMode::Buffered);
  return goal;
}

class MovedFrames : public ::testing::Test {
 protected:
  MovedFrames() {
    rig.connect();
    rig.status(standing());
    rig.frames["table"] = *framedPose().frame_in_robot_base;
  }

  /// A motion that others wait behind; its end is told by finishMotion().
  void startMotion() {
    rig.submit(CoreRig::move());
    rig.reply(rig.takeScript().id);
  }
  void finishMotion() {
    rig.tag(rig.latest().open_tags.at(0));
    rig.status(standing());
  }

  void pushTable(double metres) { rig.frames["table"].translation().x() += metres; }
  void turnTable(double degrees) {
    rig.frames["table"].rotate(Eigen::AngleAxisd(degToRad(degrees), Eigen::Vector3d::UnitZ()));
  }
  /// The end of a goal that waited while `change` happened.
  Outcome afterWaiting(const Goal& goal, const std::function<void()>& change) {
    startMotion();
    const GoalId id = rig.submit(goal);
    change();
    finishMotion();
    EXPECT_NE(rig.outcome(id), nullptr);
    return rig.outcome(id) == nullptr ? Outcome{} : *rig.outcome(id);
  }
  /// Whether it is sent when its turn comes.
  bool isSentAfter(const Goal& goal, const std::function<void()>& change) {
    startMotion();
    const GoalId id = rig.submit(goal);
    change();
    finishMotion();
    const bool sent = !rig.nothingSent() && rig.outcome(id) == nullptr;
    if (sent) {
      rig.reply(rig.takeScript().id);
      finishMotion();
    }
    return sent;
  }

  CoreRig rig{std::nullopt, link::LinkSettings{}};
};

TEST_F(MovedFrames, refuseAGoalThatHasWaitedAndSayHowFarTheTargetWent) {
  const Outcome outcome = afterWaiting(toTheTable(), [this] { pushTable(0.0123); });
  EXPECT_EQ(outcome.ending, Ending::Rejected);
  EXPECT_EQ(outcome.error_id, own_error::kFrameMoved);
  EXPECT_THAT(outcome.error_description,
              AllOf(HasSubstr("target_pose is in \"table\""), HasSubstr("12.3 mm")));
  EXPECT_TRUE(rig.nothingSent());
}

TEST_F(MovedFrames, letAGoalGoThatHasWaitedWhileTheFrameStood) {
  EXPECT_TRUE(isSentAfter(toTheTable(), [] {}));
}

TEST_F(MovedFrames, areThoseWhoseTargetIsAMillimetreOrATenthOfADegreeAway) {
  EXPECT_TRUE(isSentAfter(toTheTable(), [this] { pushTable(0.0009); }));
  EXPECT_FALSE(isSentAfter(toTheTable(), [this] { pushTable(0.0011 - 0.0009); }));
}

TEST_F(MovedFrames, areFoundByTheirTurnWhereTheTargetHardlyMoves) {
  MoveAbsoluteGoal goal = toTheTable();
  goal.target_pose->position = {0, 0, 0};
  EXPECT_TRUE(isSentAfter(goal, [this] { turnTable(0.09); }));
  EXPECT_FALSE(isSentAfter(goal, [this] { turnTable(0.02); }));
}

TEST_F(MovedFrames, areFoundByWhatATurnOfFarAwayMakesOfTheTarget) {
  MoveAbsoluteGoal goal = toTheTable();
  goal.target_pose->position = {2, 0, 0};  // 0.05 degrees of it are 1.7 mm
  EXPECT_FALSE(isSentAfter(goal, [this] { turnTable(0.05); }));
}

TEST_F(MovedFrames, refuseAGoalWhoseFrameIsNotKnownAnyMore) {
  const Outcome outcome = afterWaiting(toTheTable(), [this] { rig.frames.clear(); });
  EXPECT_EQ(outcome.ending, Ending::Rejected);
  EXPECT_EQ(outcome.error_id, own_error::kFrameUnknown);
  EXPECT_THAT(outcome.error_description, HasSubstr("\"table\", which is no longer known"));
}

TEST_F(MovedFrames, doNotMatterToAGoalThatAsksForATime) {
  MoveAbsoluteGoal goal = toTheTable();
  goal.target_pose->latest = false;
  EXPECT_TRUE(isSentAfter(goal, [this] { pushTable(1); }));
}

TEST_F(MovedFrames, areNotLookedForWhenAGoalStartsAtOnce) {
  pushTable(1);
  const GoalId id = rig.submit(toTheTable());
  EXPECT_EQ(rig.outcome(id), nullptr);
  rig.reply(rig.takeScript().id);
  finishMotion();
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Done);
}

TEST_F(MovedFrames, areFoundWhenAGoalTakesOverAndHasToWaitForTheStop) {
  startMotion();
  MoveAbsoluteGoal goal = toTheTable();
  goal.buffer_mode = static_cast<int>(BufferMode::Aborting);
  const GoalId id = rig.submit(goal);
  pushTable(0.1);
  rig.reply(rig.takeScript().id);
  rig.stream(standing());
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->error_id, own_error::kFrameMoved);
}

TEST_F(MovedFrames, refuseACircleAndAChangeOfBaseByTheFieldThatIsMeant) {
  auto circle = good<MoveCircleGoal>();
  circle.end_pose = onTheTable();
  circle.buffer_mode = static_cast<int>(BufferMode::Buffered);
  EXPECT_THAT(afterWaiting(circle, [this] { pushTable(0.1); }).error_description,
              HasSubstr("end_pose is in"));
  auto base = good<ChangeBaseGoal>();
  base.base_pose = onTheTable();
  base.buffer_mode = static_cast<int>(BufferMode::Buffered);
  EXPECT_THAT(afterWaiting(base, [this] { pushTable(0.1); }).error_description, HasSubstr("base_pose is in"));
}

TEST_F(MovedFrames, takeWithThemWhatWaitsBehind) {
  startMotion();
  rig.submit(toTheTable());
  const GoalId behind = rig.submit(CoreRig::move(BufferMode::Buffered));
  pushTable(0.1);
  finishMotion();
  ASSERT_NE(rig.outcome(behind), nullptr);
  EXPECT_EQ(rig.outcome(behind)->ending, Ending::CommandAborted);
  EXPECT_THAT(rig.outcome(behind)->error_description, HasSubstr("move_absolute, was refused"));
}

TEST_F(MovedFrames, refuseACycleThatHasWaitedBeforeItsFirstMove) {
  const Outcome outcome = afterWaiting(cycleWithTheTableIn(2), [this] { pushTable(0.1); });
  EXPECT_EQ(outcome.ending, Ending::Rejected);
  EXPECT_EQ(outcome.error_id, own_error::kStepRefused);
  EXPECT_EQ(outcome.detail.as<CycleReport>().failed_step, 2);
  ASSERT_EQ(outcome.detail.as<CycleReport>().steps.size(), 3u);
  EXPECT_EQ(outcome.detail.as<CycleReport>().steps[2].error_id, own_error::kFrameMoved);
  EXPECT_THAT(outcome.error_description, HasSubstr("step 3 of 3: 16#20B Frame moved"));
}

TEST_F(MovedFrames, endACycleAtTheStepWhoseTargetHasMoved) {
  const GoalId id = rig.submit(cycleWithTheTableIn(1));
  rig.reply(rig.takeScript().id);
  pushTable(0.1);
  finishMotion();
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Aborted);
  EXPECT_EQ(rig.outcome(id)->detail.as<CycleReport>().failed_step, 1);
  EXPECT_EQ(rig.outcome(id)->detail.as<CycleReport>().steps.at(1).error_id, own_error::kFrameMoved);
  EXPECT_TRUE(rig.nothingSent());
}

}  // namespace
}  // namespace cobot_command::testing
