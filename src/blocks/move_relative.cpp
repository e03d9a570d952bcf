// CBT_MoveRelative (thesis 5.3.3).

#include "motion_parameters.h"

#include "cobot_command/blocks/error_ids.h"

namespace cobot_command::blocks {
namespace {

constexpr std::array<std::string_view, 9> kFormatNames{"JPP", "CPP", "CPR", "CAP", "CAR",
                                                       "TPP", "TPR", "TAP", "TAR"};
constexpr FormatList kFormats(kFormatNames);

}  // namespace

CommandTraits traitsOf(const MoveRelativeGoal& goal) {
  return traitsOfMove(goal);
}

std::vector<Failure> check(const MoveRelativeGoal& goal) {
  ParameterChecks checks;
  checkMotion(checks, parametersOf(goal), kFormats.at(goal.data_format));
  checkMovement(checks, goal.movement_command, goal.data_format, kFormats, relative_error::kFormatForPtp,
                relative_error::kFormatForLine);
  checks.sixValues("target_position", goal.target);
  return std::move(checks).violations();
}

script::ScriptCommand commandOf(const MoveRelativeGoal& goal, const arm::Pose& /*base*/) {
  const script::DataFormat format = kFormats.at(goal.data_format).value_or(script::DataFormat{});
  const script::MotionOptions options = optionsOf(parametersOf(goal));
  if (goal.movement_command == static_cast<int>(Movement::Line)) {
    return script::MoveLine{format, goal.target, options};
  }
  return script::MovePtp{format, goal.target, options};
}

}  // namespace cobot_command::blocks
