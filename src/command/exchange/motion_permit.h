// What the interface of SRCI has against motions: it is not enabled though it has to be, or data are out of
// sync.
#pragma once

#include <string>
#include <vector>

#include "exchange/exchange_desk.h"
#include "sync/sync_desk.h"
#include "sync/sync_guard.h"

#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/blocks/shared/goal_traits.h"

namespace cobot_command::command {

class MotionPermit {
 public:
  /// All have to live longer.
  MotionPermit(const ExchangeDesk& exchange, const SyncDesk& sync, const SyncGuard& guard)
      : exchange_(exchange), sync_(sync), guard_(guard) {}

  /// Against a goal as it comes.
  [[nodiscard]] std::vector<blocks::Failure> objectionsTo(const blocks::GoalTraits& traits) const;
  /// It waits, though it would be its turn. `robot_stands`: no blended motion is under way, as far as known.
  [[nodiscard]] bool holdsBack(const blocks::GoalTraits& traits, bool robot_stands) const;
  [[nodiscard]] bool interrupts() const { return guard_.interrupts(); }
  /// Why motions that wait do not begin. Precondition: interrupts().
  [[nodiscard]] std::string text() const;
  /// What leads out of it, or of a refusal, where that is not what the table of errors says; else "".
  [[nodiscard]] std::string remedy() const;

 private:
  const ExchangeDesk& exchange_;
  const SyncDesk& sync_;
  const SyncGuard& guard_;
};

}  // namespace cobot_command::command
