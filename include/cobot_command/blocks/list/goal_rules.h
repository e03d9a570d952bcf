// The rules of a goal of any block. The goal's own block answers each question.
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

/// Replaces negative values by the defaults: the speed, the time to top speed and, if enabled, the blending
/// of each move in the goal. Call it once, before all rules.
[[nodiscard]] Goal withDefaults(Goal goal, const DefaultDynamics& defaults);
/// The first default that is out of its range: its value and the allowed range; nullopt: all defaults are
/// valid.
[[nodiscard]] std::optional<std::string> faultIn(const DefaultDynamics& defaults);

/// Refers to the goal: valid only as long as the goal exists.
class GoalRules {
 public:
  explicit GoalRules(const Goal& goal) : goal_(goal) {}

  [[nodiscard]] GoalTraits traits() const;
  /// All violations of the goal's own parameters, in table order; empty: the goal may be sent. Numbers are
  /// not checked if a pose or a name replaces them.
  [[nodiscard]] std::vector<Failure> violations() const;
  /// Why a goal that has waited must not start; nullopt: its targets have not moved, it has no targets in a
  /// frame, or `finder` is empty.
  [[nodiscard]] std::optional<Failure> findMovedFrame(const FrameFinder& finder) const;
  /// The table entries that must not change from its plan to its end; nullopt: it needs none.
  [[nodiscard]] std::optional<tables::Use> uses() const;
  /// The command of a goal that is exactly one command; nullopt: it has another number of commands.
  /// Precondition of all functions below: no violations.
  [[nodiscard]] std::optional<Command> command() const;
  /// True: plan() plans the goal as a whole.
  [[nodiscard]] bool isPlanned() const;
  /// Plans the goal as a whole. Rejected: the goal cannot be carried out. nullopt: the goal is one command,
  /// which the core plans.
  [[nodiscard]] std::optional<Outcome> plan(const PlanningScene& scene) const;
  /// The part of the result of plan() that is shown to people, of the block's own type; none: nothing is
  /// shown.
  [[nodiscard]] Detail preview(const Outcome& planned) const;
  /// `planned`: the result of plan(), if it was called. Precondition: the goal is queued (Way::Queue).
  [[nodiscard]] std::unique_ptr<Run> run(GoalId id, const Outcome& planned, Instant now) const;

 private:
  const Goal& goal_;
};

}  // namespace cobot_command::blocks
