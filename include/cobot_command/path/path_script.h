// A path as script motions, one per point: the controller plans them itself, and some properties of a point
// cannot be expressed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cobot_command/common/result.h"
#include "cobot_command/path/path_plan.h"
#include "cobot_command/path/path_refusal.h"
#include "cobot_command/path/path_scene.h"
#include "cobot_command/script/script_command.h"

namespace cobot_command::path {

/// Poses are those of the moved frame in the robot base. Base and TCP are set before the motion if others are
/// active.
struct PointScript {
  std::vector<script::ScriptCommand> lines;  ///< changes of base and TCP, then the motion
  std::vector<std::string> approximations;   ///< "point 3: profile MOD_SINE with a jerk of 100 %"
};

/// The active frames before the path; std::nullopt: unknown, so they are set.
struct ScriptFrames {
  std::optional<arm::Pose> base;  ///< in the robot base
  std::optional<arm::Pose> tcp;   ///< in the flange
};

/// Points `first` to the last of the plan. Refused (16#271) with the first point that a script cannot
/// express: a wrist move.
[[nodiscard]] Result<std::vector<PointScript>, PathRefusal> scriptOf(const PathPlan& plan, std::size_t first,
                                                                     const PathScene& scene,
                                                                     const ScriptFrames& active);

}  // namespace cobot_command::path
