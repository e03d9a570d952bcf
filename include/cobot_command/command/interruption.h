// Interruption of the running goals, so that they can continue later from where the robot stopped (SRCI:
// GroupInterrupt, GroupContinue).
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "cobot_command/arm/types.h"
#include "cobot_command/robot/active_frames.h"

namespace cobot_command::command {

// SRCI numbers that only these two services have.
inline constexpr int kContinueNotEnabled = 0x8C01;     ///< emergency stop, or an error of the controller
inline constexpr int kContinueNotThere = 0x8C02;       ///< the robot is not where it was interrupted
inline constexpr int kContinueWhileStopping = 0x8C43;  ///< the robot moves, or is being stopped

struct InterruptAnswer {
  bool success = false;
  int error_id = 0;
  std::string message;  ///< in plain words
};
/// Called once: at once, or when the robot is at standstill.
using InterruptReply = std::function<void(const InterruptAnswer& answer)>;

/// The settings of the controller on which targets and its model depend.
struct Setup {
  robot::ActiveFrames frames;
  std::optional<double> load;  ///< as commanded [kg]; nullopt: not commanded, or no longer known
};

/// Where the robot was interrupted, with its settings.
struct PrimaryPosition {
  arm::JointVector joints;  ///< [rad]
  /// End of the interrupted motion [rad]; nullopt: there was no motion.
  std::optional<arm::JointVector> segment_end;
  Setup setup;
};

}  // namespace cobot_command::command
