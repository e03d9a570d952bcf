// The plans that are asked for: one at a time, each with a budget. What is to be sent now comes before what
// is only foreseen or checked, and takes the place of one that is worked on, which then begins anew; else
// they come in their order.
//
// What is dropped is told to whoever works on it, and its answer, when it comes all the same, is for nobody.
#pragma once

#include <atomic>
#include <cstddef>
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
  /// Called when its turn has come: what it begins with is looked up then.
  using MakeWork = std::function<PlanWork(const Dropped& dropped, Instant now)>;

  enum class Purpose {
    Send,     ///< of what comes next on the wire
    Foresee,  ///< of a goal that waits behind others
    Check     ///< of a goal that is answered by its plan
  };
  struct Job {
    blocks::Block block{};
    blocks::GoalId goal = 0;
    Purpose purpose = Purpose::Check;
    MakeWork make;
    /// Gets the answer; nothing: it took longer than its budget. May ask for another plan.
    std::function<void(std::optional<PlanAnswer> answer)> take;
    /// What it begins with is known; may be empty: it is. Until then those behind it wait, too.
    std::function<bool()> is_ready = {};
  };

  /// With Planning::AtOnce each plan is made, and taken, while it is asked for.
  PlanDesk(Duration budget, std::vector<Action>& actions, Planning planning)
      : budget_(budget), actions_(actions), planning_(planning) {}

  void ask(Job job, Instant now);
  /// Begins the next ones where none is worked on. To be called behind each event.
  void proceed(Instant now);
  /// Left alone when nobody waits for it (any more).
  void answered(PlanJobId id, PlanAnswer answer);
  /// Those whose budget is over.
  void endOverdue(Instant now);
  [[nodiscard]] std::optional<Instant> nextDeadline() const;

  /// That goal is to be sent, or foreseen, with a plan that is still to come.
  [[nodiscard]] bool plans(blocks::GoalId goal) const;
  /// How many goals wait to be answered by their plan.
  [[nodiscard]] std::size_t checks() const;
  /// Whatever is planned to send or foresee that goal.
  void drop(blocks::GoalId goal);
  /// Nothing: that goal is not answered by a plan.
  [[nodiscard]] std::optional<Job> dropCheck(blocks::GoalId goal);
  [[nodiscard]] std::vector<Job> dropChecks();

 private:
  struct Open {
    PlanJobId id = 0;
    Job job;
    std::shared_ptr<std::atomic<bool>> dropped = nullptr;  ///< of the one that is worked on, the first
    std::optional<Instant> deadline = std::nullopt;        ///< the same
  };
  using Lane = std::deque<Open>;

  [[nodiscard]] Lane& laneOf(Purpose purpose) { return purpose == Purpose::Send ? to_send_ : others_; }
  [[nodiscard]] static PlanWork begin(Open& open, Instant now);
  void proceed(Lane& lane, PlanLane name, Instant now);
  static Job remove(Lane& lane, const Lane::iterator& open);
  [[nodiscard]] static bool answered(Lane& lane, PlanJobId id, PlanAnswer& answer);
  static void endOverdue(Lane& lane, Instant now);
  static void drop(Lane& lane, blocks::GoalId goal);

  Duration budget_;
  std::vector<Action>& actions_;
  Planning planning_;
  PlanJobId last_ = 0;
  Lane to_send_;
  Lane others_;
};

}  // namespace cobot_command::command
