// What the waits in the queue have in common: their time, which a held robot gives them back, and their ends
// (states: queue_wait_states.h). What is waited for is the block's.
#pragma once

#include <optional>
#include <string>

#include "waits/queue_wait_states.h"

#include "cobot_command/blocks/shared/run.h"
#include "cobot_command/robot/reason_wait.h"

namespace cobot_command::blocks {

/// How long a wait of the queue may be [s].
inline constexpr double kMaxQueueWait = 86400;

class QueueWait : public Run {
 public:
  /// It is its turn. `time`: how long it waits; nothing: without an end.
  void begin(std::optional<Duration> time, Instant now);

  [[nodiscard]] bool leavesTheRobot() const override { return true; }
  void cancel(const std::string& why, Instant now) override;
  /// There is nothing that moves, so nothing to let come to its end but the wait itself.
  void finish(FinishAfter after, Instant now) override;
  void linkLost(const std::string& reason, std::optional<Duration> patience, Instant now) override;
  void robotChanged(const robot::RobotWatch& robot, Instant now) override;
  void setAside(Instant now) override { followHold(true, now); }
  void putBack(Instant now) override { followHold(false, now); }
  void advance(Instant now) override;
  [[nodiscard]] std::optional<Instant> nextDeadline() const override;

 protected:
  QueueWait(Block block, GoalId goal) : Run(block, goal) {}

  [[nodiscard]] Instant beganAt() const { return began_at_; }
  [[nodiscard]] bool isHeld() const { return held_since_.has_value(); }
  /// Of its time, without that in which the robot is held; nothing: it waits without an end.
  [[nodiscard]] std::optional<Duration> remaining(Instant now) const;
  [[nodiscard]] Instant toldAt() const { return told_at_; }

  /// For people, behind "while it waited for".
  [[nodiscard]] virtual std::string name() const = 0;
  /// What it tells while it waits, its phase apart.
  [[nodiscard]] virtual Progress progress(Instant now) const = 0;
  /// A robot that is neither in error nor in an emergency stop has changed; followHold() is the block's to
  /// call.
  virtual void look(const robot::RobotWatch& robot, Instant now) = 0;
  virtual void timeIsOver(Instant now) = 0;

  /// A paused robot gives the wait its time back.
  void followHold(bool held, Instant now);
  void tell(Instant now);
  void meet(Instant now) { fire(QueueWaitEvent::Met, now); }
  void fail(Failure failure, Instant now);

 private:
  using Event = QueueWaitEvent;
  using State = QueueWaitState;

  void fire(Event event, Instant now);
  void endWith(Outcome outcome, Instant now);

  State state_ = State::Waiting;
  Instant began_at_{};
  Instant told_at_{};
  std::optional<Instant> deadline_;  ///< of the wait, or of the reason of a loss
  std::optional<Instant> held_since_;
  robot::ReasonWait reason_;
  Failure failure_;
  std::string words_;  ///< of an end that was asked for
};

}  // namespace cobot_command::blocks
