// The time of one command: when it begins to be executed, by when it has to be done, and how long it has
// taken. All of it stands still while the robot is held.
#pragma once

#include <optional>

#include "cobot_command/common/time.h"

namespace cobot_command::command {

class CommandClock {
 public:
  /// `patience`: so long it is waited when nobody can tell whether the robot moves.
  CommandClock(Instant now, Duration patience) : waits_from_(now), give_up_at_(now + patience) {}

  // --- Holds.
  /// Nothing falls due from now on.
  void hold(Instant now);
  /// What was to come is put off by as long as it was held.
  void release(Instant now);
  [[nodiscard]] bool held() const { return held_since_.has_value(); }

  // --- The execution.
  /// It is to begin so long from now, and to be done `time` from now. A hold counts from now on.
  void expect(Instant now, Duration start_delay, Duration time);
  /// Its time to begin has come, and it has not begun.
  [[nodiscard]] bool beginsNow(Instant now) const;
  /// Does not wait for a time to begin, or no more.
  [[nodiscard]] bool mayExecute(Instant now) const { return executing_from_ || !waits(now); }
  /// It is executed, if not since before.
  void execute(Instant now);
  /// For how long, less the holds; zero before.
  [[nodiscard]] Duration executed(Instant now) const;
  /// The same since the beginning.
  [[nodiscard]] Duration waited(Instant now) const { return held_since_.value_or(now) - waits_from_; }

  // --- The deadline.
  void setDeadline(Instant at) { deadline_ = at; }
  /// It has so much more time, or less, than was expected.
  void prolong(Duration by);
  [[nodiscard]] bool hasDeadline() const { return deadline_.has_value(); }
  [[nodiscard]] bool overdue(Instant now) const { return deadline_ && now >= *deadline_ && !held(); }
  /// A question is asked, and there is no deadline until its answer. `early`: it has not come yet, and is
  /// kept.
  void ask(bool early);
  [[nodiscard]] bool askedEarly() const { return kept_.has_value(); }
  /// The answer left it open: the deadline that was kept, or this one.
  void goOn(Instant otherwise);
  [[nodiscard]] bool patient(Instant now) const { return now < give_up_at_; }

  /// Whatever was awaited has come, or is awaited no more.
  void clear();
  /// The next instant at which something falls due.
  [[nodiscard]] std::optional<Instant> next() const;

 private:
  [[nodiscard]] bool waits(Instant now) const { return begins_at_ && now < *begins_at_; }

  Instant waits_from_;                     ///< later by every hold since
  std::optional<Instant> begins_at_;       ///< when the commands in front of it should be done
  std::optional<Instant> executing_from_;  ///< later by every hold since
  std::optional<Instant> deadline_;
  std::optional<Instant> kept_;  ///< the deadline, while a question is asked before it
  std::optional<Instant> held_since_;
  Instant give_up_at_;
};

}  // namespace cobot_command::command
