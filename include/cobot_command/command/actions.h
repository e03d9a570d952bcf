// What the core wants done and told, in this order.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/types.h"
#include "cobot_command/blocks/shared/block.h"
#include "cobot_command/blocks/shared/goal_values.h"
#include "cobot_command/blocks/shared/outcome.h"
#include "cobot_command/command/command_status.h"
#include "cobot_command/command/group_state.h"
#include "cobot_command/command/message.h"
#include "cobot_command/command/planning_job.h"
#include "cobot_command/common/time.h"
#include "cobot_command/link/connection.h"
#include "cobot_command/link/robot_status.h"
#include "cobot_command/path/path_controls.h"
#include "cobot_command/robot/active_frames.h"
#include "cobot_command/tables/data_tables.h"

namespace cobot_command::command {

/// Open a TCP connection; answer with opened() or openFailed(), carrying the same connection id.
struct OpenConnection {
  link::ConnectionId id;
  link::Channel channel;
  std::string host;
  int port = 0;
  Duration timeout{};
};
/// Close a connection, or give up opening it. No event with its id is expected any more; late ones are
/// ignored.
struct CloseConnection {
  link::ConnectionId id;
};
struct SendBytes {
  link::ConnectionId id;
  std::string bytes;
};
/// It is its turn. A goal that waits (BufferMode::Buffered) is not accepted yet: only its progress is told.
struct GoalAccepted {
  blocks::Block block;
  blocks::GoalId goal;
};
struct GoalProgressed {
  blocks::Block block;
  blocks::GoalId goal;
  blocks::Progress progress;
};
/// The one and only end of a goal. Rejected comes without a GoalAccepted before it, CommandAborted also
/// without one when the goal still waited, the others with one.
struct GoalEnded {
  blocks::Block block;
  blocks::GoalId goal;
  blocks::Outcome outcome;
};
/// The commands that wait have fallen with the one in front of them. So no command of a goal up to and with
/// `newest` begins any more, wherever it waits: those in the core are ended, and one that is submitted later
/// ends at once as CommandAborted (fallsWithOthers()).
struct CommandsFell {
  blocks::GoalId newest;
  std::string why;
};
/// A plan is to be made, beside the core; answer with planned(). Only with Planning::Beside.
struct PlanAsked {
  PlanJobId id;
  PlanLane lane;
  PlanWork work;
};
struct StatusChanged {
  CommandStatus status;
};
struct GroupStateChanged {
  GroupState state;
};
struct RobotStatusReceived {
  link::RobotStatus status;
  std::optional<bool> moving = {};  ///< by this frame and those before; nothing: not known, or not yet
};
/// Base and TCP that the next command will be taken in are others than before.
struct ActiveFramesChanged {
  robot::ActiveFrames frames;
};
/// Tools, frames or loads are others than before.
struct TablesChanged {
  tables::DataTables tables;
};
/// Every plan is made with other limits of the joints than before.
struct SoftwareLimitsChanged {
  std::shared_ptr<const arm::ArmModel> arm;  ///< with these; never nullptr
};
/// Tracking objects, or the feedrate, are otherwise than before.
struct PathControlsChanged {
  path::PathControls controls;
};
/// The path of a motion that was checked or is about to start: the TCP in the robot base.
struct PathPlanned {
  blocks::GoalId goal;
  std::vector<arm::Pose> tool_path;
};
/// A goal was planned as a whole, or refused by its plan; it may be planned anew, and then is told again.
struct GoalPreviewed {
  blocks::Block block;
  blocks::GoalId goal;
  blocks::Detail preview;  ///< what people are to see, of a kind of the block's own
};
/// For everyone, and not of one goal.
struct RunTold {
  blocks::Block block;
  blocks::Detail news;  ///< of a kind of the block's own
};
/// The flight recorder: every frame and every fault, sent and received.
/// A fault holds the bytes that were dropped.
struct FrameTraced {
  Instant time;
  link::Channel channel;
  bool sent = false;
  std::string bytes;
  std::string meaning;
};
/// For the log; it is a message, too.
struct LogMessage {
  Severity severity;  ///< Off: not wanted in the log
  std::string text;
  int code = 0;  ///< see Message
  std::string remedy = {};
};
struct MessageRaised {
  Message message;
};
/// Other messages are pending than before.
struct PendingChanged {
  std::vector<Message> pending;
};

using Action =
    std::variant<OpenConnection, CloseConnection, SendBytes, GoalAccepted, GoalProgressed, GoalEnded,
                 CommandsFell, PlanAsked, StatusChanged, RobotStatusReceived, ActiveFramesChanged,
                 TablesChanged, PathControlsChanged, PathPlanned, GoalPreviewed, RunTold, FrameTraced,
                 LogMessage, MessageRaised, PendingChanged, GroupStateChanged, SoftwareLimitsChanged>;

}  // namespace cobot_command::command
