#include "cobot_command/blocks/move_relative.h"

#include "shared/motion_parameters.h"

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::blocks {
namespace {

constexpr std::array<std::string_view, 9> kRelativeNames{"JPP", "CPP", "CPR", "CAP", "CAR",
                                                         "TPP", "TPR", "TAP", "TAR"};
constexpr FormatList kRelativeFormats(kRelativeNames);

}  // namespace

ErrorTable MoveRelativeGoal::errors() {
  return ErrorTable()
      .thesisCommand()
      .anyCommand()
      .turn()
      .underInterface()
      .inCell()
      .move()
      .row(relative_error::kFormatForPtp, "DataFormat invalid for PTP command", kSetInRange,
           "PTP with a data_format other than JPP (0), CPP (1) or TPP (5), known or unknown")
      .row(relative_error::kFormatForLine, "DataFormat invalid for Line command", kSetInRange,
           "Line with JPP (0) or an unknown data_format")
      .shared({own_error::kBlendingTooLarge, own_error::kMovementUnknown});
}

std::optional<script::DataFormat> formatOf(const MoveRelativeGoal& goal) {
  return kRelativeFormats.at(goal.data_format);
}

GoalTraits traitsOf(const MoveRelativeGoal& goal) {
  return traitsOfMove(goal);
}

std::vector<Failure> check(const MoveRelativeGoal& goal) {
  ParameterChecks checks;
  checkMotion(checks, parametersOf(goal), formatOf(goal));
  checkMovement(checks, goal.movement_command, goal.data_format, kRelativeFormats,
                relative_error::kFormatForPtp, relative_error::kFormatForLine);
  checks.sixValues("target_position", goal.target);
  return std::move(checks).violations();
}

Order orderOf(const MoveRelativeGoal& goal, const arm::Pose& /*base*/) {
  const script::DataFormat format = formatOf(goal).value_or(script::DataFormat{});
  const script::MotionOptions options = optionsOf(parametersOf(goal));
  if (goal.movement_command == static_cast<int>(Movement::Line)) {
    return moveOrder(script::MoveLine{format, goal.target, options});
  }
  return moveOrder(script::MovePtp{format, goal.target, options});
}

}  // namespace cobot_command::blocks
