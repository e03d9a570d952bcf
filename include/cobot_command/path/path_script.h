// A path as motions of a script, one for each point: what the controller plans by itself, and what of a point
// that cannot say.
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

/// Poses are those of the moved frame in the robot base: both are set in front where another one is active.
struct PointScript {
  std::vector<script::ScriptCommand> lines;  ///< changes of base and TCP, then the motion
  std::vector<std::string> approximations;   ///< "point 3: profile MOD_SINE with a jerk of 100 %"
};

/// The active frames in front of the path; nothing: not known, so they are set.
struct ScriptFrames {
  std::optional<arm::Pose> base;  ///< in the robot base
  std::optional<arm::Pose> tcp;   ///< in the flange
};

/// Points `first` to the last of the plan. Refused (16#271) with the first point that no script can make: a
/// wrist move.
[[nodiscard]] Result<std::vector<PointScript>, PathRefusal> scriptOf(const PathPlan& plan, std::size_t first,
                                                                     const PathScene& scene,
                                                                     const ScriptFrames& active);

}  // namespace cobot_command::path
