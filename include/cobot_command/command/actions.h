// The actions that the core requests from its driver, to be carried out in this order.
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

/// Opens a TCP connection. The answer is opened() or openFailed() with the same connection id.
struct OpenConnection {
  link::ConnectionId id;
  link::Channel channel;
  std::string host;
  int port = 0;
  Duration timeout{};
};
/// Closes a connection, or gives up opening it. No event with its id is expected any more; late ones are
/// ignored.
struct CloseConnection {
  link::ConnectionId id;
};
struct SendBytes {
  link::ConnectionId id;
  std::string bytes;
};
/// The goal's turn has come. A queued goal (BufferMode::Buffered) is not accepted yet: only its progress is
/// published.
struct GoalAccepted {
  blocks::Block block;
  blocks::GoalId goal;
};
struct GoalProgressed {
  blocks::Block block;
  blocks::GoalId goal;
  blocks::Progress progress;
};
/// The one and only end of a goal. Rejected has no GoalAccepted before it. CommandAborted has none if the
/// goal was still queued. All others have one.
struct GoalEnded {
  blocks::Block block;
  blocks::GoalId goal;
  blocks::Outcome outcome;
};
/// The queued commands have ended together with a command before them. So no command of a goal up to and
/// including `newest` begins any more, wherever it waits. Those in the core have ended. One that is submitted
/// later ends at once as CommandAborted (fallsWithOthers()).
struct CommandsFell {
  blocks::GoalId newest;
  std::string why;
};
/// A plan must be made in parallel with the core; the answer is planned(). Only with Planning::Beside.
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
  /// According to this frame and those before; nullopt: not known, or not known yet.
  std::optional<bool> moving = {};
};
/// The base and the TCP that apply to the next command have changed.
struct ActiveFramesChanged {
  robot::ActiveFrames frames;
};
/// Tools, frames or loads have changed.
struct TablesChanged {
  tables::DataTables tables;
};
/// The joint limits that apply to every plan have changed.
struct SoftwareLimitsChanged {
  std::shared_ptr<const arm::ArmModel> arm;  ///< with the new limits; never nullptr
};
/// Tracking objects or the feedrate have changed.
struct PathControlsChanged {
  path::PathControls controls;
};
/// The path of a motion that was checked or is about to start: the TCP in the robot base.
struct PathPlanned {
  blocks::GoalId goal;
  std::vector<arm::Pose> tool_path;
};
/// A goal was planned as a whole, or refused by its plan. A goal that is planned again is reported again.
struct GoalPreviewed {
  blocks::Block block;
  blocks::GoalId goal;
  blocks::Detail preview;  ///< what is shown to people, of the block's own type
};
/// News for all clients, not for one goal.
struct RunTold {
  blocks::Block block;
  blocks::Detail news;  ///< of the block's own type
};
/// The flight recorder: every frame and every fault, sent and received. A fault contains the bytes that were
/// dropped.
struct FrameTraced {
  Instant time;
  link::Channel channel;
  bool sent = false;
  std::string bytes;
  std::string meaning;
};
/// For the log; it is also a message.
struct LogMessage {
  Severity severity;  ///< Off: not for the log
  std::string text;
  int code = 0;  ///< see Message
  std::string remedy = {};
};
struct MessageRaised {
  Message message;
};
/// The set of pending messages has changed.
struct PendingChanged {
  std::vector<Message> pending;
};

using Action =
    std::variant<OpenConnection, CloseConnection, SendBytes, GoalAccepted, GoalProgressed, GoalEnded,
                 CommandsFell, PlanAsked, StatusChanged, RobotStatusReceived, ActiveFramesChanged,
                 TablesChanged, PathControlsChanged, PathPlanned, GoalPreviewed, RunTold, FrameTraced,
                 LogMessage, MessageRaised, PendingChanged, GroupStateChanged, SoftwareLimitsChanged>;

}  // namespace cobot_command::command
