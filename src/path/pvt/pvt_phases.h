// Where the segments of a PVT begin and end, so that its cubics miss the plan as little as can be. What is
// chosen around a point follows from its neighbours alone.
#pragma once

#include <cstddef>
#include <vector>

#include "cobot_command/common/time.h"
#include "cobot_command/path/path_plan.h"

namespace cobot_command::path {

/// From one time at which a segment certainly ends to the next one, whole milliseconds since the path began.
struct PvtPhase {
  Duration begin{};
  Duration end{};
  std::size_t point = 0;          ///< on whose way, with no other point, it ends
  std::vector<Duration> kinks{};  ///< ends of ramps and overlaps within it that are too near to others
};

/// Of points `first` to `last`, from rest to rest; each phase at least `segment` long, where the whole is.
[[nodiscard]] std::vector<PvtPhase> phasesOf(const PathPlan& plan, std::size_t first, std::size_t last,
                                             Duration segment);

/// When its segments end: none shorter than `segment`, unless the phase is.
[[nodiscard]] std::vector<Duration> segmentsOf(const PvtPhase& phase, Duration segment);

}  // namespace cobot_command::path
