// How long the lists of a goal may be. Who makes goals looks at it before the work that each step costs.
#pragma once

#include <cstddef>

namespace cobot_command::blocks {

/// Steps of a check_sequence goal.
inline constexpr std::size_t kMostSequenceSteps = 200;
/// Steps of a pick_and_place goal.
inline constexpr std::size_t kMostCycleSteps = 50;

}  // namespace cobot_command::blocks
