// The plans that are asked for: one at a time, each with a budget. What is to move the robot comes before
// checks, and takes the place of one that is worked on, which then begins anew; else they come in their
// order.
//
// What is dropped is told to whoever works on it, and its answer, when it comes all the same, is for nobody.
#pragma once

#include <atomic>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "cobot_command/blocks/shared/block.h"
#include "cobot_command/blocks/shared/goal_values.h"
#include "cobot_command/command/actions.h"
#include "cobot_command/command/planning_job.h"
#include "cobot_command/common/time.h"

namespace cobot_command::command {

class PlanDesk {
 public:
  /// True as soon as nobody waits for the plan any more; asked from any thread.
  using Dropped = std::shared_ptr<const std::atomic<bool>>;
  using MakeWork = std::function<PlanWork(const Dropped& dropped)>;

  struct Job {
    PlanJobId id = 0;
    blocks::Block block{};
    blocks::GoalId goal = 0;
  };

  PlanDesk(Duration budget, std::vector<Action>& actions) : budget_(budget), actions_(actions) {}

  [[nodiscard]] std::size_t size() const { return open_.size(); }
  enum class Haste { Check, Turn };
  PlanJobId ask(blocks::Block block, blocks::GoalId goal, Haste haste, MakeWork make);
  /// For who does it at once, instead of proceed(). Precondition: it has not begun.
  [[nodiscard]] PlanWork takeWork(PlanJobId id);
  /// Begins the next one when none is worked on. To be called behind each event.
  void proceed(Instant now);
  /// Whose answer that is; nothing: nobody waits for it (any more).
  [[nodiscard]] std::optional<Job> answered(PlanJobId id);
  /// The plan of a goal that has ended otherwise, if there is one.
  [[nodiscard]] std::optional<Job> drop(blocks::GoalId goal);
  [[nodiscard]] std::vector<Job> dropAll();
  /// Those whose budget is over are dropped.
  [[nodiscard]] std::vector<Job> takeOverdue(Instant now);
  [[nodiscard]] std::optional<Instant> nextDeadline() const;

 private:
  struct Open {
    Job job;
    Haste haste = Haste::Check;
    MakeWork make;
    std::shared_ptr<std::atomic<bool>> dropped;  ///< of the one that is worked on, the first
    std::optional<Instant> deadline;             ///< the same
  };
  [[nodiscard]] static PlanWork begin(Open& open);
  static void drop(Open& open);
  [[nodiscard]] std::deque<Open>::iterator find(PlanJobId id);
  Job remove(const std::deque<Open>::iterator& open);

  Duration budget_;
  std::vector<Action>& actions_;
  PlanJobId last_ = 0;
  std::deque<Open> open_;
};

}  // namespace cobot_command::command
