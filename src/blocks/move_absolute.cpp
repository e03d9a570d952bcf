#include "move_absolute.h"

#include <algorithm>
#include <cmath>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/units.h"

namespace cobot_command::blocks {
namespace {

using protocol::DataFormat;

DataFormat formatOf(const MoveAbsoluteGoal& goal) {
  using Target = DataFormat::Target;
  using Speed = DataFormat::Speed;
  using Blending = DataFormat::Blending;
  switch (static_cast<AbsoluteFormat>(goal.data_format)) {
    case AbsoluteFormat::Jpp:
      return {Target::Joint, Speed::Percent, Blending::Percent};
    case AbsoluteFormat::Cpr:
      return {Target::Cartesian, Speed::Percent, Blending::Radius};
    case AbsoluteFormat::Cap:
      return {Target::Cartesian, Speed::Absolute, Blending::Percent};
    case AbsoluteFormat::Car:
      return {Target::Cartesian, Speed::Absolute, Blending::Radius};
    case AbsoluteFormat::Cpp:
      break;
  }
  return {Target::Cartesian, Speed::Percent, Blending::Percent};
}

int rounded(double value) {
  return static_cast<int>(std::lround(value));
}

protocol::MotionOptions optionsOf(const MoveAbsoluteGoal& goal) {
  protocol::MotionOptions options;
  options.speed = std::max(1, rounded(goal.speed));
  options.accel_time = rounded(goal.accel_time);
  options.blending = goal.blending_enable ? rounded(goal.blending_value) : 0;
  options.disable_precise_positioning = !goal.precise_positioning;
  return options;
}

bool isLine(const MoveAbsoluteGoal& goal) {
  return goal.movement_command == static_cast<int>(Movement::Line);
}

}  // namespace

std::vector<protocol::ScriptCommand> scriptOf(const MoveAbsoluteGoal& goal, std::optional<int> tag) {
  std::vector<protocol::ScriptCommand> script;
  if (isLine(goal)) {
    script.emplace_back(protocol::Line{formatOf(goal), goal.target, optionsOf(goal)});
  } else {
    protocol::Ptp ptp{formatOf(goal), goal.target, optionsOf(goal), std::nullopt};
    if (goal.robot_pose_enable) ptp.pose_bits = goal.robot_pose;
    script.emplace_back(std::move(ptp));
  }
  if (tag) script.emplace_back(protocol::QueueTag{*tag, false});
  if (goal.exit_node) script.emplace_back(protocol::ScriptExit{});
  return script;
}

motion::Command motionOf(const MoveAbsoluteGoal& goal) {
  const protocol::MotionOptions options = optionsOf(goal);
  const DataFormat format = formatOf(goal);
  const Duration time_to_top_speed = std::chrono::milliseconds(options.accel_time);
  if (isLine(goal)) {
    motion::PathSpeed speed = motion::SpeedRatio{options.speed / 100.0};
    if (format.speed == DataFormat::Speed::Absolute) speed = motion::TcpSpeed{mmToM(options.speed)};
    return motion::Line{arm::toPose(goal.target), speed, time_to_top_speed};
  }
  motion::Ptp ptp;
  ptp.speed_ratio = options.speed / 100.0;
  ptp.time_to_top_speed = time_to_top_speed;
  if (format.target == DataFormat::Target::Joint) {
    ptp.target = arm::toJointVector(goal.target);
    return ptp;
  }
  motion::PoseTarget target{arm::toPose(goal.target), std::nullopt};
  if (goal.robot_pose_enable) {
    target.bits = arm::PoseBits::fromNumbers(goal.robot_pose[0], goal.robot_pose[1], goal.robot_pose[2]);
  }
  ptp.target = target;
  return ptp;
}

}  // namespace cobot_command::blocks
