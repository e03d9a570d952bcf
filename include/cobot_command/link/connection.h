// The connections of one robot, as the core identifies them, and their timing.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "cobot_command/common/path_settings.h"
#include "cobot_command/common/time.h"
#include "cobot_command/common/units.h"
#include "cobot_command/common/velocity_modes.h"

namespace cobot_command::link {

enum class Channel { Script, Status };  ///< ports 5890 and 5891

/// Assigned by the core, never twice: late events have an old id and are ignored.
using ConnectionId = std::uint64_t;

/// Why a connection could not be opened.
struct OpenFailure {
  enum class Kind {
    Refused,      ///< no server on the port: no project is running, or the port is wrong
    Unreachable,  ///< no route, host down
    UnknownHost,  ///< the name cannot be resolved
    TimedOut,     ///< no answer in time
    Other
  };
  Kind kind = Kind::Other;
  std::string message;  ///< text of the operating system
};

/// Deadlines and periods. Each can be changed, and has a range that is checked when the parameters are set.
struct LinkSettings {
  int status_port = 5891;                                 ///< 0: no status link
  Duration open_timeout = std::chrono::seconds(2);        ///< for one attempt
  Duration retry_min = std::chrono::milliseconds(100);    ///< back-off between attempts, doubling ...
  Duration retry_max = std::chrono::seconds(1);           ///< ... up to this
  Duration reply_timeout = std::chrono::seconds(1);       ///< for OK / ERROR and for TMSTA answers
  Duration supervision_period = std::chrono::seconds(1);  ///< heartbeat: TMSTA 00 (thesis 5.3.1)
  /// Number of unanswered heartbeats after which the link counts as lost: with a period of 1 s a dead peer is
  /// detected within 3 s.
  int supervision_misses = 2;
  /// Time without a status frame after which the status link is opened again.
  Duration status_timeout = std::chrono::seconds(1);
  double tag_deadline_factor = 1.5;                               ///< times the planned duration ...
  Duration tag_deadline_margin = std::chrono::seconds(2);         ///< ... plus this
  Duration unplanned_motion_timeout = std::chrono::seconds(300);  ///< when the motion could not be planned
  /// For one plan that is made in parallel with the core.
  Duration planning_budget = std::chrono::seconds(10);
  /// From an accepted stop until the robot is at standstill.
  Duration stop_timeout = std::chrono::seconds(2);
  /// Time for the status stream to show the robot at standstill at the target, from its first frame after a
  /// queue tag. Also the time for it to show the reason for an event that the script port reported first.
  Duration evidence_timeout = std::chrono::milliseconds(500);
  double position_tolerance = 0.001;       ///< of the TCP at the end of a motion [m]
  double angle_tolerance = degToRad(0.1);  ///< of each joint, or of the TCP, there [rad]
  /// The queue tag of the first motion, 1..15. Two command layers that start with the same tag take each
  /// other's tags for their own more often, so a program chooses it at random.
  int first_tag = 1;
  /// Behaviour of a connect goal whose link is lost. False: it ends (16#90), as in the thesis. True: it stays
  /// Busy, and tries again for its timeout before it ends. Open motions end at the loss in both cases;
  /// nothing resumes automatically.
  bool auto_reconnect = false;
  /// When a link is made, a robot that still executes an earlier motion is stopped, also one that a pause or
  /// a safeguard pauses.
  bool stop_orphaned_motion = true;
  VelocityModes velocities = {};  ///< that `jog` may use, if the controller accepts them
  /// Time that the controller needs to bring the arm to rest from a velocity (ContinueVJog, ContinueVLine).
  Duration jog_stop_time = std::chrono::milliseconds(200);
  PathSettings path = {};  ///< of load_path
};

}  // namespace cobot_command::link
