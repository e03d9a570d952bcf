// What each block makes of its goal: the checks of its parameters, and its script. Pure values.
//
// How a command lives on the wire is the same for all and not told here: command_run.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "failure.h"

#include "cobot_command/blocks/goal.h"
#include "cobot_command/common/time.h"
#include "cobot_command/script/script_command.h"

namespace cobot_command::blocks {

/// What the arbiter has to know of a command, whatever its block.
struct CommandTraits {
  int command_id = 0;
  BufferMode buffer_mode = BufferMode::Refuse;
  bool awaits_motion = false;  ///< Done when its queue tag came back; else when the controller accepted it
  bool exits_node = false;     ///< ScriptExit behind it
  bool check_only = false;
  bool needs_base = false;                ///< a target in a tf frame: the active base has to be known
  std::optional<Duration> reply_timeout;  ///< other than that of the link
};

[[nodiscard]] CommandTraits traitsOf(const MoveAbsoluteGoal& goal);
[[nodiscard]] CommandTraits traitsOf(const MoveRelativeGoal& goal);
[[nodiscard]] CommandTraits traitsOf(const MoveCircleGoal& goal);
[[nodiscard]] CommandTraits traitsOf(const ChangeBaseGoal& goal);
[[nodiscard]] CommandTraits traitsOf(const ChangeTcpGoal& goal);
[[nodiscard]] CommandTraits traitsOf(const ExitListenNodeGoal& goal);
[[nodiscard]] CommandTraits traitsOf(const RunScriptGoal& goal);

/// All violations of the goal's own parameters, in table order; empty when it may be sent. Numbers are not
/// looked at where a pose or a name stands in place of them.
[[nodiscard]] std::vector<Failure> check(const MoveAbsoluteGoal& goal);
[[nodiscard]] std::vector<Failure> check(const MoveRelativeGoal& goal);
[[nodiscard]] std::vector<Failure> check(const MoveCircleGoal& goal);
[[nodiscard]] std::vector<Failure> check(const ChangeBaseGoal& goal);
[[nodiscard]] std::vector<Failure> check(const ChangeTcpGoal& goal);
[[nodiscard]] std::vector<Failure> check(const ProgramControlGoal& goal);
[[nodiscard]] std::vector<Failure> check(const ExitListenNodeGoal& goal);
[[nodiscard]] std::vector<Failure> check(const RunScriptGoal& goal);

/// The command of the block, without QueueTag and ScriptExit. `base`: the active base in the robot base, for
/// targets in a tf frame. The controller takes whole numbers for speed, time and blending: they are rounded
/// to the nearest, the speed to 1 at least. Precondition: check() found nothing.
[[nodiscard]] script::ScriptCommand commandOf(const MoveAbsoluteGoal& goal, const arm::Pose& base);
[[nodiscard]] script::ScriptCommand commandOf(const MoveRelativeGoal& goal, const arm::Pose& base);
[[nodiscard]] script::ScriptCommand commandOf(const MoveCircleGoal& goal, const arm::Pose& base);
[[nodiscard]] script::ScriptCommand commandOf(const ChangeBaseGoal& goal, const arm::Pose& base);
[[nodiscard]] script::ScriptCommand commandOf(const ChangeTcpGoal& goal, const arm::Pose& base);
[[nodiscard]] script::ScriptCommand commandOf(const ProgramControlGoal& goal);

/// The lines of a raw script, without line ends, without empty ones, and without a ScriptExit() at the end:
/// that is told by CommandTraits::exits_node, as it has to come behind the queue tag. Precondition as above.
[[nodiscard]] std::vector<std::string> linesOf(const RunScriptGoal& goal);

}  // namespace cobot_command::blocks
