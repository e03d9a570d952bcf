#include "cobot_command/blocks/change_tcp.h"

#include "action_parts/goal_parts.h"
#include "action_parts/outcome_parts.h"
#include "action_parts/serve.h"
#include "action_parts/step_goals.h"

#include "cobot_command/ChangeTCPAction.h"

namespace cobot_command::ros_adapter {

blocks::ChangeTcpGoal toGoal(const cobot_command::ChangeTCPGoal& message, const Lookups& /*lookups*/) {
  blocks::ChangeTcpGoal goal;
  takeCommand(goal, message);
  goal.tcp_offset = toSix(message.tcp_offset);
  goal.weight = message.weight;
  goal.moment_of_inertia = {message.moment_of_inertia.ixx, message.moment_of_inertia.iyy,
                            message.moment_of_inertia.izz};
  goal.mass_center = toSix(message.mass_center);
  goal.tcp_name = message.tcp_name;
  return goal;
}

void fill(cobot_command::ChangeTCPResult& message, const blocks::Outcome& outcome, const FillSite& /*site*/) {
  fillCommandEnd(message, outcome);
}

void fill(cobot_command::ChangeTCPFeedback& message, const blocks::Progress& progress,
          const FillSite& /*site*/) {
  fillCommandTurn(message, progress);
}

template <>
struct ActionOf<blocks::ChangeTcpGoal> {
  using Type = cobot_command::ChangeTCPAction;
};
template std::unique_ptr<GoalListener> serve<blocks::ChangeTcpGoal>(const ActionSite& site);

}  // namespace cobot_command::ros_adapter
