#include "error_tables.h"

#include "cobot_command/blocks/error_ids.h"

namespace cobot_command::blocks {

std::vector<ErrorEntry> moveAbsoluteErrors() {
  return ErrorTable(Block::MoveAbsolute)
      .thesisCommand()
      .anyCommand()
      .turn()
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
           "robot_pose_enable with PTP JPP: the joints say the configuration")
      .row(own_error::kPoseNeedsCartesian, "A pose needs a Cartesian DataFormat",
           "Use a format that begins with C, or give the joints in target_position",
           "target_pose with JPP: a pose is no target in joints")
      .shared({own_error::kBlendingTooLarge, own_error::kMovementUnknown})
      .rows();
}

}  // namespace cobot_command::blocks
