#include "cobot_command/blocks/exit_listen_node.h"

#include "shared/parameter_checks.h"

namespace cobot_command::blocks {

ErrorTable ExitListenNodeGoal::errors() {
  return ErrorTable().anyCommand().turn().inCell();
}

GoalTraits traitsOf(const ExitListenNodeGoal& goal) {
  GoalTraits traits;
  traits.buffer_mode = bufferModeOf(goal.buffer_mode);
  traits.exits_node = true;
  return traits;
}

std::vector<Failure> check(const ExitListenNodeGoal& goal) {
  ParameterChecks checks;
  checks.bufferMode(goal.buffer_mode);
  return std::move(checks).violations();
}

Order orderOf(const ExitListenNodeGoal& /*goal*/, const arm::Pose& /*base*/) {
  Order order;
  order.commands.emplace();
  return order;
}

}  // namespace cobot_command::blocks
