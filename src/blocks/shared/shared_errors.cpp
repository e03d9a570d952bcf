// The rows that mean the same in several blocks, and which blocks' needs they meet together.
#include <algorithm>
#include <cassert>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/error_table.h"

namespace cobot_command::blocks {
namespace {

struct SharedError {
  int id;
  const char* description;
  const char* remedy;
  const char* raised_when;
};

/// Numbers and texts of the thesis; the conditions are this layer's.
constexpr SharedError kThesisErrors[] = {
    {motion_error::kNotConnected, "Robot not connected",
     "Send a goal to connect, and wait until it is connected",
     "no connect goal is Busy, or its link is not established (yet)"},
    {motion_error::kOtherBlockBusy, "Other function block is under execution",
     "Wait until it is done, or use buffer_mode BUFFERED or ABORTING",
     "buffer_mode REFUSE and another command is Busy; a blended motion is no longer Busy once the controller "
     "has accepted it"},
    {motion_error::kClearBuffer, "Clear buffer error", kCheckWiring, kNoSuchStep},
    {motion_error::kSpeedRangeAbsolute, "Speed range: above 0, at most 4500 mm/s", kSetInRange,
     "a format with speed in mm/s (second letter A): speed is not above 0, above 4500, or not a number"},
    {motion_error::kSpeedRangePercent, "Speed range: above 0, at most 100 %", kSetInRange,
     "a format with speed in % (second letter P), whatever the movement: speed is not above 0, above 100, or "
     "not a number"},
    {motion_error::kAccelTimeRange, "Acceleration Time range is: 150~9999 ms", kSetInRange,
     "accel_time is below 150, above 9999, or not a number"},
    {motion_error::kCommandIdRange, "Command ID range: 0, or 2~9", kSetInRange,
     "command_id is neither 0 (the layer chooses) nor 2..9"},
    {motion_error::kChecksumLength, "Checksum length not valid", kExecuteAgain,
     "cannot occur any more: the encoder cannot fail"},
    {motion_error::kFrameBuilding, "Final frame building is error end", kExecuteAgain,
     "cannot occur any more: the encoder cannot fail"},
    {motion_error::kSend, "TCP send error", kCheckWiring,
     "cannot occur any more: a failed send closes the connection, see 16#99"},
    {motion_error::kReceiveReply, "TCP receive error", kCheckWiring,
     "the controller did not answer the script in time; the robot is sent a stop command"},
    {motion_error::kRejected, "Command rejected", kExecuteAgain,
     "the controller answered ERROR with the numbers of the faulty lines"},
    {motion_error::kClearBufferAgain, "Clear buffer error", kCheckWiring, kNoSuchStep},
    {motion_error::kLinkDropped, "Robot not connected",
     "Send a goal to connect again; nothing resumes automatically",
     "the link dropped, or an emergency stop occurred, while the command was Busy"},
    {motion_error::kReceiveTag, "TCP receive error", kCheckWiring,
     "the motion is overdue, and the query for its tag got no answer; the robot is sent a stop command"},
    {motion_error::kMotionFailed, "Motion failed", kExecuteAgain,
     "the controller reported the tag as not completed, and the robot is at standstill; the robot is sent a "
     "stop command"},
};

constexpr SharedError kTargetErrors[] = {
    {own_error::kNotFinite, "Target not finite", "Give finite numbers",
     "a coordinate, or a number of a pose, is NaN or infinite"},
    {own_error::kUnreachable, "Target unreachable",
     "Choose a target within the reach of the arm, or check base and TCP",
     "planning: a point of the path is out of reach"},
    {own_error::kPoseBits, "Robot pose not achievable",
     "Choose another robot pose, or let the arm keep the present one",
     "planning: a point can be reached, but not with the requested configuration, or not with the "
     "configuration of the start"},
    {own_error::kJointLimit, "Joint limit exceeded", "Choose another target, robot pose or path",
     "planning: a joint would leave its range"},
    {own_error::kJointSpeed, "Joint speed exceeded", "Lower the speed, or use PTP",
     "planning: a joint would exceed its rated speed"},
    {own_error::kSingular, "Path is singular", "Use PTP, or a path away from the singularity",
     "planning: the path runs into a singularity, or too close to one"},
    {own_error::kNotPlannable, "Motion cannot be planned", kSetInRange,
     "planning: refused for another reason; see the description"},
    {own_error::kBlendingTooLarge, "Blending does not fit",
     "Lower blending_value, or choose targets that are further apart",
     "in a checked sequence: the blending radius is larger than half of the path to its corner, or of the "
     "path after it"},
    {own_error::kStartUnknown, "Start unknown",
     "Wait until the status stream shows the robot at standstill; stop a paused robot first",
     "check_only, and the start of the motion is unknown: no status stream, or the robot is in a motion, or "
     "paused in a motion, whose end is unknown"},
    {own_error::kNoModel, "No arm model", "Start the command layer with the model of the robot",
     "check_only, and the command layer has no model of the arm"},
    {own_error::kAmbiguousTurn, "Turn ambiguous",
     "Add an intermediate point at which the tool has made part of the turn, or use PTP to joints",
     "planning: the tool, or a joint of a PTP to a pose, would make half a turn (to 1 deg), and it is "
     "unknown in which direction the controller turns"},
    {own_error::kFrameMoved, "Frame moved",
     "Send the goal again; or set the stamp of its header, to use the frame at that time",
     "a target in a tf frame at its latest position (stamp zero) is more than 1 mm or 0.1 degrees from where "
     "it was when the goal arrived; checked when a queued goal gets its turn, and before each move of a "
     "pick_and_place"},
    {own_error::kPlanningBudget, "Planning took too long",
     "Divide the sequence or the script, choose higher speeds (a path is planned point by point), or raise "
     "~planning_budget",
     "a plan was not completed within ~planning_budget: of a check, of a cycle before its first move, or of "
     "a move or a script before it is sent"},
    {own_error::kCoordinateRange, "Coordinate range: -100000~100000", kSetInRange,
     "a coordinate [mm, deg] is beyond the reach of any arm of the family"},
    {own_error::kFrameUnknown, "Frame unknown", "Give a frame that tf connects with the robot base",
     "a pose is in a tf frame that cannot be transformed to the robot base"},
    {own_error::kQuaternion, "Quaternion not of unit length",
     "Normalise the quaternion; 0, 0, 0, 1 means no rotation",
     "the length of a pose's quaternion differs from 1 by more than 0.001, for example 0 if all numbers are "
     "zero"},
    {own_error::kBaseUnknown, "Active base or TCP unknown",
     "Give them by value, or tick Base_Value and TCP_Value in the Ethernet Slave's data table; after a "
     "change by name, wait for the next status frame",
     "a target in a tf frame, and the active base is unknown; or a motion in a checked sequence, and its "
     "base or TCP is identified only by its name in the project"},
};

constexpr SharedError kParameterErrors[] = {
    {own_error::kBlendingRange, "Blending range: 0~100 % or 0~2000 mm", kSetInRange,
     "blending_enable and blending_value is outside 0..100 (formats ..P) or 0..2000 (formats ..R), or not a "
     "number"},
    {own_error::kMovementUnknown, "MovementCommand unknown", "Use 0 (Line) or 1 (PTP)",
     "movement_command is neither 0 nor 1"},
    {own_error::kNoFreeTag, "No free queue tag", "Wait until a command is done",
     "cannot occur: the commands at the controller use at most 15 tags at a time"},
    {own_error::kBufferModeUnknown, "BufferMode unknown", "Use 0 (REFUSE), 1 (BUFFERED) or 2 (ABORTING)",
     "buffer_mode is none of these"},
    {own_error::kQueueFull, "Too many commands wait", "Wait until one is done, or cancel one",
     "buffer_mode BUFFERED, and the queue of this layer is full; or too many goals wait for a frame or a "
     "file, or checks for planning"},
    {own_error::kOutputInvalid, "Output invalid",
     "Use 0 to 3 of EndModule, or 0 to 15 of ControlBox; the analog one is 0 of ControlBox",
     "the output is of another module, or the module has no such number"},
    {own_error::kOutputValue, "Output value or kind out of range",
     "Use kind 0 (digital) with value 0 or 1, or kind 1 (analog) with -10 to 10 V",
     "kind is neither 0 nor 1; or value is neither 0 nor 1 for a digital output; or outside -10..10, or not "
     "a "
     "number, for an analog one"},
    {own_error::kInputInvalid, "Input invalid", "Use 0 to 3 of EndModule, or 0 to 15 of ControlBox",
     "the input is of another module, or the module has no such number"},
    {own_error::kWaitRange, "Timeout range: 0~86400 s", kSetInRange,
     "the timeout is negative, above 86400, or not a number; 0 means no timeout"},
    {own_error::kInputTimedOut, "Input not seen in time", "Find out why the input does not change",
     "the input had the other value until the timeout; the timeout does not run while the robot is paused"},
    {own_error::kInputUnknown, "Input not in the status stream",
     "Tick the input in the Ethernet Slave's data table, and set a status_port other than 0",
     "there is no status stream, or its data table does not contain the input, when the goal gets its turn "
     "or while it waits"},
    {own_error::kNameInvalid, "Name invalid", "Give the name as it is in the TMflow project",
     "a name has more than 255 bytes or control characters, or is not UTF-8"},
    {own_error::kStepCount, "Number of steps out of range", kSetInRange, "there are no steps, or too many"},
    {own_error::kStepRefused, "Step refused", "Correct the step",
     "the check of a step found an error; the description gives the error and the index of the step"},
};

constexpr SharedError kRobotErrors[] = {
    {own_error::kNotListening, "Cobot is not in Listen Node",
     "Let the flow of the TMflow project enter its Listen node",
     "connected, but the flow is in another node; or the controller answered CPERR F1"},
    {own_error::kEmergencyStop, "Emergency stop is pressed",
     "Release the emergency stop and start the project again",
     "the status stream shows an emergency stop when the command arrives (during execution: 16#99)"},
    {own_error::kRobotError, "Controller is in error",
     "Execute stop, which acknowledges the error: the next motion then clears it. If it does not, clear it "
     "on the "
     "controller",
     "the status stream shows an error that no stop has acknowledged, when the command arrives, or while it "
     "is Busy; code and text are given. If change_tcp and change_load gave the arm more than its payload, "
     "the masses are given, too, and the remedy is to reduce them"},
    {own_error::kNotAtTarget, "Target not reached",
     "Make sure that no other client commands this controller, then execute again",
     "the tag was reported as complete, but until ~evidence_timeout later the status stream showed the robot "
     "away from the target, or still in motion; the robot is sent a stop command"},
    {own_error::kOrphanMoves, "Robot may move without a goal of this layer",
     "Wait until it is at standstill, execute stop, or use buffer_mode ABORTING",
     "buffer_mode REFUSE, and the robot may still move: a motion from before the link was not stopped "
     "(~stop_orphaned_motion false), or a stop was not confirmed (16#225). This ends when a status frame "
     "shows standstill or a stop is confirmed"},
    {own_error::kStoppedElsewhere, "Motion stopped from outside",
     "Find out what stops the robot: another client of this controller (a second command node stops any "
     "motion that it finds, unless its ~stop_orphaned_motion is false), the project or the pendant; then "
     "execute again",
     "the robot has been at standstill away from the target for ~evidence_timeout, no pause and no safeguard "
     "stops it, and the controller, when queried, no longer knows the tag; the robot is sent a stop command"},
    {own_error::kTagLost, "Motion not confirmed", kExecuteAgain,
     "the motion is overdue, and the controller does not know its tag, or reports it as incomplete for too "
     "long; the robot is sent a stop command"},
    {own_error::kCommunication, "Communication error reported by the controller", kExecuteAgain,
     "the controller answered the script with CPERR 01..04; if the script was to move the robot, a stop "
     "command is sent"},
    {own_error::kStopNotConfirmed, "Stop not confirmed",
     "Make sure that the robot is at standstill before you continue",
     "after a cancel, or for a goal with buffer_mode ABORTING, the controller did not accept the stop, or "
     "the status stream did not show the robot at standstill in time"},
    {own_error::kOnlyPrograms, "In a cell only programs move the robot",
     "Use run_program; or take the robot out of the cell, and start its node without ~cell",
     "the node has a ~cell: any other command that moves the robot, or leaves the Listen node, is refused "
     "before a byte of it is sent"},
    {own_error::kShutDown, "Command layer is shutting down", "Start the command layer again",
     "cannot occur through ROS, because the node accepts no goals by then: the goal arrived after the "
     "command layer began to shut down"},
};

constexpr SharedError kInterfaceErrors[] = {
    {interface_error::kNotEnabled, "Interface is not enabled",
     "Send a goal to exchange_configuration, and wait until it is enabled",
     "~require_exchange_configuration is true, and no exchange_configuration goal is enabled"},
    {interface_error::kNotSynchronized, "Interface is not synchronized",
     "Synchronize the data: write the intended entry, or change it back on the pendant",
     "enabled data are out of sync with a sync_reaction set, and were so when the robot or the interface was "
     "enabled"},
    {interface_error::kInterrupted, "Interrupted: cannot continue before the data are in sync",
     "Synchronize the data, then RESUME with program_control; or stop; a goal with BUFFERED waits",
     "a sync_reaction has interrupted the robot because enabled data are out of sync, and the goal cannot "
     "wait: its buffer_mode is not BUFFERED; or the data are in sync again, and the robot was not resumed"},
};

template <std::size_t N>
const SharedError* find(const SharedError (&table)[N], int id) {
  const auto* found = std::find_if(std::begin(table), std::end(table),
                                   [id](const SharedError& error) { return error.id == id; });
  return found == std::end(table) ? nullptr : found;
}

const SharedError& sharedError(int id) {
  for (const SharedError* found :
       {find(kThesisErrors, id), find(kTargetErrors, id), find(kParameterErrors, id), find(kRobotErrors, id),
        find(kInterfaceErrors, id)}) {
    if (found != nullptr) return *found;
  }
  assert(false && "no shared error has this id");
  return kRobotErrors[0];
}

}  // namespace

ErrorTable& ErrorTable::row(int id, const char* description, const char* remedy, const char* raised_when) {
  rows_.push_back({id, description, remedy, raised_when});
  return *this;
}

ErrorTable& ErrorTable::shared(std::initializer_list<int> ids) {
  for (const int id : ids) shared(id, sharedError(id).raised_when);
  return *this;
}

ErrorTable& ErrorTable::shared(int id, const char* raised_when) {
  const SharedError& error = sharedError(id);
  return row(id, error.description, error.remedy, raised_when);
}

ErrorTable& ErrorTable::condition(int id, const char* raised_when) {
  for (ErrorRow& row : rows_) {
    if (row.id == id) row.raised_when = raised_when;
  }
  return *this;
}

ErrorTable& ErrorTable::remedy(int id, const char* remedy) {
  for (ErrorRow& row : rows_) {
    if (row.id == id) row.remedy = remedy;
  }
  return *this;
}

ErrorTable& ErrorTable::instead(std::initializer_list<OwnNumber> numbers) {
  own_numbers_.insert(own_numbers_.end(), numbers);
  return *this;
}

ErrorTable& ErrorTable::thesisCommand() {
  return shared({motion_error::kClearBuffer, motion_error::kChecksumLength, motion_error::kFrameBuilding,
                 motion_error::kSend});
}

ErrorTable& ErrorTable::echoedCommandId() {
  return shared(motion_error::kCommandIdRange,
                "command_id is neither 0 (none) nor 2..9; the thesis does not check it in this block");
}

ErrorTable& ErrorTable::anyCommand() {
  return shared({motion_error::kNotConnected, motion_error::kReceiveReply, motion_error::kRejected,
                 motion_error::kLinkDropped, own_error::kCommunication, own_error::kShutDown});
}

ErrorTable& ErrorTable::turn() {
  return shared({motion_error::kOtherBlockBusy, own_error::kBufferModeUnknown, own_error::kQueueFull,
                 own_error::kNotListening, own_error::kEmergencyStop, own_error::kRobotError,
                 own_error::kStopNotConfirmed, own_error::kOrphanMoves});
}

ErrorTable& ErrorTable::underInterface() {
  return shared(
      {interface_error::kNotEnabled, interface_error::kNotSynchronized, interface_error::kInterrupted});
}

ErrorTable& ErrorTable::inCell() {
  return shared({own_error::kOnlyPrograms});
}

ErrorTable& ErrorTable::motion() {
  return shared({motion_error::kReceiveTag, motion_error::kMotionFailed, own_error::kUnreachable,
                 own_error::kPoseBits, own_error::kJointLimit, own_error::kJointSpeed, own_error::kSingular,
                 own_error::kNotPlannable, own_error::kAmbiguousTurn, own_error::kNoFreeTag,
                 own_error::kTagLost, own_error::kNotAtTarget, own_error::kStoppedElsewhere,
                 own_error::kPlanningBudget});
}

ErrorTable& ErrorTable::move() {
  return motion().shared({motion_error::kSpeedRangeAbsolute, motion_error::kSpeedRangePercent,
                          motion_error::kAccelTimeRange, motion_error::kCommandIdRange,
                          motion_error::kClearBufferAgain, own_error::kNotFinite, own_error::kStartUnknown,
                          own_error::kNoModel, own_error::kBlendingRange, own_error::kCoordinateRange,
                          own_error::kBaseUnknown});
}

ErrorTable& ErrorTable::framedPose() {
  return shared({own_error::kFrameUnknown, own_error::kFrameMoved, own_error::kQuaternion});
}

std::vector<ErrorRow> ErrorTable::rows() const {
  std::vector<ErrorRow> sorted = rows_;
  std::sort(sorted.begin(), sorted.end(), [](const ErrorRow& a, const ErrorRow& b) { return a.id < b.id; });
  return sorted;
}

}  // namespace cobot_command::blocks
