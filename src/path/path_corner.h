// How one point of a path passes into the next one.
#pragma once

#include "cobot_command/common/time.h"
#include "cobot_command/path/path_plan.h"
#include "cobot_command/path/path_scene.h"

namespace cobot_command::path {

/// How long before the end of `before` the next motion begins, by its termination and tolerance: what is left
/// out of its way is never more than that. Whole milliseconds; below 25 it is a stop.
[[nodiscard]] Duration overlapBetween(const PlannedPoint& before, const PlannedPoint& next,
                                      const PathScene& scene);

/// The next one to try where that cannot be sent: half of it, or none.
[[nodiscard]] Duration shorterOverlap(Duration overlap);

}  // namespace cobot_command::path
