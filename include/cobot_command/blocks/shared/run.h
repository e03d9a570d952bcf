// A goal under way, from its turn to its one end.
//
// It says which command is to be sent next, and is told how that went and what becomes of the robot; sending
// is the arbiter's. So every command lives on the wire in the same way, whatever block it is of.
//
// Other goals may join it on its way: then it is a chain, and each of them has its own end.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cobot_command/blocks/shared/block.h"
#include "cobot_command/blocks/shared/command.h"
#include "cobot_command/blocks/shared/detail.h"
#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/blocks/shared/finish_after.h"
#include "cobot_command/blocks/shared/outcome.h"
#include "cobot_command/blocks/shared/path_controlled.h"
#include "cobot_command/common/time.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::blocks {

struct GoalProgress {
  GoalId goal = 0;
  Progress progress;
};

struct GoalEnd {
  GoalId goal = 0;
  Outcome outcome;
};

/// What goals are told by the run that serves them, until it is taken.
class RunReports {
 public:
  explicit RunReports(GoalId goal) : goal_(goal) {}

  /// The first of them to end.
  [[nodiscard]] GoalId goal() const { return goal_; }
  void tell(GoalId goal, Progress progress) { progress_.push_back({goal, std::move(progress)}); }
  /// What is to be known of commands that have ended: all goals that end from now on tell it.
  void remark(const Remarks& remarks) { remarks_.add(remarks); }
  [[nodiscard]] const Remarks& remarks() const { return remarks_; }
  /// Of a kind of its block's own.
  void tellEveryone(Detail news) { news_.push_back(std::move(news)); }
  /// That goal has ended, while others go on. Precondition: `first`, the first to end from now on, is one of
  /// these.
  void end(GoalId goal, Outcome outcome, GoalId first) {
    outcome.remarks = remarks_;
    ended_.push_back({goal, std::move(outcome)});
    goal_ = first;
  }
  /// What is new since the last call.
  [[nodiscard]] std::vector<GoalProgress> takeProgress() { return std::exchange(progress_, {}); }
  [[nodiscard]] std::vector<Detail> takeNews() { return std::exchange(news_, {}); }
  [[nodiscard]] std::vector<GoalEnd> takeEnded() { return std::exchange(ended_, {}); }

 private:
  GoalId goal_;
  Remarks remarks_;
  std::vector<GoalProgress> progress_;
  std::vector<Detail> news_;
  std::vector<GoalEnd> ended_;
};

/// The side of a run that other goals join.
class GoalChain {
 public:
  /// Whether a goal of that block, the next one in the queue, is to join it now.
  [[nodiscard]] virtual bool isJoinedBy(Block block) const = 0;
  /// Where a goal begins that joins it, for the plan of that one (PlanningScene::chain).
  [[nodiscard]] virtual Detail end() const = 0;
  /// `planned`: what plan() found of it. False: the chain has gone on since, so that it has to be planned
  /// anew.
  [[nodiscard]] virtual bool join(GoalId goal, const Outcome& planned, Instant now) = 0;
  /// Takes a goal out, and those behind it, for which nothing needs to be stopped. False: cancel it all.
  [[nodiscard]] virtual bool takeOut(GoalId goal, const std::string& why, Instant now) = 0;
  /// How many of its goals nothing was sent of yet.
  [[nodiscard]] virtual std::size_t waiting() const = 0;

 protected:
  ~GoalChain() = default;
};

class Run {
 public:
  Run(Block block, GoalId goal) : block_(block), reports_(goal) {}
  virtual ~Run() = default;
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  [[nodiscard]] Block block() const { return block_; }
  /// Of a chain the one that is the first to end.
  [[nodiscard]] GoalId goal() const { return reports_.goal(); }

