// The plans of goals that may take long: of checks, and of what is planned as a whole when its turn has come.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "arbiter/core_parts.h"
#include "arbiter/goal_queue.h"
#include "forecast/plan_desk.h"

#include "cobot_command/command/planning_job.h"

namespace cobot_command::command {

class GoalPlans {
 public:
  /// All have to live longer.
  GoalPlans(const CoreParts& parts, Planning planning, PlanDesk& desk, GoalQueue& queue)
      : parts_(parts), planning_(planning), desk_(desk), queue_(queue) {}

  /// Its answer ends a check, and is `found` of a goal that waits; with Planning::AtOnce it is there already.
  PlanJobId ask(blocks::GoalId id, const blocks::Goal& goal, const std::optional<Origin>& origin,
                PlanDesk::Haste haste);
  void answered(PlanJobId id, PlanAnswer answer);
  void endOverdue(Instant now);
  /// A check that was cancelled; false: there is none.
  bool cancel(blocks::GoalId goal);
  /// Precondition: nothing waits for its turn any more.
  void endAll(const std::string& why);

 private:
  void take(const PlanDesk::Job& job, PlanAnswer answer);
  void endUnplanned(const PlanDesk::Job& job, const std::string& why);

  CoreParts parts_;
  Planning planning_;
  PlanDesk& desk_;
  GoalQueue& queue_;
};

}  // namespace cobot_command::command
