// The modes in which a controller may be given velocities.
#pragma once

namespace cobot_command {

/// In which modes the controller may be given velocities: in none, unless somebody asks for it by name. It
/// keeps a velocity when this computer falls silent: that of the TCP until its own watch ends it, that of
/// joints for good.
struct VelocityModes {
  /// In what the controller takes a velocity of the TCP (SetContinueVLine), which its sources do not agree
  /// on.
  enum class Line { Off, Millimetres, Metres };
  Line line = Line::Off;  ///< ContinueVLine: in mm/s and deg/s, or in m/s and rad/s
  bool joints = false;    ///< ContinueVJog
};

}  // namespace cobot_command
