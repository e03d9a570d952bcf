#include "dynamics/defaults_desk.h"

namespace cobot_command::command {

DynamicsAnswer DefaultsDesk::write(const blocks::DefaultDynamics& defaults) {
  if (const auto fault = faultIn(defaults)) {
    return {false, dynamics_error::kDefaultDynamics, *fault + "; the previous defaults remain in effect"};
  }
  defaults_ = defaults;
  return {true, 0, "they apply to goals that arrive from now on"};
}

std::optional<blocks::Goal> DefaultsDesk::filled(const blocks::Goal& goal) const {
  if (defaults_ == blocks::DefaultDynamics()) return std::nullopt;
  return withDefaults(goal, defaults_);
}

}  // namespace cobot_command::command
