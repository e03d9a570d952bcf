// A jog under way: held to run, or one increment (states: jog_run_states.h). What it has the controller do is
// a drive (jog_drives.h); a controller that refuses velocities gets moves.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "jog/jog_drives.h"
#include "jog/jog_plan.h"
#include "jog/jog_run_states.h"

#include "cobot_command/blocks/jog.h"
#include "cobot_command/robot/reason_wait.h"

namespace cobot_command::blocks {

class JogRun final : public Run, private JogControlled {
 public:
  /// Its beginning counts as a keep-alive.
  JogRun(GoalId id, std::shared_ptr<const JogPlan> plan, Instant now);

  [[nodiscard]] std::size_t window() const override;
  [[nodiscard]] std::optional<Command> next() const override;
  void commandStarted(CommandKey key) override;
  void commandProgressed(CommandKey key, const Progress& progress, Instant now) override;
  void commandEnded(CommandKey key, const Outcome& outcome, Instant now) override;
  void commandRefused(CommandKey key, const Failure& failure, Instant now) override;
  [[nodiscard]] std::optional<std::string> stopsFor() const override;

  [[nodiscard]] GoesOn goesOn() const override { return GoesOn::Never; }
  void cancel(const std::string& why, Instant now) override;
  void finish(FinishAfter after, Instant now) override;
  void linkLost(const std::string& reason, std::optional<Duration> patience, Instant now) override;
  void robotChanged(const robot::RobotWatch& robot, Instant now) override;
  void advance(Instant now) override;
  [[nodiscard]] std::optional<Instant> nextDeadline() const override;
  [[nodiscard]] JogControlled* jog() override { return this; }

 private:
  using Event = JogEvent;
  using State = JogState;

  void keepAlive(Instant now) override;
  [[nodiscard]] bool isVelocityRefused() const override { return velocity_refused_; }

  void fire(Event event, Instant now);
  void look(Instant now);
  void fail(Failure failure, Instant now);
  /// It is none that was asked for: the robot is stopped.
  void halt(const std::string& why, Instant now);
  void forgetIncrement();
  void endBy(JogEnd end, int joint, std::string why);
  /// What the plan has found there.
  void endAtTheObstacle();
  [[nodiscard]] bool fallsBack(const Outcome& outcome);
  [[nodiscard]] const char* withoutLink() const;
  void endOfMode(Instant now);
  void endWhenNothingIsLeft(Instant now);
  void watch(const robot::RobotWatch& robot, Instant now);
  void lookWhileItWaits(const robot::RobotWatch& robot, Instant now);
  [[nodiscard]] JogWish wish() const;
  [[nodiscard]] bool isComingToRest() const;
  void tell(Instant now);
  void complete(Outcome outcome);

  std::shared_ptr<const JogPlan> plan_;
  std::unique_ptr<JogDrive> drive_;
  State state_ = State::Driving;
  Instant kept_;             ///< the last keep-alive
  std::size_t started_ = 0;  ///< commands
  std::size_t open_ = 0;     ///< that are at the controller
  double driven_ = 0;
  std::optional<bool> moving_;
  bool rest_taken_ = false;  ///< by the controller: a frame that shows the arm standing means something
  std::optional<Instant> rests_until_;  ///< else it is stopped
  bool halted_ = false;
  bool velocity_refused_ = false;
  JogReport report_;
  Progress progress_;  ///< of its commands
  std::optional<Instant> told_at_;
  std::string stopped_why_;
  Failure failure_;
  Outcome found_;
  robot::ReasonWait reason_;
  std::optional<Instant> reason_until_;
};

}  // namespace cobot_command::blocks
