// Where on the pieces of a path the arm has come to stand.
#pragma once

#include <cstddef>
#include <vector>

#include "chain/path_member.h"

#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"

namespace cobot_command::blocks {

struct PathStand {
  std::size_t point = 0;  ///< that moved it
  Duration time{};        ///< of the motion of that point, by its plan
};

/// At that time of the piece; while two points blend, on the way of the second one. `first`: of its points.
[[nodiscard]] PathStand standAt(const LoadedPiece& piece, std::size_t first, Duration time);

/// From `certain` on the earliest place that is as near to the joints as any within the next seconds of the
/// pieces: while the robot is stopped, tags are for nobody, and its clock is not known.
[[nodiscard]] PathStand standOn(const std::vector<SentPiece>& pieces, const PathStand& certain,
                                const arm::JointVector& joints);

}  // namespace cobot_command::blocks
