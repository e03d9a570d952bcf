#include "cobot_command/blocks/connect.h"

#include "action_parts/outcome_parts.h"
#include "action_parts/serve.h"

#include "cobot_command/ConnectAction.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::ros_adapter {
namespace {

/// In ROS time.
template <class Message>
void fillTimes(Message& message, const blocks::Detail& detail, const ClockPair& clocks) {
  const auto& times = detail.as<blocks::LinkTimes>();
  if (times.last_connected) message.last_connected = clocks.toRos(*times.last_connected);
  if (times.last_lost) message.last_lost = clocks.toRos(*times.last_lost);
}

}  // namespace

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
  fillTimes(message, outcome.detail, site.clocks);
}

void fill(cobot_command::ConnectFeedback& message, const blocks::Progress& progress, const FillSite& site) {
  using Message = cobot_command::ConnectFeedback;
  message.connected = progress.phase == blocks::Phase::Connected;
  message.phase = message.connected                          ? Message::CONNECTED
                  : progress.phase == blocks::Phase::Probing ? Message::PROBING
                                                             : Message::CONNECTING;
  message.text = forPeople(progress.text);
  fillTimes(message, progress.detail, site.clocks);
}

template <>
struct ActionOf<blocks::ConnectGoal> {
  using Type = cobot_command::ConnectAction;
};
template std::unique_ptr<GoalListener> serve<blocks::ConnectGoal>(const ActionSite& site);

}  // namespace cobot_command::ros_adapter
