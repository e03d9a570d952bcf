// What is the same of all goals: how each is carried out, and among which others.
#pragma once

#include <optional>

#include "cobot_command/blocks/shared/goal_values.h"
#include "cobot_command/common/time.h"

namespace cobot_command::blocks {

/// How a goal is carried out.
enum class Way {
  Link,       ///< makes and keeps the connection
  Configure,  ///< rules how the layer behaves, for as long as it lives; nothing is sent for it
  Stop,       ///< stops the robot, at once
  Beside,     ///< goes out beside whatever is under way, whatever state the robot is in
  Plan,       ///< is answered by planning; nothing is sent
  Queue       ///< comes when it is its turn
};

struct GoalTraits {
  Way way = Way::Queue;
  int command_id = 0;
  BufferMode buffer_mode = BufferMode::Refuse;
  bool awaits_motion = false;  ///< Done when its queue tag came back; else when the controller accepted it
  bool exits_node = false;     ///< ScriptExit behind it
  bool check_only = false;     ///< to be planned and answered, as with Way::Plan
  bool may_move = false;       ///< the robot may be moved by it
  bool halts = false;          ///< it can only take motion away from the robot
  bool resumes = false;        ///< it lets a robot go on that is held
  bool ends_blend = false;     ///< a blended motion in front of it goes to its end, but with dynamic blending
  bool awaits_rest = false;    ///< its turn comes when a blended motion in front of it has come to its end,
                               ///< as a tag behind that tells
  bool tried_anyway = false;   ///< Way::Beside: on any connection, also one that is not known to listen
  bool chains = false;         ///< behind another one of its block it waits, whatever its buffer_mode
  bool needs_base = false;     ///< a target in a tf frame: the active base has to be known
  bool needs_plan = false;     ///< it is made of its plan: without one it is refused when its turn comes
  bool asks_permit = false;    ///< a frame of a program in a cell, which is to leave only with a permit
  bool needs_standstill = false;             ///< refused, as by another that is Busy, while the robot moves
  bool needs_automatic = false;              ///< refused while the status stream shows the manual mode
  std::optional<Duration> reply_timeout;     ///< other than that of the link
  std::optional<Duration> evidence_timeout;  ///< the same: to be seen at its target, behind its tag
};

/// Total: what the checks refuse is BufferMode::Refuse here.
[[nodiscard]] BufferMode bufferModeOf(int buffer_mode);

/// Of the thesis's commands, which all have these three inputs.
template <class Goal>
[[nodiscard]] GoalTraits traitsOfCommand(const Goal& goal) {
  GoalTraits traits;
  traits.command_id = goal.command_id;
  traits.buffer_mode = bufferModeOf(goal.buffer_mode);
  traits.exits_node = goal.exit_node;
  return traits;
}

}  // namespace cobot_command::blocks
