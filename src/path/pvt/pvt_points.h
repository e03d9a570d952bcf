// What whoever makes a PVT would refuse of its points.
#pragma once

#include <cstddef>
#include <optional>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/pvt.h"
#include "cobot_command/path/path_plan.h"
#include "cobot_command/path/path_refusal.h"

namespace cobot_command::path {

/// 16#204 or 1047, in the name of the point that moves the arm at that time of the plan.
[[nodiscard]] PathRefusal toRefusal(const motion::PvtOffence& offence, const PathPlan& plan, Duration time,
                                    const arm::ArmModel& arm);

/// What a PVT from the point `first` on, from rest, to the rest behind the last one would be refused for, on
/// the way of `from` or behind it. With half of the room that a PVT has: the arm may begin it a little beside
/// its start.
[[nodiscard]] std::optional<PathRefusal> checkAsPvt(const PathPlan& plan, std::size_t first, std::size_t from,
                                                    const arm::ArmModel& arm);

}  // namespace cobot_command::path
