#include "paths/path_turn.h"

#include <utility>

namespace cobot_command::command {
namespace {

/// Whose plan that is which a run asks for by itself.
constexpr blocks::GoalId kNoGoal = 0;

}  // namespace

void PathTurn::serve(blocks::Run& run, Instant now) {
  run_ = &run;
  paths_ = run.paths();
  if (paths_ == nullptr) return;
  desk_.serve(*paths_, now);
  if (auto work = paths_->takeReplan()) {
    planAnew(run.block(), *std::move(work), now);
    desk_.serve(*paths_, now);  // its answer may be there
  }
}

void PathTurn::leave(const blocks::ConnectGoal& controller) {
  planning_.drop(kNoGoal);
  if (paths_ != nullptr) desk_.leave(*paths_, controller);
  if (run_ == nullptr) return;
  if (const auto place = run_->placeOnTheWay()) desk_.bringTo(*place);
  run_ = nullptr;
  paths_ = nullptr;
}

/// Beside the core, as all of it was planned.
void PathTurn::planAnew(blocks::Block block, blocks::PathWork work, Instant now) {
  const auto make = [work = std::move(work)](const PlanDesk::Dropped& /*dropped*/,
                                             Instant /*now*/) -> PlanWork {
    return [work] {
      PlanAnswer answer;
      answer.outcome.detail = work();
      return answer;
    };
  };
  const auto take = [this](const std::optional<PlanAnswer>& answer) {
    if (paths_ == nullptr) return;
    const auto warning = paths_->replanned(answer ? answer->outcome.detail : blocks::Detail());
    if (warning) actions_.emplace_back(LogMessage{Severity::Warning, *warning});
  };
  planning_.drop(kNoGoal);  // of what was to be planned before
  planning_.ask({block, kNoGoal, PlanDesk::Purpose::Send, make, take}, now);
}

}  // namespace cobot_command::command
