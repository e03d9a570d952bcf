// The plans of whole goals: of checks, which they answer; of goals that wait, to refuse at once what cannot
// be made; and of what is planned as a whole when its turn has come.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "arbiter/core_parts.h"
#include "forecast/plan_desk.h"
#include "queue/goal_queue.h"

namespace cobot_command::command {

class GoalPlans {
 public:
  /// Where the goal with that ticket starts: behind all that is on the wire, and waits with an earlier one;
  /// nothing when nobody knows.
  using OriginBehind = std::function<std::optional<Origin>(Ticket ticket, Instant now)>;
  /// All have to live longer. `program`: of the robot in its cell; may be nullptr.
  GoalPlans(const CoreParts& parts, PlanDesk& desk, GoalQueue& queue, OriginBehind origin_behind,
            blocks::ProgramGuidePtr program)
      : parts_(parts),
        desk_(desk),
        queue_(queue),
        origin_behind_(std::move(origin_behind)),
        program_(std::move(program)) {}

  /// Answers the goal that came last with its plan. `chain`: as with planTheNext().
  void check(blocks::GoalId id, const blocks::Goal& goal, const blocks::Detail& chain, Instant now);
  /// Of the last one that waits, when it is one command: refused, or where it will leave the robot.
  void foresee(Instant now);
  /// The first one that waits: what is found is `found` of it. `chain`: that it is to join, if it is.
  void planTheNext(const blocks::Detail& chain, Instant now);

  /// A check that was cancelled; false: there is none.
  bool cancel(blocks::GoalId goal);
  void endAll(const std::string& why);

 private:
  /// It is planned with what stands in our tables, which may not be what the controller has.
  void tellDifferences(const blocks::Goal& goal);
  [[nodiscard]] blocks::PlanningScene sceneOf(const blocks::Goal& goal) const;
  /// Where the goal with that ticket starts is not being planned.
  [[nodiscard]] bool isOriginKnown(Ticket ticket) const;
  [[nodiscard]] Forecast::OriginAt originNow(Ticket ticket, Instant now) const;
  [[nodiscard]] Forecast::OriginAt originThen(Ticket ticket) const;
  void show(blocks::Block block, blocks::GoalId id, blocks::Detail preview);
  void answer(blocks::Block block, blocks::GoalId id, PlanAnswer answer);
  void takeForesight(blocks::GoalId id, const PlannedCommand* planned);
  void endUnplanned(const PlanDesk::Job& check, const std::string& why);

  CoreParts parts_;
  PlanDesk& desk_;
  GoalQueue& queue_;
  OriginBehind origin_behind_;
  blocks::ProgramGuidePtr program_;
};

}  // namespace cobot_command::command
