// Plans a whole list end to end: reach, pose bits, limits along every path, singularities, blends. Sends
// nothing.
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

/// A step of a sequence to be checked.
using SequenceStep =
    std::variant<MoveAbsoluteGoal, MoveRelativeGoal, MoveCircleGoal, ChangeBaseGoal, ChangeTcpGoal>;

struct CheckSequenceGoal {
  static constexpr const char* kName = "check_sequence";
  /// Who makes goals looks at it before the work that each step costs.
  static constexpr std::size_t kMostSteps = 200;
  [[nodiscard]] static ErrorTable errors();

  std::vector<SequenceStep> steps;   ///< 1..200
  std::string steps_fault;           ///< why the steps could not be read; empty: they could
  std::vector<double> start_joints;  ///< [deg], six; empty: where the robot is, or what is sent will leave it
  int faulty_step = -1;              ///< the one that steps_fault is about, from 0; -1: none
  bool comes_round = false;          ///< behind the last step comes the first again, as in a cycle
};

[[nodiscard]] GoalTraits traitsOf(const CheckSequenceGoal& goal);
/// Nothing: what is wrong with the steps is found step by step, by plan().
[[nodiscard]] std::vector<Failure> check(const CheckSequenceGoal& goal);
/// Done with a report of every step (SequenceReport); or Rejected with the index of the first step that fails
/// and its own error, the reports ending with it.
[[nodiscard]] Outcome plan(const CheckSequenceGoal& goal, const PlanningScene& scene);

}  // namespace cobot_command::blocks
