// From a goal to what goes over the wire for it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "preflight.h"

#include "cobot_command/blocks/error_catalogue.h"
#include "cobot_command/blocks/goal.h"
#include "cobot_command/common/time.h"
#include "cobot_command/script/script_command.h"

namespace cobot_command::blocks {

struct CommandOrder {
  Block block = Block::MoveAbsolute;
  GoalId goal = 0;
  int command_id_ack = 0;
  std::optional<int> tag;  ///< open in the ledger; none: done as soon as it is accepted
  std::vector<std::string> lines;
  /// What the lines mean, tag and exit aside; absent when they are a raw script that says more than this
  /// layer knows.
  std::optional<std::vector<script::ScriptCommand>> commands;
  bool moves = false;             ///< a cancel has to stop the robot
  bool exits_node = false;        ///< ScriptExit() is to stand behind its lines
  bool has_exit = false;          ///< its own lines end with one that has a number
  bool exits_afterwards = false;  ///< the node is to be left with a script of its own once it is done
  bool beside = false;            ///< goes out beside what is on the wire, whatever state the robot is in
  bool pauses = false;            ///< a script with a Pause() of its own
  bool stands_at_end = true;  ///< the robot stands when its tag comes; false: a script that sets velocities
  std::optional<Duration> reply_timeout;  ///< other than that of the link
  std::optional<Plan> plan;
  std::optional<Target> target;  ///< where it leaves the robot, if that is certain
};

/// The block's own lines, without tag and exit. `base`: the active base in the robot base, for targets in a
/// tf frame. Precondition: check() found nothing.
[[nodiscard]] CommandOrder orderOf(const MoveAbsoluteGoal& goal, const arm::Pose& base);
[[nodiscard]] CommandOrder orderOf(const MoveRelativeGoal& goal, const arm::Pose& base);
[[nodiscard]] CommandOrder orderOf(const MoveCircleGoal& goal, const arm::Pose& base);
[[nodiscard]] CommandOrder orderOf(const ChangeBaseGoal& goal, const arm::Pose& base);
[[nodiscard]] CommandOrder orderOf(const ChangeTcpGoal& goal, const arm::Pose& base);
[[nodiscard]] CommandOrder orderOf(const ExitListenNodeGoal& goal, const arm::Pose& base);
[[nodiscard]] CommandOrder orderOf(const RunScriptGoal& goal, const arm::Pose& base);
[[nodiscard]] CommandOrder orderOf(const ProgramControlGoal& goal);
/// Precondition: it names a module (script::ioModule()).
[[nodiscard]] CommandOrder orderOf(const OutputAction& output);

/// The queue tag, when one is open for it, and the exit from the node.
void addLastLines(CommandOrder& order);

}  // namespace cobot_command::blocks
