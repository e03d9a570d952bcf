// How a goal ends, and how it is going on: the PLCopen outputs of a block.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/blocks/shared/detail.h"
#include "cobot_command/common/time.h"

namespace cobot_command::blocks {

/// The end of a goal; exactly one of these for every goal.
enum class Ending {
  Done,           ///< normal end
  Rejected,       ///< Error, before a byte was sent
  Aborted,        ///< Error, in execution
  CommandAborted  ///< a cancel or another command took it away
};

/// What people have to know of a goal that was carried out all the same. Each is a part of a sentence; empty:
/// there is nothing to say.
struct Remarks {
  std::vector<std::string> warned_lines;  ///< of each script those that the controller has named
  std::string unplanned;                  ///< why a motion was sent without a plan, and so unchecked
  std::string unseen;                     ///< why nobody has seen a motion at its end
  std::string pace;                       ///< by which project speed a motion was planned anew

  /// Of another command of the same goal: what is known stays.
  void add(const Remarks& other);
  /// For the result of a goal that is Done.
  [[nodiscard]] std::string text() const;
  /// For one that is not: its end says what became of its motions.
  [[nodiscard]] std::string textOfWarnings() const;
};

/// What every block has; what only one has, or a few, is a detail.
struct Outcome {
  Ending ending = Ending::Done;
  int error_id = 0;               ///< of the catalogue; 0 unless Rejected or Aborted
  std::string error_description;  ///< the catalogue's text, then what was found
  std::string remedy;             ///< what to do
  /// CmdID_Ack: the caller's command_id, or the tag that the layer chose; 0 for neither.
  int command_id_ack = 0;
  std::optional<Duration> planned;  ///< planned duration of the motion, when it could be planned
  std::optional<Duration> actual;   ///< from the acceptance by the controller to the end
  /// Of the status frame after the queue tag that made it Done, also where the robot has moved on since; else
  /// of the last one before the end.
  std::optional<std::array<double, 6>> final_joints_deg;
  std::optional<std::array<double, 6>> final_pose_mm_deg;  ///< active TCP in the active base
  /// Of its script, as the controller has named them; none unless it refused the script.
  std::vector<std::string> refused_lines;
  Remarks remarks;  ///< told in its description
  Detail detail;    ///< of the block; none where it has none to tell
};

/// Where a goal stands, while it is Busy.
enum class Phase {
  Connecting,          ///< Connect: no connection yet
  Probing,             ///< Connect: connected, not known to be in the Listen node
  Connected,           ///< Connect: ready for commands
  Sent,                ///< a command was sent and not yet acknowledged
  Queued,              ///< waits behind others, in this layer or in the controller
  WaitingForTracking,  ///< LoadPath: tracking objects are not as the goal wants them
  Active,              ///< the robot executes it (PLCopen Active)
  Held,                ///< Active, but the project is paused or a safeguard holds the robot
  Dwelling,            ///< PickAndPlace: waits between two moves
  Stopping             ///< a cancel is being carried out
};
[[nodiscard]] const char* toString(Phase phase);

struct Progress {
  Phase phase = Phase::Sent;
  int command_id_ack = 0;
  int place_in_queue = 0;             ///< 0: it is its turn; 1: one command in front of it ...
  double fraction = 0;                ///< of the motion, 0..1; estimated by time, 1 only at the end
  std::optional<Duration> planned;    ///< of the whole motion
  std::optional<Duration> remaining;  ///< of the motion, as far as it could be planned
  std::optional<double>
      distance_mm;   ///< of the TCP to where the motion ends, straight, as the arm stands now
  std::string text;  ///< for people: "connection refused: no project running, trying again"
  Detail detail;     ///< as in Outcome, but mostly of another kind
};

}  // namespace cobot_command::blocks
