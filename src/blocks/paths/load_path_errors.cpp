// The errors of path loading: those of the manual under their own, decimal numbers, and this layer's.
#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/path/path_refusal.h"

namespace cobot_command::blocks {
namespace {

namespace manual = load_path_error;
using namespace path::path_error;

constexpr const char* kCorrectThePoint = "Correct the point that error_index names";
constexpr const char* kOtherTarget = "Choose another target, configuration or interpolation for the point";
constexpr const char* kNeverFails = "cannot occur: transforms of frames that were checked do not fail";
constexpr const char* kOtherGeometry = "cannot occur: the arms have six joints in series";
constexpr const char* kReport = "Report this to the maintainers";
constexpr const char* kInternal = "cannot occur: what the manual calls so is an assertion here";

/// 1000 to 1007: of the layer, the link and the robot.
void addHandler(ErrorTable& table) {
  table
      .instead({{own_error::kQueueFull, manual::kNotRegistered},
                {own_error::kEmergencyStop, manual::kNotEnergised},
                {motion_error::kNotConnected, manual::kHandlerNotRunning},
                {motion_error::kLinkDropped, manual::kHandlerFaulted},
                {own_error::kRobotError, manual::kHandlerFaulted},
                {own_error::kNotListening, manual::kHandlerState},
                {own_error::kManualMode, manual::kManualMode}})
      .row(manual::kNotRegistered, "Method not registered", "Wait until a goal is done, or cancel one",
           "the queue of this layer is full; or too many goals wait for a file, or checks for planning")
      .row(manual::kHandlerNotRunning, "Robot handler not running",
           "Send a goal to connect, and wait until it is connected",
           "no connect goal is Busy, or its link is not established (yet)")
      .row(manual::kHandlerFaulted, "Robot handler faulted",
           "If the link was lost, send a goal to connect again; if the controller is in error, execute stop. "
           "Nothing resumes automatically",
           "the status stream shows an error of the controller that no stop has acknowledged; or the link "
           "dropped, or an emergency stop occurred, while the goal was Busy: error_index is then the active "
           "point")
      .row(manual::kHandlerState, "Robot handler not in a supported state",
           "Let the flow of the TMflow project enter its Listen node",
           "connected, but the flow is in another node; or the controller answered CPERR F1")
      .row(manual::kNotEnergised, "Robot not energised",
           "Release the emergency stop and start the project again",
           "the status stream shows an emergency stop, even if that has closed the script port")
      .row(manual::kManualMode, "Only in automatic external mode",
           "Switch the robot to automatic mode, or set ~path_in_manual_mode",
           "the status stream shows the manual mode, and ~path_in_manual_mode is false")
      .row(manual::kInterrupted, "Interrupted while loading", kExecuteAgain,
           "a stop, or a goal with buffer_mode ABORTING, arrived before the last point was loaded; "
           "error_index is the first point that was not loaded");
}

/// 1010 to 1032: what is wrong with the goal or a point by itself.
void addPoints(ErrorTable& table) {
  table
      .row(kMovesExceedArray, "Number of moves exceeds the array", kSetInRange,
           "number_of_moves is below 1, or above the number of points from start_index on; or path or poses "
           "has more than 1000")
      .row(kStartIndex, "Start index out of bounds", kSetInRange,
           "start_index is negative, or there is no such point")
      .row(kDynamics, "Speed, acceleration and deceleration must be above 0", kCorrectThePoint,
           "the first point of its kind (PTP, or not) gives no value above 0; or a value of any point is "
           "negative or not a number")
      .row(kJerk, "Jerk must be 0~100 %", kCorrectThePoint, "a jerk is outside 0..100, or not a number")
      .row(kOrientationDynamics, "Orientation speed, acceleration and deceleration must be above 0",
           kCorrectThePoint,
           "the first point that is not a PTP gives no value above 0; or a value of such a point is negative "
           "or not a number")
      .row(kMoveType, "Move type invalid", kCorrectThePoint, "move_type is neither 0 nor 1")
      .row(kTargetType, "Target point type invalid", kCorrectThePoint, "target_point_type is not 0, 1 or 2")
      .row(manual::kFirstNotAbsolute, "First target must be absolute without a transform",
           "Give joint targets, or provide the model and the position of the arm",
           "the model or the position of the arm is unknown, and the first Cartesian or hybrid target is "
           "INCREMENTAL")
      .row(kInterpolation, "Interpolation type invalid", kCorrectThePoint,
           "interpolation_type is not 0, 1, 2 or 3")
      .row(manual::kOnlyPtp, "Only PTP without a transform",
           "Use PTP to joint targets, or provide the model and the position of the arm",
           "the model or the position of the arm is unknown, and a point is not a PTP")
      .row(kTolerance, "Command tolerance must be finite and not negative", kCorrectThePoint,
           "BLEND with a command_tolerance that is negative, infinite or not a number")
      .row(kPtpTolerance, "Command tolerance of a PTP must be 0~100 %", kCorrectThePoint,
           "a PTP with BLEND and a command_tolerance above 100")
      .row(kTermination, "Termination type invalid", kCorrectThePoint, "termination_type is neither 0 nor 6")
      .row(kProfile, "Profile type invalid", kCorrectThePoint, "profile_type is not 0, 1, 2 or 3")
      .row(kConfiguration, "Robot configuration invalid", kCorrectThePoint,
           "robot_configuration is above 15; or its flip contradicts the sign of J5 of a hybrid target")
      .row(kPoseType, "Pose type invalid", kCorrectThePoint, "pose_type is neither 2 nor 3")
      .row(kReference, "Pose reference invalid", kCorrectThePoint, "ref_frame_type is not 0, 1 or 4")
      .row(kToolIndex, "Tool id out of range: 0~15", kCorrectThePoint, "TOOL and a pose_id outside 0..15")
      .row(kFrameIndex, "User frame id out of range: 0~15", kCorrectThePoint,
           "USER and a ref_frame_id outside 0..15")
      .row(kToolNotConfigured, "Tool not configured", "Write the tool into the table of tools",
           "TOOL, and the entry of the table is empty")
      .row(kFrameNotConfigured, "User frame not configured", "Write the frame into the table of frames",
           "USER, and the entry of the table is empty");
}

/// 1033 to 1061: what planning finds.
void addPlanning(ErrorTable& table) {
  table
      .row(kJointTarget, "Joint limits exceeded", kCorrectThePoint,
           "a joint target is outside its limits; see error_joint")
      .row(1034, "Folded robot limits exceeded", kReport, "cannot occur: an arm of six joints has none")
      .row(kIncrementInFrame, "Increment with respect to a frame or tool", "Give the target as ABSOLUTE",
           "INCREMENTAL, Cartesian or hybrid, with TOOL or USER")
      .row(1036, "Transform of the start failed", kReport, kNeverFails)
      .row(kTargetPose, "Target pose not valid", kCorrectThePoint,
           "a number of a target is not finite or beyond +-100000; or via_pose does not define a circle; or "
           "a pose of poses has a number that is not finite, a quaternion whose length differs from 1 by "
           "more than 0.001, or a coordinate of more than 100 m in the robot base")
      .row(kManyReferences, "More than 3 target references", "Divide the points among several goals",
           "the Cartesian and hybrid points of the goal refer to more than three frames")
      .row(1039, "Transform of the target failed", kReport, kNeverFails)
      .row(kWorldUnknown, "Target to robot frame",
           "Publish the frame to tf, or give the target in the robot base or USER",
           "WORLD, and the position of the robot in it is unknown; or tf does not connect the frame of a "
           "pose of poses with the robot base")
      .row(kToolUnknown, "Target tool invalid", "Give the tool by value, or tick it in the Ethernet Slave",
           "the entry of the table of tools is a name from the project whose value is unknown")
      .row(kFrameUnknown, "Target frame invalid", "Give the frame by value, or tick it in the Ethernet Slave",
           "the entry of the table of frames is a name from the project whose value is unknown")
      .row(kStartJoints, "Start joints out of range", "Move the arm into its limits with a PTP",
           "a point that is not a PTP begins outside the joint limits")
      .row(kNoSolution, "No solution for the target", kOtherTarget,
           "a PTP target can be reached, but not in the requested or kept posture")
      .row(kSingular, "Singularity", kOtherTarget,
           "a point that is not a PTP runs into a singularity; error_joint: 0 shoulder, 2 elbow, 4 wrist")
      .row(kReach, "Reach exceeded", kOtherTarget, "a point of the path is out of reach")
      .row(kJointLimit, "Joint limits exceeded on the way", kOtherTarget,
           "a joint would leave its limits at a Cartesian or hybrid target, or on the path to it")
      .row(kOtherConfiguration, "Cartesian interpolation cannot change the configuration", kOtherTarget,
           "the target of a point that is not a PTP has another posture or branch than its start")
      .row(1049, "Severe error", kReport, kInternal)
      .row(1050, "Internal error", kReport, kInternal)
      .row(1051, "Transform of the start failed", kReport, kNeverFails)
      .row(1052, "Transform of the output failed", kReport, kNeverFails)
      .row(1053, "Transform of the output failed", kReport, kNeverFails)
      .row(1055, "SCARA geometry", kReport, kOtherGeometry)
      .row(1056, "Rx and Ry must be 0", kReport, kOtherGeometry)
      .row(1057, "Delta geometry", kReport, kOtherGeometry)
      .row(kDisabledJoint, "Joint input must be 0 for a disabled joint", kCorrectThePoint,
           "joints[6..8] of a joint or hybrid target are not 0; see error_joint")
      .row(1059, "Internal error", kReport, kInternal)
      .row(1060, "Internal error", kReport, kInternal)
      .row(1061, "Transform failed", kReport, kNeverFails);
}

/// This layer's own, with the meaning that they have in all blocks.
void addOwn(ErrorTable& table) {
  table
      .shared({motion_error::kOtherBlockBusy, motion_error::kReceiveReply, motion_error::kRejected,
               motion_error::kReceiveTag, motion_error::kMotionFailed, own_error::kJointSpeed,
               own_error::kPlanningBudget, own_error::kNoFreeTag, own_error::kBufferModeUnknown,
               own_error::kTagLost, own_error::kCommunication, own_error::kStopNotConfirmed,
               own_error::kNotAtTarget, own_error::kOrphanMoves, own_error::kStoppedElsewhere,
               own_error::kShutDown})
      .underInterface()
      .inCell()
      .shared(own_error::kNotPlannable,
              "planning: the path would take more than 3 h, or is refused for another reason; see the "
              "description")
      .shared(own_error::kStartUnknown,
              "only PTP points, and the start of the path is unknown: no status stream, or the robot is in a "
              "motion, or paused in a motion, whose end is unknown. Then only joint targets can be sent, the "
              "first one ABSOLUTE, and nothing can be checked")
      .shared(own_error::kNoModel,
              "only PTP points, and the command layer has no model of the arm. Then only joint targets can "
              "be sent, and nothing can be checked")
      .row(own_error::kTrackingOffset, "Tracking not supported",
           "Set tracking_axis_position to 0, or enable no tracking",
           "tracking_axis_position is not 0 with an enabled tracking: tracking delays a path, and a script "
           "cannot follow a conveyor")
      .row(own_error::kNotInAScript, "Path cannot be expressed as a script",
           "Use execution AUTO or PVT, or set allow_approximation",
           "SCRIPT, and a script cannot express the points exactly, see the description; it cannot express a "
           "wrist move at all")
      .row(own_error::kPvtUnavailable, "PVT not available", "Provide the model and the position of the arm",
           "PVT, without check_only, and the model or the position of the arm is unknown")
      .row(own_error::kPathDeviates, "Path deviates",
           "Find out why the robot does not follow its path, or allow a larger max_deviation",
           "the status stream showed the moved frame further from the planned path than the goal's "
           "max_deviation; the robot is sent a stop command")
      .row(own_error::kExecutionUnknown, "Execution unknown", "Use 0 (AUTO), 1 (SCRIPT) or 2 (PVT)",
           "execution is none of these")
      .row(own_error::kRestNotPlanned, "Rest of the path cannot be planned",
           "Choose another feedrate, and send the points from error_index on again",
           "set_feedrate with restart has stopped the robot, and from its position there is no plan at this "
           "feedrate; see the description")
      .row(own_error::kPvtTooLong, "Too long for one PVT",
           "Let the robot stop at a point in between (STOP), or choose higher speeds",
           "points that blend into each other need more than 5000 points of a PVT, which is 125 s")
      .row(own_error::kDeviationRange, "Deviation range: 0~100000 mm", kSetInRange,
           "max_deviation is negative, above 100000, or not a number; 0 means none")
      .row(own_error::kPathUnreadable, "Path cannot be read",
           "Check the path of the file, and compare its format with config/path.yaml",
           "path_file does not exist, is not YAML, or has fields that a point does not have; or path or "
           "poses is also given")
      .row(own_error::kPoseTemplate, "Template of the poses unsuitable",
           "Give one point in path that defines everything except the position: see poses in doc/path.md",
           "poses, and path does not contain exactly one point; or this point has a target of its own, is "
           "INCREMENTAL, HYBRID, CP_CIRCULAR or in USER, or its move_id plus the index of a pose is out of "
           "range");
}

}  // namespace

ErrorTable LoadPathGoal::errors() {
  ErrorTable table;
  addHandler(table);
  addPoints(table);
  addPlanning(table);
  addOwn(table);
  return table;
}

}  // namespace cobot_command::blocks
