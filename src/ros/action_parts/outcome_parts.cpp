#include "action_parts/outcome_parts.h"

#include "cobot_command/LoadPathFeedback.h"
#include "cobot_command/PickAndPlaceFeedback.h"

namespace cobot_command::ros_adapter {

std::uint8_t toPhase(blocks::Phase phase) {
  using Message = cobot_command::PickAndPlaceFeedback;  // it has all but that of paths
  switch (phase) {
    case blocks::Phase::Queued:
      return Message::QUEUED;
    case blocks::Phase::WaitingForTracking:
      return cobot_command::LoadPathFeedback::WAITING_FOR_TRACKING;
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

}  // namespace cobot_command::ros_adapter
