// Which velocity commands may be sent to a controller.
#pragma once

namespace cobot_command {

/// Velocity commands that are enabled; none by default. If this computer stops communicating, the controller
/// keeps the last velocity: a TCP velocity until the controller's own watchdog ends it, a joint velocity
/// indefinitely.
struct VelocityModes {
  /// Unit in which the controller expects a TCP velocity (SetContinueVLine). The sources disagree.
  enum class Line { Off, Millimetres, Metres };
  Line line = Line::Off;  ///< ContinueVLine: in mm/s and deg/s, or in m/s and rad/s
  bool joints = false;    ///< ContinueVJog
};

}  // namespace cobot_command
