// Properties that all goals have: how a goal is carried out, and how it relates to other goals.
#pragma once

#include <optional>

#include "cobot_command/blocks/shared/goal_values.h"
#include "cobot_command/common/time.h"

namespace cobot_command::blocks {

/// How a goal is carried out.
enum class Way {
  Link,       ///< makes and keeps the connection
  Configure,  ///< sets how the layer behaves while the goal is active; nothing is sent for it
  Stop,       ///< stops the robot at once
  Beside,     ///< is sent at once, in parallel with the running command
  Plan,       ///< is answered by planning; nothing is sent
  Queue       ///< is queued until its turn
};

struct GoalTraits {
  Way way = Way::Queue;
  int command_id = 0;
  BufferMode buffer_mode = BufferMode::Refuse;
  bool awaits_motion = false;  ///< Done when its queue tag returns; else when the controller has accepted it
  bool exits_node = false;     ///< a ScriptExit follows it
  bool check_only = false;     ///< only planned and answered, as with Way::Plan
  bool may_move = false;       ///< it may move the robot
  bool halts = false;          ///< it can only stop or pause the robot
  bool resumes = false;        ///< it resumes a paused robot
  /// The preceding blended motion runs to its end first, while exchange_configuration is enabled without
  /// dynamic blending.
  bool ends_blend = false;
  /// Its turn comes when the preceding blended motion has ended, as reported by a tag after that motion.
  bool awaits_rest = false;
  /// Way::Beside: is sent on any connection, even if it is not known whether the controller listens, and also
  /// in an emergency stop.
  bool tried_anyway = false;
  bool chains = false;            ///< after another goal of its block it waits, whatever its buffer_mode
  bool needs_base = false;        ///< a target is in a tf frame: the active base must be known
  bool needs_plan = false;        ///< it consists of its plan: without one it is refused at its turn
  bool asks_permit = false;       ///< a frame of a program in a cell, which must be sent only with a permit
  bool needs_standstill = false;  ///< refused while the robot moves, as if another command were Busy
  bool needs_automatic = false;   ///< refused while the status stream shows manual mode
  std::optional<Duration> reply_timeout;  ///< replaces that of the link
  /// Replaces that of the link: time after its tag in which the status stream must show it at its target.
  std::optional<Duration> evidence_timeout;
};

/// Accepts any value; one that the checks refuse becomes BufferMode::Refuse.
[[nodiscard]] BufferMode bufferModeOf(int buffer_mode);

/// For the commands of the thesis, which all have these three inputs.
template <class Goal>
[[nodiscard]] GoalTraits traitsOfCommand(const Goal& goal) {
  GoalTraits traits;
  traits.command_id = goal.command_id;
  traits.buffer_mode = bufferModeOf(goal.buffer_mode);
  traits.exits_node = goal.exit_node;
  return traits;
}

}  // namespace cobot_command::blocks
