// A running goal, from its turn to its one end.
//
// A run returns the command to send next, and is notified of the result and of the state of the robot. The
// arbiter does the sending. So every command is sent in the same way, whatever its block.
//
// Other goals may join a run: it is then a chain, and each of its goals has its own end.
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

/// Reports of a run to the goals that it serves, until they are taken.
class RunReports {
 public:
  explicit RunReports(GoalId goal) : goal_(goal) {}

  /// The goal that ends first.
  [[nodiscard]] GoalId goal() const { return goal_; }
  void tell(GoalId goal, Progress progress) { progress_.push_back({goal, std::move(progress)}); }
  /// Remarks on commands that have ended: all goals that end from now on report them.
  void remark(const Remarks& remarks) { remarks_.add(remarks); }
  [[nodiscard]] const Remarks& remarks() const { return remarks_; }
  /// Published for all clients; the type belongs to the block.
  void tellEveryone(Detail news) { news_.push_back(std::move(news)); }
  /// That goal has ended, while others continue. Precondition: `first`, the goal that ends first from now on,
  /// is one of the others.
  void end(GoalId goal, Outcome outcome, GoalId first) {
    outcome.remarks = remarks_;
    ended_.push_back({goal, std::move(outcome)});
    goal_ = first;
  }
  /// New reports since the last call.
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

/// The interface of a run that other goals join.
class GoalChain {
 public:
  /// True: a goal of that block, the next one in the queue, must join the run now.
  [[nodiscard]] virtual bool isJoinedBy(Block block) const = 0;
  /// Where a joining goal begins, for its plan (PlanningScene::chain).
  [[nodiscard]] virtual Detail end() const = 0;
  /// `planned`: the result of plan(). False: the chain has changed since, and the goal must be planned again.
  [[nodiscard]] virtual bool join(GoalId goal, const Outcome& planned, Instant now) = 0;
  /// Removes a goal and the goals after it, if nothing must be stopped for that. False: cancel the whole
  /// chain.
  [[nodiscard]] virtual bool takeOut(GoalId goal, const std::string& why, Instant now) = 0;
  /// Number of its goals of which nothing was sent yet.
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
  /// For a chain: the goal that ends first.
  [[nodiscard]] GoalId goal() const { return reports_.goal(); }

  /// True: the goal is accepted or refused together with its first command; false: it is accepted at its
  /// turn.
  [[nodiscard]] virtual bool isOneCommand() const { return false; }
  /// True: its blended moves may continue after one of its commands fails; they must then be stopped.
  [[nodiscard]] virtual bool leavesMotions() const { return false; }
  /// True: it moves nothing; what is planned after it begins at the position of the robot.
  [[nodiscard]] virtual bool leavesTheRobot() const { return false; }
  /// Number of its commands that may be at the controller at once.
  [[nodiscard]] virtual std::size_t window() const { return 1; }
  /// The command to send now; nullopt: it waits for running commands, or has nothing to send.
  [[nodiscard]] virtual std::optional<Command> next() const { return std::nullopt; }
  /// Whether the exit_node of the command that has just ended counts.
  [[nodiscard]] virtual bool leavesNode() const { return true; }
  // Events of the command with that key.
  virtual void commandStarted(CommandKey /*key*/) {}
  virtual void commandProgressed(CommandKey /*key*/, const Progress& /*progress*/, Instant /*now*/) {}
  /// It has reached this mark (Order), and has passed all before it.
  virtual void commandPassed(CommandKey /*key*/, std::size_t /*mark*/, Instant /*now*/) {}
  virtual void commandEnded(CommandKey /*key*/, const Outcome& /*outcome*/, Instant /*now*/) {}
  /// The command could not be sent.
  virtual void commandRefused(CommandKey /*key*/, const Failure& failure, Instant /*now*/) {
    end(toOutcome(block(), Ending::Aborted, failure));
  }

  /// Why its commands at the controller must be stopped, as found by the run itself; nullopt: they need not.
  [[nodiscard]] virtual std::optional<std::string> stopsFor() const { return std::nullopt; }

  /// A running command is cancelled too; its end is the end of the run.
  virtual void cancel(const std::string& why, Instant now) = 0;
  /// The same for a stop, or for a goal that takes over, instead of a cancel by the client.
  virtual void interrupt(const std::string& why, Instant now) { cancel(why, now); }
  /// Ends without a stop. No effect after a cancel.
  virtual void finish(FinishAfter /*after*/, Instant /*now*/) {}
  /// `patience`: time for the status stream to show the reason; nullopt: there is no status stream.
  virtual void linkLost(const std::string& /*reason*/, std::optional<Duration> /*patience*/,
                        Instant /*now*/) {}
  /// Called at its turn, when a command of it has ended, when a status frame arrives, and when the status
  /// stream stops.
  virtual void robotChanged(const robot::RobotWatch& /*robot*/, Instant /*now*/) {}
  virtual void advance(Instant /*now*/) {}
  [[nodiscard]] virtual std::optional<Instant> nextDeadline() const { return std::nullopt; }

  /// How the run continues after an interruption. The robot is stopped, may be moved elsewhere, and is
  /// brought back.
  enum class GoesOn {
    ByCommands,  ///< the remaining commands of the controller are sent again for it
    ByItself,    ///< it plans the rest again (PathControlled::restart())
    Never
  };
  [[nodiscard]] virtual GoesOn goesOn() const { return GoesOn::ByCommands; }
  /// Suspends the run: its time stops until putBack(), and it receives no events.
  virtual void setAside(Instant /*now*/) {}
  virtual void putBack(Instant /*now*/) {}

  /// Approximate place of the robot on the path that was last driven; nullopt: the run does not follow that
  /// path.
  [[nodiscard]] virtual std::optional<Duration> placeOnTheWay() const { return std::nullopt; }

  /// nullptr: it loads no paths.
  [[nodiscard]] virtual PathControlled* paths() { return nullptr; }

  /// nullptr: it is no hold to run.
  [[nodiscard]] virtual JogControlled* jog() { return nullptr; }

  /// nullptr: no other goal joins it.
  [[nodiscard]] virtual GoalChain* chain() { return nullptr; }
  [[nodiscard]] virtual bool serves(GoalId goal) const { return goal == this->goal(); }

  /// The end of the last of its goals, and so of the run; nullopt: it is Busy.
  [[nodiscard]] const std::optional<Outcome>& outcome() const { return outcome_; }
  /// True: it ended in a way that ends the queued commands too. Precondition: it has an outcome.
  [[nodiscard]] virtual bool failed() const { return outcome_->ending == Ending::Aborted; }
  /// Of all its goals; and the ends of those goals that have ended before the run.
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
