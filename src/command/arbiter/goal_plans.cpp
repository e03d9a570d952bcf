#include "arbiter/goal_plans.h"

#include <cassert>
#include <utility>

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::command {

PlanJobId GoalPlans::ask(blocks::GoalId id, const blocks::Goal& goal, const std::optional<Origin>& origin,
                         PlanDesk::Haste haste) {
  const PlanJobId job = desk_.ask(blockOf(goal), id, haste, parts_.forecast.workFor(goal, origin));
  if (planning_ == Planning::AtOnce) {
    PlanAnswer answer = desk_.takeWork(job)();
    take(*desk_.answered(job), std::move(answer));
  }
  return job;
}

void GoalPlans::answered(PlanJobId id, PlanAnswer answer) {
  if (const auto job = desk_.answered(id)) take(*job, std::move(answer));
}

/// Of one that waits for its turn, or of a check, whose end it is.
void GoalPlans::take(const PlanDesk::Job& job, PlanAnswer answer) {
  if (Waiting* const waiting = queue_.find(job.goal)) {
    waiting->found = std::move(answer.outcome);
    return;
  }
  if (answer.outcome.ending == blocks::Ending::Rejected) {
    parts_.board.reject(job.block, job.goal, std::move(answer.outcome));
    return;
  }
  if (!answer.tool_path.empty()) {
    parts_.actions.emplace_back(PathPlanned{job.goal, std::move(answer.tool_path)});
  }
  parts_.board.answer(job.block, job.goal, std::move(answer.outcome));
}

void GoalPlans::endOverdue(Instant now) {
  for (const PlanDesk::Job& job : desk_.takeOverdue(now)) {
    take(job, {toRejection(job.block, {{blocks::own_error::kPlanningBudget, "", ""}}), {}});
  }
}

bool GoalPlans::cancel(blocks::GoalId goal) {
  const auto job = desk_.drop(goal);
  if (job) endUnplanned(*job, "cancelled while it was planned");
  return job.has_value();
}

void GoalPlans::endAll(const std::string& why) {
  assert(queue_.empty());
  for (const PlanDesk::Job& job : desk_.dropAll()) endUnplanned(job, why);
}

void GoalPlans::endUnplanned(const PlanDesk::Job& job, const std::string& why) {
  parts_.board.reject(job.block, job.goal, blocks::commandAborted(why));
}

}  // namespace cobot_command::command
