// Plans a whole list of steps from start to end: reach, pose bits, limits along every path, singularities,
// blends. Sends nothing.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cobot_command/blocks/change_base.h"
#include "cobot_command/blocks/change_tcp.h"
#include "cobot_command/blocks/move_absolute.h"
#include "cobot_command/blocks/move_circle.h"
#include "cobot_command/blocks/move_relative.h"
#include "cobot_command/blocks/shared/block_parts.h"
#include "cobot_command/blocks/shared/sequence_report.h"

namespace cobot_command::blocks {

using SequenceStep =
    std::variant<MoveAbsoluteGoal, MoveRelativeGoal, MoveCircleGoal, ChangeBaseGoal, ChangeTcpGoal>;

struct CheckSequenceGoal {
  static constexpr const char* kName = "check_sequence";
  /// Check this limit before you create the steps of a goal, because each step costs work.
  static constexpr std::size_t kMostSteps = 200;
  [[nodiscard]] static ErrorTable errors();

  std::vector<SequenceStep> steps;  ///< 1..200
  std::string steps_fault;          ///< why the steps could not be read; empty: they were read
  /// [deg], six values; empty: the present joints, or those at which the commands already sent will leave the
  /// robot.
  std::vector<double> start_joints;
  int faulty_step = -1;      ///< index of the step that steps_fault refers to; -1: none
  bool comes_round = false;  ///< the first step follows the last one, as in a cycle
};

[[nodiscard]] GoalTraits traitsOf(const CheckSequenceGoal& goal);
/// Always empty: plan() checks the steps one by one.
[[nodiscard]] std::vector<Failure> check(const CheckSequenceGoal& goal);
/// Done with a report for every step (SequenceReport). Otherwise Rejected with the index of the first step
/// that fails and its own error; the reports end with that step.
[[nodiscard]] Outcome plan(const CheckSequenceGoal& goal, const PlanningScene& scene);

}  // namespace cobot_command::blocks
