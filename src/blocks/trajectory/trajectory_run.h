// A trajectory under way: one PVT, watched, and judged at its end (states: trajectory_run_states.h).
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "trajectory/trajectory_follower.h"
#include "trajectory/trajectory_plan.h"
#include "trajectory/trajectory_run_states.h"

#include "cobot_command/blocks/follow_joint_trajectory.h"
#include "cobot_command/robot/reason_wait.h"

namespace cobot_command::blocks {

class TrajectoryRun final : public Run {
 public:
  /// Precondition: it was planned from where the robot stands.
  TrajectoryRun(const FollowJointTrajectoryGoal& goal, GoalId id, const Outcome& planned, Instant now);

  [[nodiscard]] std::optional<Command> next() const override;
  void commandStarted(CommandKey key) override;
  void commandProgressed(CommandKey key, const Progress& progress, Instant now) override;
  void commandEnded(CommandKey key, const Outcome& outcome, Instant now) override;
  void commandRefused(CommandKey key, const Failure& failure, Instant now) override;
  [[nodiscard]] std::optional<std::string> stopsFor() const override;

  [[nodiscard]] GoesOn goesOn() const override { return GoesOn::Never; }
  void cancel(const std::string& why, Instant now) override;
  void linkLost(const std::string& reason, std::optional<Duration> patience, Instant now) override;
  void robotChanged(const robot::RobotWatch& robot, Instant now) override;
  void advance(Instant now) override;
  [[nodiscard]] std::optional<Instant> nextDeadline() const override;

 private:
  using Event = TrajectoryEvent;
  using State = TrajectoryState;

  void fire(Event event, Instant now);
  void fail(Failure failure, Event event, Instant now);
  void follow(const robot::RobotWatch& robot, Instant now);
  void lookWhileItWaits(const robot::RobotWatch& robot, Instant now);
  /// Its command is done, or is said not to have come to its end.
  void judgeEnd(Instant now);
  void tell(Instant now);
  void complete(Outcome outcome);

  std::shared_ptr<const TrajectoryPlan> plan_;
  GoalTraits traits_;  ///< of its command
  State state_ = State::Following;
  std::optional<Instant> starts_at_;  ///< nothing: it may go out
  bool sent_ = false;
  bool ended_ = false;  ///< its command has
  std::optional<TrajectoryFollower> follower_;
  Progress progress_;  ///< of its command
  std::optional<Instant> told_at_;
  std::optional<arm::JointVector> joints_;  ///< that were streamed last
  std::optional<bool> moving_;
  std::string stopped_why_;
  Failure failure_;
  Outcome found_;  ///< of its command, or of its plan
  robot::ReasonWait reason_;
  std::optional<Instant> reason_until_;
};

}  // namespace cobot_command::blocks
