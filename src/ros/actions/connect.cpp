#include "cobot_command/blocks/connect.h"

#include "action_parts/outcome_parts.h"
#include "action_parts/serve.h"

#include "cobot_command/ConnectAction.h"

namespace cobot_command::ros_adapter {

blocks::ConnectGoal toGoal(const cobot_command::ConnectGoal& message, const Lookups& /*lookups*/) {
  blocks::ConnectGoal goal;
  goal.host = message.host;
  goal.port = message.port;
  goal.timeout = message.timeout;
  if (message.status_port != 0) goal.status_port = message.status_port;
  return goal;
}

void fill(cobot_command::ConnectResult& message, const blocks::Outcome& outcome, const FillSite& site) {
  fillEnd(message, outcome);
  fillTimes(message, outcome.link_times, site.clocks);
}

void fill(cobot_command::ConnectFeedback& message, const blocks::Progress& progress, const FillSite& site) {
  using Message = cobot_command::ConnectFeedback;
  message.connected = progress.phase == blocks::Phase::Connected;
  message.phase = message.connected                          ? Message::CONNECTED
                  : progress.phase == blocks::Phase::Probing ? Message::PROBING
                                                             : Message::CONNECTING;
  message.text = progress.text;
  fillTimes(message, progress.link_times, site.clocks);
}

template <>
struct ActionOf<blocks::ConnectGoal> {
  using Type = cobot_command::ConnectAction;
};
template std::unique_ptr<GoalListener> serve<blocks::ConnectGoal>(const ActionSite& site);

}  // namespace cobot_command::ros_adapter
