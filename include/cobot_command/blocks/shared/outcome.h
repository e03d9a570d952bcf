// How a goal ends, and how it is going on: the PLCopen outputs of a block.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/common/time.h"

namespace cobot_command::blocks {

/// The end of a goal; exactly one of these for every goal.
enum class Ending {
  Done,           ///< normal end
  Rejected,       ///< Error, before a byte was sent
  Aborted,        ///< Error, in execution
  CommandAborted  ///< a cancel or another command took it away
};

struct JointPathPoint {
  Duration time{};                     ///< since the start of the motion
  std::array<double, 6> joints{};      ///< [rad]
  std::array<double, 6> velocities{};  ///< [rad/s]
};

/// What the check or the execution of one step of a sequence found.
struct StepReport {
  int error_id = 0;               ///< of the catalogue of the step's own block; 0: nothing wrong
  std::string error_description;  ///< and the remedy
  Duration
      start{};  ///< since the start of the sequence; earlier than the end of the step before when blended
  Duration duration{};  ///< of the step from rest to rest, zero for what is no motion
  /// The first offending point, TCP in the active base, mm and degrees; where one is to blame.
  std::optional<std::array<double, 6>> offending_point;
  std::vector<JointPathPoint> joint_path;  ///< with CheckSequence; time since the start of the step
};

/// LastConnTime and LastLostTime of the connect block, since it was executed (thesis 5.3.1.1); absent: not
/// yet.
struct LinkTimes {
  std::optional<Instant> last_connected;
  std::optional<Instant> last_lost;
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
  /// Of a status frame from behind the queue tag, when that made it Done; else of the last one before the
  /// end.
  std::optional<std::array<double, 6>> final_joints_deg;
  std::optional<std::array<double, 6>> final_pose_mm_deg;  ///< active TCP in the active base
  std::vector<JointPathPoint> joint_path;  ///< of a motion that was only checked; see check_only
  std::vector<StepReport> steps;           ///< CheckSequence, PickAndPlace: of every step that was looked at
  int failed_step = -1;                    ///< CheckSequence, PickAndPlace: from 0; -1: none
  int cycles_done = 0;                     ///< PickAndPlace
  LinkTimes link_times;                    ///< Connect
};

/// Where a goal stands, while it is Busy.
enum class Phase {
  Connecting,  ///< Connect: no connection yet
  Probing,     ///< Connect: connected, not known to be in the Listen node
  Connected,   ///< Connect: ready for commands
  Sent,        ///< a command was sent and not yet acknowledged
  Queued,      ///< waits behind others, in this layer or in the controller
  Active,      ///< the robot executes it (PLCopen Active)
  Held,        ///< Active, but the project is paused or a safeguard holds the robot
  Dwelling,    ///< PickAndPlace: waits between two moves
  Stopping     ///< a cancel is being carried out
};
[[nodiscard]] const char* toString(Phase phase);

struct Progress {
  Phase phase = Phase::Sent;
  int command_id_ack = 0;
  int place_in_queue = 0;             ///< 0: it is its turn; 1: one command in front of it ...
  double fraction = 0;                ///< of the motion, 0..1; estimated by time, 1 only at the end
  std::optional<Duration> planned;    ///< of the whole motion
  std::optional<Duration> remaining;  ///< of the motion, as far as it could be planned
  int step = -1;                      ///< PickAndPlace: the step under way, from 0
  int cycle = 0;                      ///< PickAndPlace: the cycle under way, from 1
  LinkTimes link_times;               ///< Connect
  std::string text;                   ///< for people: "connection refused: no project running, trying again"
};

}  // namespace cobot_command::blocks
