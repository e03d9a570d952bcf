#include "catalogue_tables.h"

#include "cobot_command/blocks/error_ids.h"

namespace cobot_command::blocks {
namespace {

constexpr Block kBlock = Block::MoveAbsolute;
constexpr const char* kWiring = "Check Ethernet connection wiring";
constexpr const char* kRange = "Set parameter in acceptable range";
constexpr const char* kAgain = "Re-execution is required";
constexpr const char* kConnect = "Use CBT_Connect FB for connection";
constexpr const char* kNoStep = "cannot occur any more: there is no such step, bytes are read as they come";

std::vector<ErrorEntry> thesisErrors() {
  return {
      {kBlock, motion_error::kNotConnected, "Robot not connected", kConnect,
       "no connect goal is Busy, or its link is not established (yet)"},
      {kBlock, motion_error::kOtherBlockBusy, "Other FB is under execution", "Wait until other FB is done",
       "another command is Busy; a blended motion is not any more once the controller has accepted it"},
      {kBlock, motion_error::kClearBuffer, "Clear buffer error", kWiring, kNoStep},
      {kBlock, motion_error::kSpeedRangeAbsolute, "Speed range in Line: 0~4500 mm/s", kRange,
       "a format with speed in mm/s (CAP, CAR): speed is not above 0, above 4500, or not a number"},
      {kBlock, motion_error::kSpeedRangePercent, "Speed range in PTP: 0~100 %", kRange,
       "a format with speed in % (JPP, CPP, CPR), PTP or Line: speed is negative, above 100, or not a "
       "number"},
      {kBlock, motion_error::kAccelTimeRange, "Acceleration Time range is: 150~9999 ms", kRange,
       "accel_time is below 150, above 9999, or not a number"},
      {kBlock, motion_error::kCommandIdRange, "Command ID range is: 2~9", kRange,
       "command_id is neither 0 (the layer chooses) nor 2..9"},
      {kBlock, motion_error::kPoseWithLine, "Robot Pose must be disabled for Line command", kRange,
       "robot_pose_enable with Line, which keeps the configuration of its start"},
      {kBlock, motion_error::kPose1Range, "Pose1 range is 0~1", kRange,
       "robot_pose_enable and config1 is neither 0 (RIGHTY) nor 1 (LEFTY)"},
      {kBlock, motion_error::kPose2Range, "Pose2 range is 2~3", kRange,
       "robot_pose_enable and config2 is neither 2 (ABOVE) nor 3 (BELOW)"},
      {kBlock, motion_error::kPose3Range, "Pose3 range is 4~5", kRange,
       "robot_pose_enable and config3 is neither 4 (NOFLIP) nor 5 (FLIP)"},
      {kBlock, motion_error::kFormatForPtp, "DataFormat invalid for PTP command", kRange,
       "PTP with a data_format other than JPP (0) or CPP (1), known or unknown"},
      {kBlock, motion_error::kFormatForLine, "DataFormat invalid for Line command", kRange,
       "Line with a data_format other than CPP (1), CPR (2), CAP (3) or CAR (4), known or unknown"},
      {kBlock, motion_error::kChecksumLength, "Checksum length not valid", kAgain,
       "cannot occur any more: the encoder cannot fail"},
      {kBlock, motion_error::kFrameBuilding, "Final frame building is error end", kAgain,
       "cannot occur any more: the encoder cannot fail"},
      {kBlock, motion_error::kSend, "TCP send error", kWiring,
       "cannot occur any more: a failed send closes the connection, see 16#99"},
      {kBlock, motion_error::kReceiveReply, "TCP receive error", kWiring,
       "the controller did not answer the script in time; the robot is told to stop"},
      {kBlock, motion_error::kRejected, "Command rejected", kAgain,
       "the controller answered ERROR with the numbers of the faulty lines"},
      {kBlock, motion_error::kClearBufferAgain, "Clear buffer error", kWiring, kNoStep},
      {kBlock, motion_error::kLinkDropped, "Robot not connected", kConnect,
       "the link dropped, or an emergency stop came, while the command was Busy"},
      {kBlock, motion_error::kReceiveTag, "TCP receive error", kWiring,
       "the motion is overdue, and the question for its tag got no answer; the robot is told to stop"},
      {kBlock, motion_error::kMotionFailed, "Motion failed", kAgain,
       "the controller reported the tag as not completed, and the robot stands; the robot is told to stop"},
  };
}

std::vector<ErrorEntry> ownErrors() {
  return {
      {kBlock, own_error::kNotFinite, "Target not finite", "Give finite numbers for all six coordinates",
       "a coordinate of the target is NaN or infinite"},
      {kBlock, own_error::kUnreachable, "Target unreachable",
       "Choose a target within the reach of the arm, or check base and TCP",
       "planning: a point of the path is out of reach"},
      {kBlock, own_error::kPoseBits, "Robot pose not achievable",
       "Choose another robot pose, or let the arm keep the present one",
       "planning: the target can be reached, but not with the wanted configuration"},
      {kBlock, own_error::kJointLimit, "Joint limit exceeded", "Choose another target, robot pose or path",
       "planning: a joint would leave its range"},
      {kBlock, own_error::kJointSpeed, "Joint speed exceeded", "Lower the speed, or use PTP",
       "planning: a joint would have to be faster than rated"},
      {kBlock, own_error::kSingular, "Path is singular", "Use PTP, or a path away from the singularity",
       "planning: the path runs into or too close to a singularity"},
      {kBlock, own_error::kNotPlannable, "Motion cannot be planned", kRange,
       "planning: refused for another reason, which the description tells"},
      {kBlock, own_error::kBlendingRange, "Blending range: 0~100 % or 0~2000 mm", kRange,
       "blending_enable and blending_value is outside 0..100 (formats ..P) or 0..2000 (formats ..R), or not "
       "a "
       "number"},
      {kBlock, own_error::kMovementUnknown, "MovementCommand unknown", "Use 0 (Line) or 1 (PTP)",
       "movement_command is neither 0 nor 1"},
      {kBlock, own_error::kPoseWithJoints, "Robot Pose must be disabled for a target in joints",
       "Disable robot_pose_enable, or use CPP",
       "robot_pose_enable with PTP JPP: the joints say the configuration"},
      {kBlock, own_error::kCoordinateRange, "Coordinate range: -100000~100000", kRange,
       "a coordinate of the target is beyond what any arm of the family could mean"},
      {kBlock, own_error::kNoFreeTag, "No free queue tag", "Wait until a command is done",
       "all 15 tags are open; cannot occur as long as one command at a time is accepted"},
      {kBlock, own_error::kNotListening, "Cobot is not in Listen Node",
       "Let the flow of the TMflow project enter its Listen node",
       "connected, but the flow is in another node; or the controller answered CPERR F1"},
      {kBlock, own_error::kEmergencyStop, "Emergency stop is pressed",
       "Release the emergency stop and start the project again",
       "the status stream shows an emergency stop when the command comes (during execution: 16#99)"},
      {kBlock, own_error::kRobotError, "Controller is in error",
       "Clear the error on the controller and start the project again",
       "the status stream shows an error, when the command comes or while it is Busy; code and text are "
       "given"},
      {kBlock, own_error::kTagLost, "Motion not confirmed", kAgain,
       "the motion is overdue and the controller does not know its tag, or cannot tell for too long; the "
       "robot "
       "is told to stop"},
      {kBlock, own_error::kCommunication, "Communication error reported by the controller", kAgain,
       "the controller answered the script with CPERR 01..04"},
      {kBlock, own_error::kStopNotConfirmed, "Stop not confirmed",
       "Make sure that the robot stands before you go on",
       "after a cancel the controller did not accept the stop, or the robot did not come to rest in time"},
      {kBlock, own_error::kShutDown, "Command layer is shutting down", "Start the command layer again",
       "the goal came after the command layer was told to shut down"},
  };
}

}  // namespace

std::vector<ErrorEntry> moveAbsoluteErrors() {
  std::vector<ErrorEntry> errors = thesisErrors();
  for (const ErrorEntry& entry : ownErrors()) errors.push_back(entry);
  return errors;
}

}  // namespace cobot_command::blocks
