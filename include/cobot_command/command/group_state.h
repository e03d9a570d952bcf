// How the robot and the interface to it are, in few words: the state of the group of SRCI.
#pragma once

#include <optional>
#include <string>

#include "cobot_command/blocks/exchange_configuration.h"
#include "cobot_command/robot/speed_trend.h"

namespace cobot_command::command {

struct GroupState {
  /// Of what was commanded.
  enum class Sequence {
    Idle = 0,
    Executing = 1,  ///< something is under way, or waits
    /// The same, and the robot is held: paused, or by a safeguard; or motions are interrupted, as data are
    /// out of sync.
    Interrupted = 2
  };

  blocks::RiState ri_state = blocks::RiState::NotInitialized;
  std::string out_of_sync;  ///< of the data that are enabled, in words; empty: nothing
  bool enabled = false;     ///< commands can be sent: no emergency stop, and no error of the controller
  Sequence sequence = Sequence::Idle;
  bool in_primary_position = true;  ///< where it was interrupted, or not interrupted
  double queue_usage = 0;           ///< of the commands that can be held [%]
  int pending_errors = 0;
  int pending_warnings = 0;
  std::optional<robot::Trend> trend;  ///< nothing: not known
  double speed_override = 100;        ///< as it was set [%]
  double effective_speed = 100;       ///< OverrideAnswer::effective [%]

  friend bool operator==(const GroupState& a, const GroupState& b);
};

}  // namespace cobot_command::command
