// A goal under way, from its turn to its one end.
//
// It says which command is to be sent next, and is told how that went and what becomes of the robot; sending
// is the arbiter's. So every command lives on the wire in the same way, whatever block it is of.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cobot_command/blocks/shared/block.h"
#include "cobot_command/blocks/shared/command.h"
#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/blocks/shared/finish_after.h"
#include "cobot_command/blocks/shared/outcome.h"
#include "cobot_command/common/time.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::blocks {

class Run {
 public:
  Run(Block block, GoalId goal) : block_(block), goal_(goal) {}
  virtual ~Run() = default;
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  [[nodiscard]] Block block() const { return block_; }
  [[nodiscard]] GoalId goal() const { return goal_; }

  /// The goal is accepted with its first command, or refused with it; else as its turn comes.
  [[nodiscard]] virtual bool isOneCommand() const { return false; }
  /// Its blended moves may go on behind a command of it that fails: they are to be stopped then.
  [[nodiscard]] virtual bool leavesMotions() const { return false; }
  /// It moves nothing: what is planned behind it begins where the robot is.
  [[nodiscard]] virtual bool leavesTheRobot() const { return false; }
  /// What has to be sent now; nothing while a command is under way, or when there is nothing to send.
  [[nodiscard]] virtual std::optional<Command> next() const { return std::nullopt; }
  /// Whether the exit_node of the command that is done now counts.
  [[nodiscard]] virtual bool leavesNode() const { return true; }
  // What becomes of the command of that key.
  virtual void commandStarted(CommandKey /*key*/) {}
  virtual void commandProgressed(CommandKey /*key*/, const Progress& /*progress*/) {}
  virtual void commandEnded(CommandKey /*key*/, const Outcome& /*outcome*/, Instant /*now*/) {}
  /// The command could not be sent.
  virtual void commandRefused(CommandKey /*key*/, const Failure& failure, Instant /*now*/) {
    end(toOutcome(block(), Ending::Aborted, failure));
  }

  /// When a command is under way that one is cancelled too; its end is this one's.
  virtual void cancel(const std::string& why, Instant now) = 0;
  /// Ends in its own time. Changes nothing behind a cancel.
  virtual void finish(FinishAfter /*after*/, Instant /*now*/) {}
  /// `patience`: how long the status stream may take to tell why; nothing: there is none.
  virtual void linkLost(const std::string& /*reason*/, std::optional<Duration> /*patience*/,
                        Instant /*now*/) {}
  /// It is its turn, a command of it has ended, a status frame came, or the status stream stopped.
  virtual void robotChanged(const robot::RobotWatch& /*robot*/, Instant /*now*/) {}
  virtual void advance(Instant /*now*/) {}
  [[nodiscard]] virtual std::optional<Instant> nextDeadline() const { return std::nullopt; }

  /// Its one end; nothing as long as it is Busy.
  [[nodiscard]] const std::optional<Outcome>& outcome() const { return outcome_; }
  /// What is new since the last call.
  [[nodiscard]] std::vector<Progress> takeProgress() { return std::exchange(progress_, {}); }

 protected:
  void report(Progress progress) { progress_.push_back(std::move(progress)); }
  void end(Outcome outcome) { outcome_ = std::move(outcome); }

 private:
  Block block_;
  GoalId goal_;
  std::vector<Progress> progress_;
  std::optional<Outcome> outcome_;
};

}  // namespace cobot_command::blocks
