// The one exchange_configuration goal: what it wants rules while it is enabled, and what there is is told
// (SRCI).
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "board/output_board.h"
#include "connecting/link_keeper.h"
#include "exchange/exchange_states.h"
#include "exchange/life_sign.h"
#include "exchange/motion_hold.h"
#include "links/links.h"
#include "messages/message_desk.h"
#include "sync/sync_desk.h"
#include "sync/sync_guard.h"

#include "cobot_command/blocks/exchange_configuration.h"
#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/command/exchange_answer.h"
#include "cobot_command/command/waiting_goals.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::command {

class ExchangeDesk {
 public:
  /// What it rules, and what it looks at; all have to live longer.
  struct Core {
    link::LinkSettings& settings;  ///< that rule, made of those of the node
    Links& links;
    const robot::RobotWatch& robot;
    const LinkKeeper& keeper;
    OutputBoard& board;
    MessageDesk& messages;
    MotionHold& hold;
    SyncDesk& sync;
    SyncGuard& guard;
  };
  explicit ExchangeDesk(const Core& core) : core_(core), node_(core.settings) {}

  /// Of the node; for the next goal.
  void useRules(const ExchangeRules& rules) { rules_ = rules; }
  /// Those of the node; what an enabled goal wants otherwise stays so.
  void useSettings(const link::LinkSettings& node, Instant now);

  // --- The goal.
  /// Takes it, or ends it at once.
  void execute(blocks::GoalId id, const blocks::ExchangeConfigurationGoal& goal, Instant now);
  [[nodiscard]] bool serves(blocks::GoalId id) const { return id_ == id; }
  void cancel(Instant now);
  [[nodiscard]] ExchangeAnswer update(const blocks::ExchangeSettings& settings, Instant now);
  void shutDown(const std::string& why, Instant now);

  [[nodiscard]] blocks::RiState riState() const {
    return isEnabled() ? report_.ri_state : blocks::RiState::NotInitialized;
  }
  [[nodiscard]] bool isEnabled() const { return state_ == ExchangeState::Enabled; }
  /// Without it nothing may be moved.
  [[nodiscard]] bool isRequired() const { return rules_.required; }
  /// Blended motions go to their end where a script waits behind them.
  [[nodiscard]] bool endsBlends() const { return isEnabled() && !goal_.settings.allow_dynamic_blending; }
  /// Its client has disabled it since the last call.
  [[nodiscard]] bool takeDisabled() { return std::exchange(disabled_, false); }

  // --- Events.
  /// What follows from an event, to be called behind it.
  void look(Instant now);
  /// So many commands are held.
  void seeQueue(int depth) { queue_is_nearly_full_ = depth >= kManyCommands; }
  /// As soon as that is known, before other parts forget it.
  void linkLost(const std::string& reason, Instant now);
  void advance(Instant now);
  [[nodiscard]] std::optional<Instant> nextDeadline() const;

 private:
  using State = ExchangeState;
  using Event = ExchangeEvent;

  void fire(Event event, Instant now);
  void act(ExchangeAction action, Instant now);
  void begin(Instant now);
  void enable(Instant now);
  [[nodiscard]] bool tellsMotionState() const;
  void takeUpdate(Instant now);
  /// What has come of the comparison.
  void noteSync();
  void restore(Instant now);
  /// What the goal wants.
  void rule(Instant now);
  void loseLifeSign(Instant now);
  void end(blocks::Ending ending, const blocks::Failure& failure);
  void endDone();
  /// Where it is another one than before, or the last one is a second old.
  void report(Instant now);
  void tell(Instant now);

  Core core_;
  link::LinkSettings node_;
  ExchangeRules rules_;
  State state_ = State::Disabled;
  std::optional<blocks::GoalId> id_;
  blocks::ExchangeConfigurationGoal goal_;
  std::optional<blocks::ExchangeSettings> update_;  ///< to be taken now
  std::optional<Instant> deadline_;                 ///< of Enabling and Disabling
  LifeSign life_sign_;
  bool life_sign_lost_ = false;
  bool disabled_ = false;
  bool queue_is_nearly_full_ = false;
  std::string why_;  ///< it ends, when not by its client
  blocks::ExchangeReport report_;
  blocks::ExchangeReport told_;
  std::optional<Instant> tell_at_;
};

}  // namespace cobot_command::command
