#include "cobot_command/blocks/exchange_configuration.h"

#include "action_parts/exchange_parts.h"
#include "action_parts/outcome_parts.h"
#include "action_parts/serve.h"

#include "cobot_command/ExchangeConfigurationAction.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::ros_adapter {

blocks::ExchangeConfigurationGoal toGoal(const cobot_command::ExchangeConfigurationGoal& message,
                                         const Lookups& /*lookups*/) {
  blocks::ExchangeConfigurationGoal goal;
  goal.name = message.name;
  goal.exec_mode = message.exec_mode;
  goal.priority = message.priority;
  goal.settings = toSettings(message.par_cmd);
  return goal;
}

void fill(cobot_command::ExchangeConfigurationResult& message, const blocks::Outcome& outcome,
          const FillSite& /*site*/) {
  fillEnd(message, outcome);
  message.error_id_enum = blocks::srciNameOf(outcome.error_id);
  fillReport(message, outcome.detail.as<blocks::ExchangeReport>());
}

void fill(cobot_command::ExchangeConfigurationFeedback& message, const blocks::Progress& progress,
          const FillSite& /*site*/) {
  message.text = forPeople(progress.text);
  fillReport(message, progress.detail.as<blocks::ExchangeReport>());
}

template <>
struct ActionOf<blocks::ExchangeConfigurationGoal> {
  using Type = cobot_command::ExchangeConfigurationAction;
};
template std::unique_ptr<GoalListener> serve<blocks::ExchangeConfigurationGoal>(const ActionSite& site);

}  // namespace cobot_command::ros_adapter
