// The clock and the states of what happens to motions while enabled data are out of sync.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "sync/sync_reaction_states.h"

#include "cobot_command/blocks/exchange_configuration.h"
#include "cobot_command/common/time.h"

namespace cobot_command::command {

class SyncReaction {
 public:
  /// How things are, behind an event.
  struct Seen {
    bool judged = true;  ///< the data were compared; else nothing is known of them yet
    bool in_sync = true;
    bool robot_enabled = false;   ///< no emergency stop, no error of the controller
    bool anything_there = false;  ///< a command is under way, or waits
  };

  /// From now on, with a robot that counts as not enabled until it was seen in sync.
  void begin(Duration delay, blocks::SyncReaction reaction);
  /// Others for the same data.
  void change(Duration delay, blocks::SyncReaction reaction);
  /// Nothing is compared any more; what is interrupted waits to be resumed.
  void end() { stop(SyncReactionEvent::Released); }
  void linkLost() { stop(SyncReactionEvent::LinkLost); }

  void look(const Seen& seen, Instant now);
  [[nodiscard]] std::optional<Instant> nextDeadline() const;
  // Each is told when it happens.
  void resumed() { fire(SyncReactionEvent::Resumed); }
  void emptied() { fire(SyncReactionEvent::Emptied); }
  void motionWaits() { fire(SyncReactionEvent::Waits); }

  // --- What motions are to know.
  /// New ones are refused.
  [[nodiscard]] bool refuses() const { return state_ == State::Refusing; }
  /// None begins, and those that cannot wait are refused.
  [[nodiscard]] bool interrupts() const;
  /// Nobody may resume what is interrupted.
  [[nodiscard]] bool deniesResume() const { return state_ == State::Interrupted || state_ == State::Stopped; }

  /// The robot has to be paused on its path, once.
  [[nodiscard]] bool takePause() { return std::exchange(pauses_, false); }
  /// It refuses or interrupts since the last call.
  [[nodiscard]] bool takeTold() { return std::exchange(tells_, false); }

 private:
  using State = SyncReactionState;
  using Event = SyncReactionEvent;

  void fire(Event event);
  void stop(Event event);
  void react(const Seen& seen);

  State state_ = State::Free;
  bool is_active_ = false;
  Duration delay_{};
  blocks::SyncReaction reaction_ = blocks::SyncReaction::None;
  bool operates_ = false;       ///< the robot is enabled, and was so while it was in sync
  std::optional<Instant> due_;  ///< of the reaction: out of sync since a delay before
  bool is_due_ = false;
  bool pauses_ = false;
  bool tells_ = false;
};

}  // namespace cobot_command::command
