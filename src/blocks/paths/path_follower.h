// Where the arm is on the piece of a path that is under way: by marks, by the joints of the status stream, or
// else by time; and how far it is from where it should be.
#pragma once

#include <cstddef>
#include <optional>

#include "chain/loaded_path.h"
#include "shared/plan_clock.h"

#include "cobot_command/common/time.h"
#include "cobot_command/path/deviation_watch.h"

namespace cobot_command::blocks {

class PathFollower {
 public:
  /// `rate`: see PlanClock.
  PathFollower(const arm::ArmModel& arm, LoadedPiecePtr piece, double rate, Instant now);

  /// Until it is let go, time stands still. Where the arm comes to rest, and how it gets up to its speed
  /// again, is no deviation.
  void hold(Instant now);
  void letGo(Instant now);
  /// Its time is another one than planned: the arm's place is followed alone, and no deviation is told.
  void loseClock() { has_clock_ = false; }
  /// That point is done, and all in front of it.
  void pass(std::size_t point);
  /// A status frame of now.
  void see(const arm::JointVector& joints, Instant now);

  /// Since the piece began, by its plan; never less than before, nor more than the piece takes.
  [[nodiscard]] Duration time(Instant now) const;
  [[nodiscard]] path::PathPlan::Place placeAt(Duration time) const { return piece_->plan.placeAt(time); }
  /// So far the stream has certainly shown the arm on its way; nothing: it has not yet.
  [[nodiscard]] std::optional<Duration> shown() const { return shown_; }
  [[nodiscard]] ProgressSource source() const { return source_; }
  /// What is left by the clock.
  [[nodiscard]] Duration remaining(Instant now) const;
  [[nodiscard]] path::Deviation deviation() const { return watch_.deviation(); }
  [[nodiscard]] double offThePath() const { return watch_.offThePath(); }

 private:
  /// The clock goes on from where the arm was seen.
  void setClock(Instant now);
  /// It was seen at `seen_`.
  [[nodiscard]] bool isThere(const arm::JointVector& joints) const;
  /// While it begins.
  void catchUp(const arm::JointVector& joints, Instant now);
  [[nodiscard]] Duration nearest(const arm::JointVector& joints, Duration from, Duration until) const;

  LoadedPiecePtr piece_;
  path::DeviationWatch watch_;
  PlanClock clock_;
  std::optional<Instant> picks_up_until_;  ///< its speed, behind a hold
  bool has_clock_ = true;
  std::optional<Duration> seen_;   ///< by the stream, or by a mark
  std::optional<Duration> shown_;  ///< by the stream alone
  ProgressSource source_ = ProgressSource::Plan;
};

}  // namespace cobot_command::blocks
