// The end of a goal and its progress: the PLCopen outputs of a block.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/blocks/shared/detail.h"
#include "cobot_command/common/time.h"

namespace cobot_command::blocks {

/// The end of a goal; every goal has exactly one.
enum class Ending {
  Done,           ///< normal end
  Rejected,       ///< Error, before anything was sent
  Aborted,        ///< Error, during execution
  CommandAborted  ///< ended by a cancel or by another command
};

/// Remarks about a goal that was carried out nevertheless. Each is a part of a sentence; empty: no remark.
struct Remarks {
  std::vector<std::string> warned_lines;  ///< for each script, the lines with a warning of the controller
  std::string unplanned;                  ///< why a motion was sent without a plan, and therefore unchecked
  std::string unseen;                     ///< why a motion was not seen at its end
  std::string pace;                       ///< project speed with which a motion was planned again

  /// Adds the remarks of another command of the same goal; existing remarks stay.
  void add(const Remarks& other);
  /// For the result of a goal that is Done.
  [[nodiscard]] std::string text() const;
  /// For the result of any other goal: its outcome describes its motions.
  [[nodiscard]] std::string textOfWarnings() const;
};

/// The data that every block has. Data of one or a few blocks is in the detail.
struct Outcome {
  Ending ending = Ending::Done;
  int error_id = 0;               ///< of the catalogue; 0 unless Rejected or Aborted
  std::string error_description;  ///< the catalogue's text, then what was found
  std::string remedy;             ///< what to do
  /// CmdID_Ack: the caller's command_id, or the tag that the layer has selected; 0: neither.
  int command_id_ack = 0;
  std::optional<Duration> planned;  ///< planned duration of the motion, if it could be planned
  std::optional<Duration> actual;   ///< from the acceptance by the controller to the end
  /// From the status frame after the queue tag that made the goal Done, even if the robot has moved since;
  /// otherwise from the last frame before the end.
  std::optional<std::array<double, 6>> final_joints_deg;
  std::optional<std::array<double, 6>> final_pose_mm_deg;  ///< active TCP in the active base
  /// Lines of its script that the controller has listed; empty unless it refused the script.
  std::vector<std::string> refused_lines;
  Remarks remarks;  ///< part of its description
  Detail detail;    ///< of the block; none: the block has no detail to report
};

/// State of a goal while it is Busy.
enum class Phase {
  Connecting,          ///< Connect: no connection yet
  Probing,             ///< Connect: connected; not known whether the flow is in the Listen node
  Connected,           ///< Connect: ready for commands
  Sent,                ///< a command was sent and not yet acknowledged
  Queued,              ///< queued after other commands, in this layer or in the controller
  WaitingForTracking,  ///< LoadPath: the tracking objects are not as the goal requires
  Active,              ///< the robot executes it (PLCopen Active)
  Held,                ///< Active, but the project is paused or a safeguard pauses the robot
  Dwelling,            ///< PickAndPlace: waits between two moves
  Stopping             ///< a cancel is in progress
};
[[nodiscard]] const char* toString(Phase phase);

struct Progress {
  Phase phase = Phase::Sent;
  int command_id_ack = 0;
  int place_in_queue = 0;             ///< number of commands before it; 0: it is its turn
  double fraction = 0;                ///< of the motion, 0..1; estimated from the time, 1 only at the end
  std::optional<Duration> planned;    ///< of the whole motion
  std::optional<Duration> remaining;  ///< of the motion, if it could be planned
  /// Straight distance of the TCP from its present place to the end of the motion.
  std::optional<double> distance_mm;
  std::string text;  ///< for people: "connection refused: no project running, trying again"
  Detail detail;     ///< as in Outcome, but usually of another type
};

}  // namespace cobot_command::blocks
