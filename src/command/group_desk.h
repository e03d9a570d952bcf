// The state of the group, told when it is another one than before.
#pragma once

#include <optional>
#include <vector>

#include "arbiter/arbiter.h"
#include "connecting/link_keeper.h"
#include "exchange/exchange_desk.h"
#include "messages/message_desk.h"
#include "sync/sync_desk.h"
#include "sync/sync_guard.h"

#include "cobot_command/command/actions.h"
#include "cobot_command/command/group_state.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::command {

class GroupDesk {
 public:
  /// Parts of the core; all have to live longer.
  struct Parts {
    const robot::RobotWatch& robot;
    const LinkKeeper& keeper;
    const ExchangeDesk& exchange;
    const SyncDesk& sync;
    const SyncGuard& guard;
    const Arbiter& arbiter;
    const MessageDesk& messages;
  };
  GroupDesk(const Parts& parts, std::vector<Action>& actions) : parts_(parts), actions_(actions) {}

  /// To be called behind each event.
  void tell();

 private:
  [[nodiscard]] GroupState::Sequence sequence() const;
  /// Remembers where the robot came to rest when it was interrupted.
  [[nodiscard]] bool isInPrimaryPosition(GroupState::Sequence sequence);

  Parts parts_;
  std::vector<Action>& actions_;
  std::optional<arm::JointVector> interrupted_at_;
  GroupState told_;
};

}  // namespace cobot_command::command
