// The rules of a goal, whatever block it is of: each question is answered by that block.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/command.h"
#include "cobot_command/blocks/shared/run.h"
#include "cobot_command/tables/table_store.h"

namespace cobot_command::blocks {

/// With the defaults in place of what is negative: the speed, the time to top speed and the blending (where
/// it is enabled) of each move in it. To be called before all rules, once.
[[nodiscard]] Goal withDefaults(Goal goal, const DefaultDynamics& defaults);
/// What is wrong with one of them, that is there: what was found, and what is allowed; nothing: they may be.
[[nodiscard]] std::optional<std::string> faultIn(const DefaultDynamics& defaults);

/// For as long as the goal lives.
class GoalRules {
 public:
  explicit GoalRules(const Goal& goal) : goal_(goal) {}

  [[nodiscard]] GoalTraits traits() const;
  /// All violations of the goal's own parameters, in table order; empty when it may be sent. Numbers are not
  /// looked at where a pose or a name stands in place of them.
  [[nodiscard]] std::vector<Failure> violations() const;
  /// Why a goal that has waited must not start; nothing when its targets are where they were, when it has
  /// none in a frame, or nobody can be asked.
  [[nodiscard]] std::optional<Failure> findMovedFrame(const FrameFinder& finder) const;
  /// The entries of the tables that must stay as they are from its plan to its end; nothing: it needs none.
  [[nodiscard]] std::optional<tables::Use> uses() const;
  /// The one command that it is; nothing when it is another number of them. Precondition of all that follow:
  /// no violations.
  [[nodiscard]] std::optional<Command> command() const;
  /// It is planned as a whole, by plan().
  [[nodiscard]] bool isPlanned() const;
  /// Plans it as a whole: Rejected when it cannot be made; nothing when it is one command, which the core
  /// plans.
  [[nodiscard]] std::optional<Outcome> plan(const PlanningScene& scene) const;
  /// What people are to see of what plan() found, of a kind of the block's own; none: nothing.
  [[nodiscard]] Detail preview(const Outcome& planned) const;
  /// `planned`: what plan() found, if it did. Precondition: it is one that comes when it is its turn
  /// (Way::Queue).
  [[nodiscard]] std::unique_ptr<Run> run(GoalId id, const Outcome& planned, Instant now) const;

 private:
  const Goal& goal_;
};

}  // namespace cobot_command::blocks
