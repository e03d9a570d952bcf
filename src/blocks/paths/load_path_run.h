// A chain of load_path goals under way: piece by piece, two of them at the controller, each goal with an end
// of its own (states: load_path_states.h).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "paths/load_path_states.h"
#include "paths/path_goals.h"
#include "paths/path_record.h"
#include "paths/path_restore.h"

#include "cobot_command/blocks/shared/path_controlled.h"
#include "cobot_command/robot/reason_wait.h"

namespace cobot_command::blocks {

class LoadPathRun final : public Run, public PathControlled {
 public:
  /// Precondition: it was planned from where the robot stands.
  LoadPathRun(GoalId id, const PathReport& planned, Instant now);

  /// Two PVTs, or the active point of a script and those in the buffer.
  [[nodiscard]] std::size_t window() const override;
  [[nodiscard]] std::optional<Command> next() const override;
  void commandStarted(CommandKey key) override;
  void commandProgressed(CommandKey key, const Progress& progress, Instant now) override;
  void commandPassed(CommandKey key, std::size_t mark, Instant now) override;
  void commandEnded(CommandKey key, const Outcome& outcome, Instant now) override;
  void commandRefused(CommandKey key, const Failure& failure, Instant now) override;
  [[nodiscard]] std::optional<std::string> stopsFor() const override;

  [[nodiscard]] GoesOn goesOn() const override {
    return state_ == State::Following ? GoesOn::ByItself : GoesOn::Never;
  }
  void cancel(const std::string& why, Instant now) override;
  void interrupt(const std::string& why, Instant now) override;
  /// Goals of which nothing is sent are dropped, the others carried out.
  void finish(FinishAfter after, Instant now) override;
  void linkLost(const std::string& reason, std::optional<Duration> patience, Instant now) override;
  void robotChanged(const robot::RobotWatch& robot, Instant now) override;
  void advance(Instant now) override;
  [[nodiscard]] std::optional<Instant> nextDeadline() const override;

  [[nodiscard]] PathControlled* paths() override { return this; }
  void use(const path::PathControls& controls, Instant now) override;
  [[nodiscard]] std::optional<path::TrackingFlags> wantedTracking() const override;

  [[nodiscard]] PathPace pace() const override;
  void restart() override;
  [[nodiscard]] bool isPvtRefused() const override { return pvt_refused_; }
  [[nodiscard]] std::optional<PathWork> takeReplan() override;
  [[nodiscard]] std::optional<std::string> replanned(const Detail& found) override;
  [[nodiscard]] path::DrivenPath driven() const override { return record_.driven(); }

  [[nodiscard]] GoalChain* chain() override { return state_ == State::Following ? &goals_ : nullptr; }
  [[nodiscard]] bool serves(GoalId goal) const override { return goals_.pieces().memberOf(goal).has_value(); }
  /// A stop of a goal that was not loaded is an error of that goal (1007), and of nobody behind it.
  [[nodiscard]] bool failed() const override { return Run::failed() && !interrupted_; }

 private:
  using Event = LoadPathEvent;
  using State = LoadPathState;

  void fire(Event event, Instant now);
  void fail(Failure failure, Instant now);
  /// Nothing is at the controller, or only what was sent before it failed.
  void endWhenNothingIsLeft(Instant now);
  [[nodiscard]] std::optional<Instant> openEndDue() const;
  /// Nothing of it is at the controller any more.
  void goOnFrom(const robot::RobotWatch& robot, Instant now);
  /// A piece, or what was to be the next one, was stopped or failed.
  void endEarly(const Outcome& outcome, Instant now);
  /// So many points are done, by a tag.
  void done(std::size_t points, Instant now);

  Outcome ended_at_;  ///< where the last command left the robot, as the stream has shown it
  PathGoals goals_;
  PathRecord record_;
  State state_ = State::Following;
  Instant waits_from_;   ///< for a goal that joins, with nothing at the controller
  PathRestore restore_;  ///< goes out behind a stop
  bool restarting_ = false;
  bool pvt_refused_ = false;
  bool interrupted_ = false;
  std::string stopped_why_;  ///< and what became of the robot
  std::optional<Failure> failure_;
  robot::ReasonWait reason_;
  std::optional<Instant> reason_until_;
};

}  // namespace cobot_command::blocks
