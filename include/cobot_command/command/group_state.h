// State of the robot and of the interface to it, in short: the state of the group in SRCI.
#pragma once

#include <optional>
#include <string>

#include "cobot_command/blocks/exchange_configuration.h"
#include "cobot_command/robot/speed_trend.h"

namespace cobot_command::command {

struct GroupState {
  /// State of the commands.
  enum class Sequence {
    Idle = 0,
    Executing = 1,  ///< a command is running or queued
    /// The same, and the robot is paused, also by a safeguard; or motions are interrupted because data is out
    /// of sync, or by interrupt.
    Interrupted = 2
  };

  blocks::RiState ri_state = blocks::RiState::NotInitialized;
  std::string out_of_sync;  ///< enabled data that is out of sync, in words; empty: none
  /// Commands can be sent: no emergency stop, and no error of the controller.
  bool enabled = false;
  Sequence sequence = Sequence::Idle;
  bool in_primary_position = true;  ///< the robot is where it was interrupted, or is not interrupted
  double queue_usage = 0;           ///< share of the commands that can be held [%]
  int pending_errors = 0;
  int pending_warnings = 0;
  std::optional<robot::Trend> trend;  ///< nullopt: not known
  double speed_override = 100;        ///< as it was set [%]
  double effective_speed = 100;       ///< OverrideAnswer::effective [%]

  friend bool operator==(const GroupState& a, const GroupState& b);
};

}  // namespace cobot_command::command
