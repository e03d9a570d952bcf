// Plans that may take long: asked for by checks, and by what is planned as a whole when its turn has come.

#include <cassert>
#include <utility>

#include "core_impl.h"

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::command {
PlanJobId CommandCore::Impl::askForPlan(blocks::GoalId id, const blocks::Goal& goal,
                                        const std::optional<Origin>& origin, PlanDesk::Haste haste) {
  const PlanJobId job = plans_.ask(blockOf(goal), id, haste, forecast_.workFor(goal, origin));
  if (planning_ == Planning::AtOnce) {
    PlanAnswer answer = plans_.takeWork(job)();
    takePlan(*plans_.answered(job), std::move(answer));
  }
  return job;
}

/// Of one that waits for its turn, or of a check, whose end it is.
void CommandCore::Impl::takePlan(const PlanDesk::Job& job, PlanAnswer answer) {
  for (Waiting& waiting : waiting_) {
    if (waiting.id != job.goal) continue;
    waiting.found = std::move(answer.outcome);
    return;
  }
  if (answer.outcome.ending == blocks::Ending::Rejected) {
    board_.reject(job.block, job.goal, std::move(answer.outcome));
    return;
  }
  if (!answer.tool_path.empty()) actions_.emplace_back(PathPlanned{job.goal, std::move(answer.tool_path)});
  board_.answer(job.block, job.goal, std::move(answer.outcome));
}

void CommandCore::Impl::planned(PlanJobId id, PlanAnswer answer, Instant now) {
  if (const auto job = plans_.answered(id)) takePlan(*job, std::move(answer));
  settle(now);
}

void CommandCore::Impl::endOverduePlans(Instant now) {
  for (const PlanDesk::Job& job : plans_.takeOverdue(now)) {
    takePlan(job, {toRejection(job.block, {{blocks::own_error::kPlanningBudget, "", ""}}), {}});
  }
}

void CommandCore::Impl::endChecks(const std::string& why) {
  assert(waiting_.empty());
  for (const PlanDesk::Job& job : plans_.dropAll()) endUnplanned(job, why);
}

void CommandCore::Impl::endUnplanned(const PlanDesk::Job& job, const std::string& why) {
  board_.reject(job.block, job.goal, blocks::commandAborted(why));
}

}  // namespace cobot_command::command
