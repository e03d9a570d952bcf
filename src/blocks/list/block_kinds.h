// What a kind of goal can do, by the functions that its block has, and what follows of them.
#pragma once

#include <optional>
#include <type_traits>
#include <utility>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/command.h"

namespace cobot_command::blocks {

/// It is one command.
template <class Kind, class = void>
inline constexpr bool kIsCommand = false;
template <class Kind>
inline constexpr bool kIsCommand<
    Kind, std::void_t<decltype(orderOf(std::declval<const Kind&>(), std::declval<const arm::Pose&>()))>> =
    true;

/// It is planned as a whole.
template <class Kind, class = void>
inline constexpr bool kIsPlanned = false;
template <class Kind>
inline constexpr bool kIsPlanned<
    Kind, std::void_t<decltype(plan(std::declval<const Kind&>(), std::declval<const PlanningScene&>()))>> =
    true;

/// It is carried out in its own way.
template <class Kind, class = void>
inline constexpr bool kHasRun = false;
template <class Kind>
inline constexpr bool kHasRun<Kind, std::void_t<decltype(runOf(std::declval<const Kind&>(), GoalId(),
                                                               std::declval<const Outcome&>(), Instant()))>> =
    true;

/// Its plan is shown to people.
template <class Kind, class = void>
inline constexpr bool kHasPreview = false;
template <class Kind>
inline constexpr bool kHasPreview<
    Kind, std::void_t<decltype(previewOf(std::declval<const Kind&>(), std::declval<const Outcome&>()))>> =
    true;

/// It uses entries of the tables.
template <class Kind, class = void>
inline constexpr bool kHasUses = false;
template <class Kind>
inline constexpr bool kHasUses<Kind, std::void_t<decltype(usesOf(std::declval<const Kind&>()))>> = true;

/// It may have targets in tf frames.
template <class Kind, class = void>
inline constexpr bool kHasFrames = false;
template <class Kind>
inline constexpr bool kHasFrames<
    Kind,
    std::void_t<decltype(findMovedFrame(std::declval<const Kind&>(), std::declval<const FrameFinder&>()))>> =
    true;

/// The command that a goal is.
template <class Kind>
[[nodiscard]] Command commandOf(const Kind& goal) {
  Command command;
  command.block = kBlock<Kind>;
  command.traits = traitsOf(goal);
  command.order = [goal](const arm::Pose& base) { return orderOf(goal, base); };
  if constexpr (kHasFrames<Kind>) {
    command.find_moved_frame = [goal](const FrameFinder& finder) { return findMovedFrame(goal, finder); };
  }
  return command;
}

}  // namespace cobot_command::blocks
