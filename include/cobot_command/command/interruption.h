// Interrupting what is under way so that it can go on later, from where the robot stood (SRCI:
// GroupInterrupt, GroupContinue).
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "cobot_command/arm/types.h"
#include "cobot_command/robot/active_frames.h"

namespace cobot_command::command {

// SRCI's numbers, of the two services alone.
inline constexpr int kContinueNotEnabled = 0x8C01;     ///< emergency stop, or an error of the controller
inline constexpr int kContinueNotThere = 0x8C02;       ///< the robot is not where it was interrupted
inline constexpr int kContinueWhileStopping = 0x8C43;  ///< the robot moves, or is being stopped

struct InterruptAnswer {
  bool success = false;
  int error_id = 0;
  std::string message;  ///< in plain words
};
/// Called once: at once, or when the robot stands.
using InterruptReply = std::function<void(const InterruptAnswer& answer)>;

/// What targets, and the model of the controller, stand on.
struct Setup {
  robot::ActiveFrames frames;
  std::optional<double> load;  ///< as it was commanded [kg]; nothing: not, or not known any more
};

/// Where the robot was interrupted, and how it was set up.
struct PrimaryPosition {
  arm::JointVector joints;                      ///< [rad]
  std::optional<arm::JointVector> segment_end;  ///< of the motion that it was at [rad]; none: it was at none
  Setup setup;
};

}  // namespace cobot_command::command
