// CBT_ChangeTCP (thesis 5.3.6).

#include "parameter_checks.h"
#include <fmt/format.h>

#include "cobot_command/blocks/error_ids.h"

namespace cobot_command::blocks {
namespace {

constexpr double kMaxWeight = 14;
/// Far above that of 14 kg at the end of the longest arm; below, it is a number that the controller can hold.
constexpr double kMaxInertia = 1e9;

}  // namespace

CommandTraits traitsOf(const ChangeTcpGoal& goal) {
  return traitsOfCommand(goal);
}

std::vector<Failure> check(const ChangeTcpGoal& goal) {
  ParameterChecks checks;
  checks.commandId(goal.command_id, kNoCommandId);
  checks.bufferMode(goal.buffer_mode);
  if (!goal.tcp_name.empty()) {
    checks.name("tcp_name", goal.tcp_name);
    return std::move(checks).violations();
  }
  checks.require(isWithin(goal.weight, 0, kMaxWeight), tcp_error::kWeightRange,
                 fmt::format("weight is {}", goal.weight));
  checks.sixValues("tcp_offset", goal.tcp_offset);
  checks.sixValues("mass_center", goal.mass_center);
  const std::array<const char*, 3> axes{"ixx", "iyy", "izz"};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    checks.require(isWithin(goal.moment_of_inertia[i], 0, kMaxInertia), own_error::kInertiaRange,
                   fmt::format("{} is {}", axes[i], goal.moment_of_inertia[i]));
  }
  return std::move(checks).violations();
}

script::ScriptCommand commandOf(const ChangeTcpGoal& goal, const arm::Pose& /*base*/) {
  if (!goal.tcp_name.empty()) return script::ChangeTcp{goal.tcp_name, std::nullopt, std::nullopt};
  return script::ChangeTcp{goal.tcp_offset, goal.weight,
                           script::ToolInertia{goal.moment_of_inertia, goal.mass_center}};
}

}  // namespace cobot_command::blocks
