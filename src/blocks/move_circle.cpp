#include "cobot_command/blocks/move_circle.h"

#include <algorithm>
#include <cmath>

#include "shared/framed_pose.h"
#include "shared/motion_parameters.h"
#include "shared/moved_frames.h"
#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::blocks {
namespace {

constexpr std::array<std::string_view, 2> kCircleNames{"CPP", "CAP"};
constexpr FormatList kCircleFormats(kCircleNames);
constexpr double kMaxArcAngle = 360;

void checkPoint(ParameterChecks& checks, const char* values_field, const SixValues& values,
                const char* pose_field, const std::optional<FramedPose>& pose) {
  if (pose) {
    checkPose(checks, pose_field, *pose);
  } else {
    checks.sixValues(values_field, values);
  }
}

/// Whole degrees. 0 has a meaning of its own, so the smallest arc is one degree.
int arcAngleOf(const MoveCircleGoal& goal) {
  if (goal.arc_angle == 0) return 0;
  return std::max(1, static_cast<int>(std::lround(goal.arc_angle)));
}

}  // namespace

ErrorTable MoveCircleGoal::errors() {
  return ErrorTable()
      .thesisCommand()
      .anyCommand()
      .turn()
      .underInterface()
      .inCell()
      .move()
      .framedPose()
      .row(own_error::kArcAngleRange, "ArcAngle range: 0~360 degrees", kSetInRange,
           "arc_angle is negative, above 360, or not a number")
      .row(own_error::kFormatForCircle, "DataFormat invalid for Circle command", "Use 0 (CPP) or 1 (CAP)",
           "data_format is neither 0 nor 1");
}

std::optional<script::DataFormat> formatOf(const MoveCircleGoal& goal) {
  return kCircleFormats.at(goal.data_format);
}

GoalTraits traitsOf(const MoveCircleGoal& goal) {
  GoalTraits traits = traitsOfMove(goal);
  traits.needs_base = goal.arc_pose || goal.end_pose;
  return traits;
}

std::vector<Failure> check(const MoveCircleGoal& goal) {
  ParameterChecks checks;
  const auto format = formatOf(goal);
  checkMotion(checks, parametersOf(goal), format);
  checkPoint(checks, "arc_point", goal.arc_point, "arc_pose", goal.arc_pose);
  checkPoint(checks, "end_point", goal.end_point, "end_pose", goal.end_pose);
  checks.require(isWithin(goal.arc_angle, 0, kMaxArcAngle), own_error::kArcAngleRange,
                 fmt::format("arc_angle is {}", goal.arc_angle));
  checks.require(format.has_value(), own_error::kFormatForCircle, kCircleFormats.found(goal.data_format));
  return std::move(checks).violations();
}

std::optional<Failure> findMovedFrame(const MoveCircleGoal& goal, const FrameFinder& finder) {
  if (auto moved = findMovedFrame("arc_pose", goal.arc_pose, finder)) return moved;
  return findMovedFrame("end_pose", goal.end_pose, finder);
}

Order orderOf(const MoveCircleGoal& goal, const arm::Pose& base) {
  return moveOrder(script::Circle{
      formatOf(goal).value_or(script::DataFormat{}), targetOf(goal.arc_point, goal.arc_pose, base),
      targetOf(goal.end_point, goal.end_pose, base), optionsOf(parametersOf(goal)), arcAngleOf(goal)});
}

}  // namespace cobot_command::blocks
