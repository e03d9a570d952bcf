// CBT_MoveAbsolute (thesis 5.3.2).

#include "framed_pose.h"
#include "motion_parameters.h"
#include <fmt/format.h>

#include "cobot_command/blocks/error_ids.h"

namespace cobot_command::blocks {
namespace {

constexpr std::array<std::string_view, 5> kFormatNames{"JPP", "CPP", "CPR", "CAP", "CAR"};
constexpr FormatList kFormats(kFormatNames);

bool isLine(const MoveAbsoluteGoal& goal) {
  return goal.movement_command == static_cast<int>(Movement::Line);
}

bool isInJoints(const MoveAbsoluteGoal& goal) {
  return goal.data_format == static_cast<int>(AbsoluteFormat::Jpp);
}

void checkRobotPose(ParameterChecks& checks, const MoveAbsoluteGoal& goal) {
  if (!goal.robot_pose_enable) return;
  const auto& [config1, config2, config3] = goal.robot_pose;
  checks.require(!isLine(goal), motion_error::kPoseWithLine, "");
  checks.require(config1 == 0 || config1 == 1, motion_error::kPose1Range,
                 fmt::format("config1 is {}", config1));
  checks.require(config2 == 2 || config2 == 3, motion_error::kPose2Range,
                 fmt::format("config2 is {}", config2));
  checks.require(config3 == 4 || config3 == 5, motion_error::kPose3Range,
                 fmt::format("config3 is {}", config3));
  const bool ptp = goal.movement_command == static_cast<int>(Movement::Ptp);
  checks.require(!ptp || !isInJoints(goal), own_error::kPoseWithJoints, "");
}

}  // namespace

CommandTraits traitsOf(const MoveAbsoluteGoal& goal) {
  CommandTraits traits = traitsOfMove(goal);
  traits.needs_base = goal.target_pose.has_value();
  return traits;
}

std::vector<Failure> check(const MoveAbsoluteGoal& goal) {
  ParameterChecks checks;
  checkMotion(checks, parametersOf(goal), kFormats.at(goal.data_format));
  checkRobotPose(checks, goal);
  checkMovement(checks, goal.movement_command, goal.data_format, kFormats, motion_error::kFormatForPtp,
                motion_error::kFormatForLine);
  if (goal.target_pose) {
    checks.require(!isInJoints(goal), own_error::kPoseNeedsCartesian, "target_pose with data_format JPP");
    checkPose(checks, "target_pose", *goal.target_pose);
  } else {
    checks.sixValues("target_position", goal.target);
  }
  return std::move(checks).violations();
}

script::ScriptCommand commandOf(const MoveAbsoluteGoal& goal, const arm::Pose& base) {
  const script::DataFormat format = kFormats.at(goal.data_format).value_or(script::DataFormat{});
  const SixValues target = targetOf(goal.target, goal.target_pose, base);
  const script::MotionOptions options = optionsOf(parametersOf(goal));
  if (isLine(goal)) return script::Line{format, target, options};
  script::Ptp ptp{format, target, options, std::nullopt};
  if (goal.robot_pose_enable) ptp.pose_bits = goal.robot_pose;
  return ptp;
}

}  // namespace cobot_command::blocks
