// A chain of load_path goals under way: piece by piece, two of them at the controller, each goal with an end
// of its own (states: load_path_states.h).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runs/load_path_states.h"
#include "runs/path_chain.h"
#include "runs/path_progress.h"
#include "runs/path_restore.h"

#include "cobot_command/blocks/goal.h"
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

  [[nodiscard]] bool isJoinedBy(Block block) const override;
  [[nodiscard]] Detail chain() const override;
  [[nodiscard]] bool join(GoalId goal, const Outcome& planned, Instant now) override;
  [[nodiscard]] bool serves(GoalId goal) const override { return chain_.memberOf(goal).has_value(); }
  [[nodiscard]] bool takeOut(GoalId goal, const std::string& why, Instant now) override;
  [[nodiscard]] std::size_t waiting() const override;
  /// A stop of a goal that was not loaded is an error of that goal (1007), and of nobody behind it.
  [[nodiscard]] bool failed() const override { return Run::failed() && !interrupted_; }

 private:
  using Event = LoadPathEvent;
  using State = LoadPathState;
  using Member = PathChain::Member;

  void fire(Event event, Instant now);
  void fail(Failure failure, Instant now);
  /// Nothing is at the controller, or only what was sent before it failed.
  void endWhenNothingIsLeft(Instant now);
  [[nodiscard]] std::optional<Instant> openEndDue() const;

  /// A piece, or what was to be the next one, was stopped or failed.
  void endEarly(const Outcome& outcome, Instant now);
  void begin(Instant now);
  /// So many points are done, by a tag.
  void done(std::size_t points, Instant now);
  void follow(Instant now);
  void checkDeviation(Instant now);
  void tell(Instant now);
  [[nodiscard]] Progress progressOf(const Member& member, const PathPlace& place) const;

  /// All of them, the first one at last.
  void endAll(const std::vector<Outcome>& outcomes, Instant now);
  /// Of the goals from that one on nothing was sent.
  void dropFrom(std::size_t member, const std::string& why, Instant now);
  [[nodiscard]] Outcome complete(const Member& member, Outcome outcome, Instant now) const;

  PathChain chain_;
  PathProgress progress_;
  PathChain::Place place_;
  State state_ = State::Following;
  Phase phase_ = Phase::Sent;
  std::string text_;
  double rate_ = 1.0;
  Instant waits_from_;                ///< for a goal that joins, with nothing at the controller
  std::optional<Instant> front_end_;  ///< of the piece under way, by the clock
  bool open_end_due_ = false;
  PathRestore restore_;  ///< goes out behind a stop
  path::PathControls controls_;
  std::optional<double> speed_;  ///< of the project, as streamed last
  bool interrupted_ = false;
  std::string stopped_why_;  ///< and what became of the robot
  std::optional<Failure> failure_;
  robot::ReasonWait reason_;
  std::optional<Instant> reason_until_;
  std::optional<SixValues> joints_;  ///< that were streamed last [deg]
  std::optional<SixValues> pose_;
};

}  // namespace cobot_command::blocks
