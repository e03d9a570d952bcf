// What can be said of a point without planning, in the order of the manual's numbers.
#pragma once

#include <optional>

#include "cobot_command/path/path_point.h"
#include "cobot_command/path/path_refusal.h"
#include "cobot_command/tables/data_tables.h"

namespace cobot_command::path {

/// 1017 to 1032; 1013 to 1015 are those of DynamicsOfGoal. Fields that the point makes no use of are not
/// looked at: the pose of a joint target, the tolerance of a stop. `tables`: nullptr: what is in them is not
/// looked at (1031, 1032).
[[nodiscard]] std::optional<PathRefusal> checkPoint(const PathPoint& point, int index,
                                                    const tables::DataTables* tables);

/// What is checked only once all points are right so far, as it belongs to planning: 1035, 1037, 1058.
[[nodiscard]] std::optional<PathRefusal> checkTarget(const PathPoint& point, int index);

/// Whether the pose, or its x y z, says where the target is.
[[nodiscard]] bool hasPose(const PathPoint& point);
/// Whether it matters in which frame its poses are: that of the target, or the point on an arc.
[[nodiscard]] bool hasReference(const PathPoint& point);
/// Whether it matters which frame is moved: its pose is given, or it goes straight.
[[nodiscard]] bool hasMovedFrame(const PathPoint& point);

}  // namespace cobot_command::path
