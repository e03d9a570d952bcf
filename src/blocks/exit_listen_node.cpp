// Leaving the Listen node: ScriptExit, and nothing in front of it.

#include "parameter_checks.h"

namespace cobot_command::blocks {

CommandTraits traitsOf(const ExitListenNodeGoal& goal) {
  CommandTraits traits;
  traits.buffer_mode = bufferModeOf(goal.buffer_mode);
  traits.exits_node = true;
  return traits;
}

std::vector<Failure> check(const ExitListenNodeGoal& goal) {
  ParameterChecks checks;
  checks.bufferMode(goal.buffer_mode);
  return std::move(checks).violations();
}

}  // namespace cobot_command::blocks
