// Plans that may take long: asked for by checks, and by what is planned as a whole when its turn has come.

#include <cassert>
#include <utility>

#include "core_impl.h"

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/joint_path.h"

namespace cobot_command::command {
namespace {

using Planned = Result<std::optional<Plan>, blocks::Failure>;

/// What one command, planned, is answered with.
blocks::Outcome outcomeOf(blocks::Block block, const Planned& planned, bool has_model) {
  if (!planned) return toRejection(block, {planned.error()});
  if (!*planned) {
    const int id = has_model ? blocks::own_error::kStartUnknown : blocks::own_error::kNoModel;
    return toRejection(block, {{id, "", ""}});
  }
  blocks::Outcome outcome;
  outcome.planned = (*planned)->duration;
  outcome.joint_path = blocks::jointPath((*planned)->motions);
  return outcome;
}

}  // namespace

PlanJobId CommandCore::Impl::askForPlan(blocks::GoalId id, const blocks::Goal& goal,
                                        const std::optional<Origin>& origin, PlanDesk::Haste haste) {
  const PlanJobId job = plans_.ask(blockOf(goal), id, haste, planOf(goal, origin));
  if (planning_ == Planning::AtOnce) {
    PlanAnswer answer = plans_.takeWork(job)();
    takePlan(*plans_.answered(job), std::move(answer));
  }
  return job;
}

/// With copies of all that it needs, as it may be done on another thread.
PlanDesk::MakeWork CommandCore::Impl::planOf(const blocks::Goal& goal,
                                             const std::optional<Origin>& origin) const {
  const auto base = origin ? origin->start.base : frames_.frames().base;
  return [=, arm = arm_](const PlanDesk::Dropped& dropped) -> PlanWork {
    return [=]() -> PlanAnswer {
      const blocks::GoalRules rules(goal);
      blocks::PlanningScene scene;
      scene.arm = arm.get();
      if (origin) scene.start = origin->start;
      scene.give_up = [dropped] { return dropped->load(); };
      if (auto whole = rules.plan(scene)) return {std::move(*whole), {}};
      const blocks::Command command = *rules.command();
      const Planned plan = planOfCommand(command, arm.get(), base, origin);
      PlanAnswer answer{outcomeOf(command.block, plan, arm != nullptr), {}};
      if (plan && *plan) answer.tool_path = toolPathOf(**plan, *arm);
      return answer;
    };
  };
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
