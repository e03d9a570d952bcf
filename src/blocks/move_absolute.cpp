#include "cobot_command/blocks/move_absolute.h"

#include "shared/framed_pose.h"
#include "shared/motion_parameters.h"
#include "shared/moved_frames.h"
#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::blocks {
namespace {

constexpr std::array<std::string_view, 5> kAbsoluteNames{"JPP", "CPP", "CPR", "CAP", "CAR"};
constexpr FormatList kAbsoluteFormats(kAbsoluteNames);

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

ErrorTable MoveAbsoluteGoal::errors() {
  return ErrorTable()
      .thesisCommand()
      .anyCommand()
      .turn()
      .underInterface()
      .inCell()
      .move()
      .framedPose()
      .row(motion_error::kPoseWithLine, "Robot Pose must be disabled for Line command", kSetInRange,
           "robot_pose_enable with Line, which keeps the configuration of its start")
      .row(motion_error::kPose1Range, "Pose1 range is 0~1", kSetInRange,
           "robot_pose_enable and config1 is neither 0 (RIGHTY) nor 1 (LEFTY)")
      .row(motion_error::kPose2Range, "Pose2 range is 2~3", kSetInRange,
           "robot_pose_enable and config2 is neither 2 (ABOVE) nor 3 (BELOW)")
      .row(motion_error::kPose3Range, "Pose3 range is 4~5", kSetInRange,
           "robot_pose_enable and config3 is neither 4 (NOFLIP) nor 5 (FLIP)")
      .row(motion_error::kFormatForPtp, "DataFormat invalid for PTP command", kSetInRange,
           "PTP with a data_format other than JPP (0) or CPP (1), known or unknown")
      .row(motion_error::kFormatForLine, "DataFormat invalid for Line command", kSetInRange,
           "Line with a data_format other than CPP (1), CPR (2), CAP (3) or CAR (4), known or unknown")
      .row(own_error::kPoseWithJoints, "Robot Pose must be disabled for a target in joints",
           "Disable robot_pose_enable, or use CPP",
           "robot_pose_enable with PTP JPP: the joints define the configuration")
      .row(own_error::kPoseNeedsCartesian, "A pose needs a Cartesian DataFormat",
           "Use a format that begins with C, or give the joints in target_position",
           "target_pose with JPP: a pose is not a joint target")
      .shared({own_error::kBlendingTooLarge, own_error::kMovementUnknown});
}

std::optional<script::DataFormat> formatOf(const MoveAbsoluteGoal& goal) {
  return kAbsoluteFormats.at(goal.data_format);
}

GoalTraits traitsOf(const MoveAbsoluteGoal& goal) {
  GoalTraits traits = traitsOfMove(goal);
  traits.needs_base = goal.target_pose.has_value();
  return traits;
}

std::vector<Failure> check(const MoveAbsoluteGoal& goal) {
  ParameterChecks checks;
  checkMotion(checks, parametersOf(goal), formatOf(goal));
  checkRobotPose(checks, goal);
  checkMovement(checks, goal.movement_command, goal.data_format, kAbsoluteFormats,
                motion_error::kFormatForPtp, motion_error::kFormatForLine);
  if (goal.target_pose) {
    checks.require(!isInJoints(goal), own_error::kPoseNeedsCartesian, "target_pose with data_format JPP");
    checkPose(checks, "target_pose", *goal.target_pose);
  } else {
    checks.sixValues("target_position", goal.target);
  }
  return std::move(checks).violations();
}

std::optional<Failure> findMovedFrame(const MoveAbsoluteGoal& goal, const FrameFinder& finder) {
  return findMovedFrame("target_pose", goal.target_pose, finder);
}

Order orderOf(const MoveAbsoluteGoal& goal, const arm::Pose& base) {
  const script::DataFormat format = formatOf(goal).value_or(script::DataFormat{});
  const SixValues target = targetOf(goal.target, goal.target_pose, base);
  const script::MotionOptions options = optionsOf(parametersOf(goal));
  if (isLine(goal)) return moveOrder(script::Line{format, target, options});
  script::Ptp ptp{format, target, options, std::nullopt};
  if (goal.robot_pose_enable) ptp.pose_bits = goal.robot_pose;
  return moveOrder(ptp);
}

}  // namespace cobot_command::blocks
