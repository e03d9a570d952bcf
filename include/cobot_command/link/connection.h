// The connections of one robot, as the core names them, and the times that rule them.
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

/// Given by the core, never twice: what is late carries an old id and is ignored.
using ConnectionId = std::uint64_t;

/// Why a connection could not be opened.
struct OpenFailure {
  enum class Kind {
    Refused,      ///< nobody listens: no project running, or the wrong port
    Unreachable,  ///< no route, host down
    UnknownHost,  ///< the name cannot be resolved
    TimedOut,     ///< no answer in time
    Other
  };
  Kind kind = Kind::Other;
  std::string message;  ///< the system's own words
};

/// Deadlines and periods; each is injectable and has a range that the setter of parameters checks.
struct LinkSettings {
  int status_port = 5891;                                 ///< 0: no status link
  Duration open_timeout = std::chrono::seconds(2);        ///< for one try
  Duration retry_min = std::chrono::milliseconds(100);    ///< back-off between tries, doubling ...
  Duration retry_max = std::chrono::seconds(1);           ///< ... up to this
  Duration reply_timeout = std::chrono::seconds(1);       ///< for OK / ERROR and for TMSTA answers
  Duration supervision_period = std::chrono::seconds(1);  ///< lifesign: TMSTA 00 (thesis 5.3.1)
  /// Unanswered lifesigns until the link counts as lost: with a period of 1 s a dead peer is found within 3
  /// s.
  int supervision_misses = 2;
  Duration status_timeout = std::chrono::seconds(1);       ///< without a status frame: status link reopened
  double tag_deadline_factor = 1.5;                        ///< times the planned duration ...
  Duration tag_deadline_margin = std::chrono::seconds(2);  ///< ... plus this
  Duration unplanned_motion_timeout = std::chrono::seconds(300);  ///< when the motion could not be planned
  Duration planning_budget = std::chrono::seconds(10);  ///< for one plan that is made beside the core
  Duration stop_timeout = std::chrono::seconds(2);      ///< from an accepted stop until the robot stands
  /// How long the status stream may take, from its first frame behind a queue tag on, to show the robot
  /// standing at the target; and to tell the reason of what the script port told first.
  Duration evidence_timeout = std::chrono::milliseconds(500);
  double position_tolerance = 0.001;       ///< of the TCP at the end of a motion [m]
  double angle_tolerance = degToRad(0.1);  ///< of each joint, or of the TCP, there [rad]
  /// The queue tag of the first motion, 1..15. Two command layers that begin alike take each other's tags for
  /// their own more often, so a program draws it.
  int first_tag = 1;
  /// A connect goal whose link is lost: false: it ends (16#90), as in the thesis. True: it stays Busy and
  /// tries again for its timeout before it ends. Open motions end at the loss either way; nothing resumes by
  /// itself.
  bool auto_reconnect = false;
  /// A robot that still moves when a link is made, from before, is told to stop.
  bool stop_orphaned_motion = true;
  VelocityModes velocities = {};  ///< that `jog` may use, where the controller takes them
  /// That the controller needs to bring the arm to rest from a velocity (ContinueVJog, ContinueVLine).
  Duration jog_stop_time = std::chrono::milliseconds(200);
  PathSettings path = {};  ///< of load_path
};

}  // namespace cobot_command::link