  /// The goal is accepted with its first command, or refused with it; else as its turn comes.
  [[nodiscard]] virtual bool isOneCommand() const { return false; }
  /// Its blended moves may go on behind a command of it that fails: they are to be stopped then.
  [[nodiscard]] virtual bool leavesMotions() const { return false; }
  /// It moves nothing: what is planned behind it begins where the robot is.
  [[nodiscard]] virtual bool leavesTheRobot() const { return false; }
  /// So many of its commands may be at the controller at once.
  [[nodiscard]] virtual std::size_t window() const { return 1; }
  /// What has to be sent now; nothing while it waits for what is under way, or when there is nothing to send.
  [[nodiscard]] virtual std::optional<Command> next() const { return std::nullopt; }
  /// Whether the exit_node of the command that is done now counts.
  [[nodiscard]] virtual bool leavesNode() const { return true; }
  // What becomes of the command of that key.
  virtual void commandStarted(CommandKey /*key*/) {}
  virtual void commandProgressed(CommandKey /*key*/, const Progress& /*progress*/, Instant /*now*/) {}
  /// It has come to that one of its marks (Order), and past all before that.
  virtual void commandPassed(CommandKey /*key*/, std::size_t /*mark*/, Instant /*now*/) {}
  virtual void commandEnded(CommandKey /*key*/, const Outcome& /*outcome*/, Instant /*now*/) {}
  /// The command could not be sent.
  virtual void commandRefused(CommandKey /*key*/, const Failure& failure, Instant /*now*/) {
    end(toOutcome(block(), Ending::Aborted, failure));
  }

  /// Why what it has at the controller is to be stopped, by its own finding; nothing: it is not.
  [[nodiscard]] virtual std::optional<std::string> stopsFor() const { return std::nullopt; }

  /// When a command is under way that one is cancelled too; its end is this one's.
  virtual void cancel(const std::string& why, Instant now) = 0;
  /// The same, by a stop or a goal that takes over, and not by its client.
  virtual void interrupt(const std::string& why, Instant now) { cancel(why, now); }
  /// Ends in its own time. Changes nothing behind a cancel.
  virtual void finish(FinishAfter /*after*/, Instant /*now*/) {}
  /// `patience`: how long the status stream may take to tell why; nothing: there is none.
  virtual void linkLost(const std::string& /*reason*/, std::optional<Duration> /*patience*/,
                        Instant /*now*/) {}
  /// It is its turn, a command of it has ended, a status frame came, or the status stream stopped.
  virtual void robotChanged(const robot::RobotWatch& /*robot*/, Instant /*now*/) {}
  virtual void advance(Instant /*now*/) {}
  [[nodiscard]] virtual std::optional<Instant> nextDeadline() const { return std::nullopt; }

  /// How it goes on behind an interruption, in which the robot is stopped, may be moved elsewhere, and is
  /// brought back.
  enum class GoesOn {
    ByCommands,  ///< what is left of the commands that the controller had is sent for it
    ByItself,    ///< it plans what is left anew (PathControlled::restart())
    Never
  };
  [[nodiscard]] virtual GoesOn goesOn() const { return GoesOn::ByCommands; }
  /// Its time stands still until it is put back, and it is told of nothing.
  virtual void setAside(Instant /*now*/) {}
  virtual void putBack(Instant /*now*/) {}

  /// About where the robot is on the way that the last path has driven; nothing: it does not go along that.
  [[nodiscard]] virtual std::optional<Duration> placeOnTheWay() const { return std::nullopt; }

  /// nullptr: it loads no paths.
  [[nodiscard]] virtual PathControlled* paths() { return nullptr; }

  /// nullptr: nobody holds it to run.
  [[nodiscard]] virtual JogControlled* jog() { return nullptr; }

  /// nullptr: no other goal joins it.
  [[nodiscard]] virtual GoalChain* chain() { return nullptr; }
  [[nodiscard]] virtual bool serves(GoalId goal) const { return goal == this->goal(); }

  /// The end of the last of its goals, and so its own; nothing as long as it is Busy.
  [[nodiscard]] const std::optional<Outcome>& outcome() const { return outcome_; }
  /// It ended so that nothing behind it may go on. Precondition: it has an outcome.
  [[nodiscard]] virtual bool failed() const { return outcome_->ending == Ending::Aborted; }
  /// Of its goals; of those the ends that have ended before it.
  [[nodiscard]] RunReports& reports() { return reports_; }

 protected:
  void report(Progress progress) { reports_.tell(goal(), std::move(progress)); }
  void end(Outcome outcome) {
    outcome_ = std::move(outcome);
    outcome_->remarks = reports_.remarks();
  }

 private:
  Block block_;
  RunReports reports_;
  std::optional<Outcome> outcome_;
};

}  // namespace cobot_command::blocks
