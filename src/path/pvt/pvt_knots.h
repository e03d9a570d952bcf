// Where the cubics of a PVT meet: the times of its points, and how far each motion is ahead of its plan
// there, so that no cubic is steeper than the motion.
#pragma once

#include <cstddef>
#include <vector>

#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/command.h"
#include "cobot_command/path/path_plan.h"

namespace cobot_command::path {

struct PvtKnot {
  Duration time{};           ///< whole milliseconds since the path began
  std::size_t point = 0;     ///< of its phase (pvt_phases.h)
  std::size_t begun = 0;     ///< the point whose motion has begun last
  double lead = 0.0;         ///< of that motion (motion::leadsAt) [s]
  double lead_before = 0.0;  ///< of the one before it, which it overlaps
};

/// Of points `first` to `last`, from rest to rest, with segments of at least `segment`; the first one is
/// where the PVT begins. What is chosen around a point follows from that, and from two of its neighbours on
/// each side.
[[nodiscard]] std::vector<PvtKnot> knotsOf(const PathPlan& plan, std::size_t first, std::size_t last,
                                           Duration segment);

/// How far from where the plan has them the joints are there.
[[nodiscard]] arm::JointVector leadAt(const PathPlan& plan, const PvtKnot& knot);

/// Where the arm is at the knot, rounded as it is sent, `before` being the time of the one in front.
[[nodiscard]] motion::PvtJointPoint pvtPointAt(const PathPlan& plan, Duration before, const PvtKnot& knot);

}  // namespace cobot_command::path
