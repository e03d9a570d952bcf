#include "cobot_command/ros/outcome_messages.h"

#include "cobot_command/PickAndPlaceFeedback.h"

namespace cobot_command::ros_adapter {

std::uint8_t toPhase(blocks::Phase phase) {
  using Message = cobot_command::PickAndPlaceFeedback;  // it has them all
  switch (phase) {
    case blocks::Phase::Queued:
      return Message::QUEUED;
    case blocks::Phase::Active:
      return Message::ACTIVE;
    case blocks::Phase::Held:
      return Message::HELD;
    case blocks::Phase::Dwelling:
      return Message::DWELLING;
    case blocks::Phase::Stopping:
      return Message::STOPPING;
    case blocks::Phase::Sent:
    case blocks::Phase::Connecting:
    case blocks::Phase::Probing:
    case blocks::Phase::Connected:
      break;
  }
  return Message::SENT;
}

void fill(cobot_command::ConnectFeedback& message, const blocks::Progress& progress) {
  using Message = cobot_command::ConnectFeedback;
  message.connected = progress.phase == blocks::Phase::Connected;
  message.phase = message.connected                          ? Message::CONNECTED
                  : progress.phase == blocks::Phase::Probing ? Message::PROBING
                                                             : Message::CONNECTING;
  message.text = progress.text;
}

}  // namespace cobot_command::ros_adapter
