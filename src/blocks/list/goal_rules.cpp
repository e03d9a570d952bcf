#include "cobot_command/blocks/list/goal_rules.h"

#include <cassert>
#include <type_traits>
#include <utility>

#include "list/block_kinds.h"
#include "shared/single_command.h"

namespace cobot_command::blocks {
namespace {

template <class Kind>
std::optional<Failure> movedFrameOf(const Kind& goal, const FrameFinder& finder) {
  if constexpr (kHasFrames<Kind>) {
    return findMovedFrame(goal, finder);
  } else {
    return std::nullopt;
  }
}

template <class Kind>
std::optional<Outcome> planOf(const Kind& goal, const PlanningScene& scene) {
  if constexpr (kIsPlanned<Kind>) {
    return plan(goal, scene);
  } else {
    return std::nullopt;
  }
}

template <class... Kinds>
constexpr bool allCanBeCarriedOut(const std::variant<Kinds...>* /*list*/) {
  return ((kIsCommand<Kinds> || kHasRun<Kinds> || kIsPlanned<Kinds> || std::is_same_v<Kinds, ConnectGoal> ||
           std::is_same_v<Kinds, StopGoal> || std::is_same_v<Kinds, ExchangeConfigurationGoal>)&&...);
}
static_assert(allCanBeCarriedOut(static_cast<const Goal*>(nullptr)),
              "each block has one of orderOf(), runOf() and plan(), in these very forms");

}  // namespace

GoalTraits GoalRules::traits() const {
  return std::visit([](const auto& goal) { return traitsOf(goal); }, goal_);
}

std::vector<Failure> GoalRules::violations() const {
  return std::visit([](const auto& goal) { return check(goal); }, goal_);
}

std::optional<Failure> GoalRules::findMovedFrame(const FrameFinder& finder) const {
  return std::visit([&](const auto& goal) { return movedFrameOf(goal, finder); }, goal_);
}

std::optional<tables::Use> GoalRules::uses() const {
  return std::visit(
      [](const auto& goal) -> std::optional<tables::Use> {
        if constexpr (kHasUses<std::decay_t<decltype(goal)>>) {
          return usesOf(goal);
        } else {
          return std::nullopt;
        }
      },
      goal_);
}

std::optional<Command> GoalRules::command() const {
  return std::visit(
      [&](const auto& goal) -> std::optional<Command> {
        if constexpr (kIsCommand<std::decay_t<decltype(goal)>>) {
          return commandOf(goal);
        } else {
          return std::nullopt;
        }
      },
      goal_);
}

bool GoalRules::isPlanned() const {
  return std::visit([](const auto& goal) { return kIsPlanned<std::decay_t<decltype(goal)>>; }, goal_);
}

std::optional<Outcome> GoalRules::plan(const PlanningScene& scene) const {
  return std::visit([&](const auto& goal) { return planOf(goal, scene); }, goal_);
}

Detail GoalRules::preview(const Outcome& planned) const {
  return std::visit(
      [&](const auto& goal) -> Detail {
        if constexpr (kHasPreview<std::decay_t<decltype(goal)>>) {
          return previewOf(goal, planned);
        } else {
          return {};
        }
      },
      goal_);
}

std::unique_ptr<Run> GoalRules::run(GoalId id, const Outcome& planned, Instant now) const {
  return std::visit(
      [&](const auto& goal) -> std::unique_ptr<Run> {
        using Kind = std::decay_t<decltype(goal)>;
        static_assert(!(kIsCommand<Kind> && kHasRun<Kind>), "it is one command, or more than that");
        if constexpr (kHasRun<Kind>) {
          return runOf(goal, id, planned, now);
        } else if constexpr (kIsCommand<Kind>) {
          return std::make_unique<SingleCommand>(id, commandOf(goal));
        } else {
          assert(false && "a goal that never comes to its turn");
          return nullptr;
        }
      },
      goal_);
}

}  // namespace cobot_command::blocks
