// Goals that wait for no other goal on their way to the core: those that stop, pause or resume the robot.
#pragma once

#include <type_traits>
#include <variant>

#include "cobot_command/blocks/list/goal.h"

namespace cobot_command::blocks {

template <class Kind>
inline constexpr bool kGoesFirst = std::is_same_v<Kind, StopGoal> || std::is_same_v<Kind, ProgramControlGoal>;

[[nodiscard]] inline bool goesFirst(const Goal& goal) {
  return std::visit([](const auto& one) { return kGoesFirst<std::decay_t<decltype(one)>>; }, goal);
}

}  // namespace cobot_command::blocks
