#include "cobot_command/blocks/change_tcp.h"

#include "shared/parameter_checks.h"
#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::blocks {
namespace {

/// Far above that of 14 kg at the end of the longest arm; below, it is a number that the controller can hold.
constexpr double kMaxInertia = 1e9;

}  // namespace

ErrorTable ChangeTcpGoal::errors() {
  return ErrorTable()
      .thesisCommand()
      .echoedCommandId()
      .anyCommand()
      .turn()
      .inCell()
      .row(tcp_error::kWeightRange, "Weight range: 0~14 kg", kSetInRange,
           "weight is negative, above 14, or not a number")
      .row(own_error::kInertiaRange, "Moment of inertia range: 0~1000000000 kg mm^2", kSetInRange,
           "ixx, iyy or izz is negative, above 1000000000, or not a number")
      .shared({own_error::kNotFinite, own_error::kCoordinateRange, own_error::kNameInvalid});
}

GoalTraits traitsOf(const ChangeTcpGoal& goal) {
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

Order orderOf(const ChangeTcpGoal& goal, const arm::Pose& /*base*/) {
  if (!goal.tcp_name.empty()) {
    return settingOrder(script::ChangeTcp{goal.tcp_name, std::nullopt, std::nullopt});
  }
  return settingOrder(script::ChangeTcp{goal.tcp_offset, goal.weight,
                                        script::ToolInertia{goal.moment_of_inertia, goal.mass_center}});
}

}  // namespace cobot_command::blocks
