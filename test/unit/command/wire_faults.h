// How a goal ends, and what controller and wire do to a command that was sent, for scenarios of any block.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "catalogue_scenarios.h"
#include "core_rig.h"

namespace cobot_command::testing {

/// Of a goal that has ended.
[[nodiscard]] blocks::Outcome endOf(CoreRig& rig, blocks::GoalId id);

// Each takes the id of the script that the command went out with.
/// The link drops, and the status stream, which might tell why, hangs.
void lose(CoreRig& rig, const std::string& script_id);
/// Its tag comes, and the robot moves on.
void tellTheEndTooEarly(CoreRig& rig, const std::string& script_id);
/// The robot comes to rest at these joints, which are not its target, and its tag is unknown.
void standAt(const std::vector<float>& joints_deg, CoreRig& rig, const std::string& script_id);

/// A path that ends where StatusFrames stand, and began with joint 1 at `begin` degrees. Precondition: a
/// TM5-900 that is connected.
void driveAPath(CoreRig& rig, float begin = 10, blocks::Execution execution = blocks::Execution::Auto);

/// A goal of a TM5-900 that stands at 0 0 90 0 90 0 degrees, having driven a path where it is a retrace; what
/// becomes of the goal when it was sent.
using WireFault = std::function<void(CoreRig& rig, const std::string& script_id)>;
[[nodiscard]] Scenario scenarioOf(const blocks::Goal& goal, const WireFault& fault);
/// Such a goal that turns joint 1 to `end` degrees, with all that wire and robot may do to it on its way.
[[nodiscard]] Scenarios wireScenariosOfATurn(const blocks::Goal& goal, float end);

}  // namespace cobot_command::testing
