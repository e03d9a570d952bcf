// A good goal, one thing changed.

#include "block_goals.h"
#include "catalogue_scenarios.h"

#include "cobot_command/blocks/shared/failure.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;

template <class Goal>
Block blockOf() {
  return static_cast<Block>(blocks::Goal(Goal{}).index());
}

template <class Goal, class Change>
void refused(Scenarios& all, int id, const Change& change) {
  all[{blockOf<Goal>(), id}] = [=] { return toRejection(blockOf<Goal>(), check(with<Goal>(change))); };
}

template <class Goal>
void refusedSix(Scenarios& all, SixValues Goal::*six) {
  refused<Goal>(all, own_error::kNotFinite, [=](auto& g) { (g.*six)[0] = kNan; });
  refused<Goal>(all, own_error::kCoordinateRange, [=](auto& g) { (g.*six)[5] = 1e9; });
}

template <class Goal>
void refusedPose(Scenarios& all, std::optional<FramedPose> Goal::*pose) {
  refused<Goal>(all, own_error::kFrameUnknown, [=](auto& g) { g.*pose = FramedPose{}; });
  refused<Goal>(all, own_error::kQuaternion, [=](auto& g) {
    g.*pose = framedPose();
    (g.*pose)->quaternion = {};
  });
}

template <class Goal>
void refusedMove(Scenarios& all, int format_with_mm) {
  refused<Goal>(all, motion_error::kSpeedRangeAbsolute, [=](auto& g) {
    g.data_format = format_with_mm;
    g.speed = 5000;
  });
  refused<Goal>(all, motion_error::kSpeedRangePercent, [](auto& g) { g.speed = 101; });
  refused<Goal>(all, motion_error::kAccelTimeRange, [](auto& g) { g.accel_time = 1; });
  refused<Goal>(all, own_error::kBlendingRange, [](auto& g) {
    g.blending_enable = true;
    g.blending_value = 101;
  });
}

template <class... Goals>
void refusedCommandId(Scenarios& all) {
  (refused<Goals>(all, motion_error::kCommandIdRange, [](auto& g) { g.command_id = 1; }), ...);
}

template <class... Goals>
void refusedBufferMode(Scenarios& all) {
  (refused<Goals>(all, own_error::kBufferModeUnknown, [](auto& g) { g.buffer_mode = 3; }), ...);
}

void refusedMoveAbsolute(Scenarios& all) {
  using Goal = MoveAbsoluteGoal;
  refusedMove<Goal>(all, static_cast<int>(AbsoluteFormat::Cap));
  refusedSix(all, &Goal::target);
  refusedPose(all, &Goal::target_pose);
  refused<Goal>(all, own_error::kMovementUnknown, [](auto& g) { g.movement_command = 2; });
  refused<Goal>(all, motion_error::kFormatForPtp, [](auto& g) { g.data_format = 4; });
  refused<Goal>(all, motion_error::kFormatForLine, [](auto& g) { g.movement_command = g.data_format = 0; });
  refused<Goal>(all, own_error::kPoseNeedsCartesian, [](auto& g) {
    g.data_format = 0;
    g.target_pose = framedPose();
  });
  const auto posed = [&](int id, std::array<int, 3> pose, int movement, int format) {
    refused<Goal>(all, id, [=](auto& g) {
      g.robot_pose_enable = true;
      g.robot_pose = pose;
      g.movement_command = movement;
      g.data_format = format;
    });
  };
  posed(motion_error::kPoseWithLine, {0, 2, 4}, 0, 1);
  posed(motion_error::kPose1Range, {2, 2, 4}, 1, 1);
  posed(motion_error::kPose2Range, {0, 0, 4}, 1, 1);
  posed(motion_error::kPose3Range, {0, 2, 0}, 1, 1);
  posed(own_error::kPoseWithJoints, {0, 2, 4}, 1, 0);
}

void refusedOtherMoves(Scenarios& all) {
  refusedMove<MoveRelativeGoal>(all, static_cast<int>(RelativeFormat::Tap));
  refusedSix(all, &MoveRelativeGoal::target);
  refused<MoveRelativeGoal>(all, own_error::kMovementUnknown, [](auto& g) { g.movement_command = 2; });
  refused<MoveRelativeGoal>(all, relative_error::kFormatForPtp, [](auto& g) { g.data_format = 6; });
  refused<MoveRelativeGoal>(all, relative_error::kFormatForLine,
                            [](auto& g) { g.movement_command = g.data_format = 0; });
  refusedMove<MoveCircleGoal>(all, static_cast<int>(CircleFormat::Cap));
  refusedSix(all, &MoveCircleGoal::arc_point);
  refusedPose(all, &MoveCircleGoal::end_pose);
  refused<MoveCircleGoal>(all, own_error::kArcAngleRange, [](auto& g) { g.arc_angle = 361; });
  refused<MoveCircleGoal>(all, own_error::kFormatForCircle, [](auto& g) { g.data_format = 2; });
}

void refusedOthers(Scenarios& all) {
  refusedSix(all, &ChangeBaseGoal::transformation);
  refusedPose(all, &ChangeBaseGoal::base_pose);
  refused<ChangeBaseGoal>(all, own_error::kNameInvalid, [](auto& g) { g.base_name = "\n"; });
  refusedSix(all, &ChangeTcpGoal::tcp_offset);
  refused<ChangeTcpGoal>(all, own_error::kNameInvalid, [](auto& g) { g.tcp_name = "\n"; });
  refused<ChangeTcpGoal>(all, tcp_error::kWeightRange, [](auto& g) { g.weight = 15; });
  refused<ChangeTcpGoal>(all, own_error::kInertiaRange, [](auto& g) { g.moment_of_inertia[2] = -1; });
  refused<ChangeLoadGoal>(all, own_error::kLoadRange, [](auto& g) { g.weight = 15; });
  refused<SetOutputGoal>(all, own_error::kOutputInvalid, [](auto& g) { g.output = 4; });
  refused<SetOutputGoal>(all, own_error::kOutputValue, [](auto& g) { g.value = 2; });
  refused<WaitForInputGoal>(all, own_error::kInputInvalid, [](auto& g) { g.module = "Box"; });
  refused<WaitForInputGoal>(all, own_error::kWaitRange, [](auto& g) { g.timeout = -1; });
  refused<WaitTimeGoal>(all, wait_error::kTime, [](auto& g) { g.time = -1; });
  refused<ProgramControlGoal>(all, own_error::kProgramCommandUnknown, [](auto& g) { g.command = 2; });
  refused<RunScriptGoal>(all, own_error::kScriptInvalid, [](auto& g) { g.script = ""; });
  refused<RunScriptGoal>(all, own_error::kReplyTimeoutRange, [](auto& g) { g.reply_timeout = 0.01; });
}

}  // namespace

Scenarios parameterScenarios() {
  Scenarios all;
  refusedMoveAbsolute(all);
  refusedOtherMoves(all);
  refusedOthers(all);
  refusedCommandId<MoveAbsoluteGoal, MoveRelativeGoal, MoveCircleGoal, ChangeBaseGoal, ChangeTcpGoal,
                   ProgramControlGoal>(all);
  refusedBufferMode<MoveAbsoluteGoal, MoveRelativeGoal, MoveCircleGoal, ChangeBaseGoal, ChangeTcpGoal,
                    ChangeLoadGoal, SetOutputGoal, WaitForInputGoal, WaitTimeGoal, ExitListenNodeGoal,
                    RunScriptGoal>(all);
  return all;
}

}  // namespace cobot_command::testing
