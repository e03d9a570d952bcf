// What becomes of motions while enabled data are out of sync: the clock of the reaction, and its states.
#pragma once

#include <optional>
#include <utility>

#include "sync/sync_guard_states.h"

#include "cobot_command/blocks/exchange_configuration.h"
#include "cobot_command/common/time.h"

namespace cobot_command::command {

class SyncGuard {
 public:
  /// How things are, behind an event.
  struct Seen {
    bool judged = true;  ///< the data were compared; else nothing is known of them yet
    bool in_sync = true;
    bool robot_enabled = false;   ///< no emergency stop, no error of the controller
    bool anything_there = false;  ///< a command is under way, or waits
    bool moves = false;           ///< something is under way that moves, held or not
  };

  /// From now on, with a robot that counts as not enabled until it was seen in sync.
  void begin(Duration delay, blocks::SyncReaction reaction);
  /// Others for the same data.
  void change(Duration delay, blocks::SyncReaction reaction);
  /// Nothing is compared any more; what is interrupted waits to be resumed.
  void end() { stop(SyncGuardEvent::Released); }
  void linkLost() { stop(SyncGuardEvent::LinkLost); }

  void look(const Seen& seen, Instant now);
  [[nodiscard]] std::optional<Instant> nextDeadline() const;
  // Each is told when it happens.
  void resumed() { fire(SyncGuardEvent::Resumed); }
  void emptied() { fire(SyncGuardEvent::Emptied); }
  void motionWaits() { fire(SyncGuardEvent::Waits); }

  // --- What motions are to know.
  /// New ones are refused.
  [[nodiscard]] bool refuses() const { return state_ == State::Refusing; }
  /// None begins, and those that cannot wait are refused.
  [[nodiscard]] bool interrupts() const;
  /// Nobody may resume what is interrupted.
  [[nodiscard]] bool deniesResume() const { return state_ == State::Interrupted || state_ == State::Stopped; }

  /// The robot has to be paused on its path, once; also one that is held, as whoever holds it may let it go.
  [[nodiscard]] bool takePause() { return std::exchange(pauses_, false); }
  /// It refuses or interrupts since the last call.
  [[nodiscard]] bool takeTold() { return std::exchange(tells_, false); }

 private:
  using State = SyncGuardState;
  using Event = SyncGuardEvent;

  void fire(Event event);
  void stop(Event event);
  void react(const Seen& seen);
  [[nodiscard]] bool isDue(Instant now) const { return since_ && now >= *since_ + delay_; }

  State state_ = State::Free;
  bool is_active_ = false;
  Duration delay_{};
  blocks::SyncReaction reaction_ = blocks::SyncReaction::None;
  bool operates_ = false;         ///< the robot is enabled, and was so while it was in sync
  std::optional<Instant> since_;  ///< out of sync
  bool is_due_ = false;           ///< for as long as the delay says
  bool moves_ = false;            ///< as seen last
  bool pauses_ = false;
  bool tells_ = false;
};

}  // namespace cobot_command::command
