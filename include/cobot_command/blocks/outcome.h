// How a goal ends, and how it is going on: the PLCopen outputs of a block.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "cobot_command/blocks/error_catalogue.h"
#include "cobot_command/blocks/goal.h"
#include "cobot_command/common/time.h"

namespace cobot_command::blocks {

/// The end of a goal; exactly one of these for every goal.
enum class Ending {
  Done,           ///< normal end
  Rejected,       ///< Error, before a byte was sent
  Aborted,        ///< Error, in execution
  CommandAborted  ///< a cancel or another command took it away
};

struct Outcome {
  Ending ending = Ending::Done;
  int error_id = 0;               ///< of the catalogue; 0 unless Rejected or Aborted
  std::string error_description;  ///< the catalogue's text, then what was found
  std::string remedy;             ///< what to do
  /// CmdID_Ack: the caller's command_id, or the tag that the layer chose; 0 for neither.
  int command_id_ack = 0;
  std::optional<Duration> planned;  ///< planned duration of the motion, when it could be planned
  std::optional<Duration> actual;   ///< from the acceptance by the controller to the end
  /// Of the last status frame before the end: up to one period of the stream old, as an end waits for
  /// nothing.
  std::optional<std::array<double, 6>> final_joints_deg;
  std::optional<std::array<double, 6>> final_pose_mm_deg;  ///< active TCP in the active base
};

/// Where a goal stands, while it is Busy.
enum class Phase {
  Connecting,  ///< Connect: no connection yet
  Probing,     ///< Connect: connected, not known to be in the Listen node
  Connected,   ///< Connect: ready for commands
  Sent,        ///< a command was sent and not yet acknowledged
  Queued,      ///< acknowledged, waits behind others
  Active,      ///< the robot executes it (PLCopen Active)
  Stopping     ///< a cancel is being carried out
};
[[nodiscard]] const char* toString(Phase phase);

struct Progress {
  Phase phase = Phase::Sent;
  int command_id_ack = 0;
  std::optional<Duration> planned;
  std::string text;  ///< for people: "connection refused: no project running, trying again"
};

}  // namespace cobot_command::blocks
