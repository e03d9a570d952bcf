// Back along the way that the last path has driven, and forth again: retrace of SRCI.
// doc/actions/retrace.md.
#pragma once

#include <memory>

#include "cobot_command/blocks/shared/block_parts.h"
#include "cobot_command/blocks/shared/run.h"

namespace cobot_command::blocks {

struct RetraceGoal {
  static constexpr const char* kName = "retrace";
  [[nodiscard]] static ErrorTable errors();

  static constexpr int kStart = -1;  ///< where its first point was set out for
  static constexpr int kEnd = -2;    ///< where the robot was on the path last

  int point = kStart;   ///< in the array of its goal, or one of these
  int method_id = 0;    ///< whose point, as load_path has told; 0: of the goal that moved the robot last
  double speed = 0;     ///< 1..100 % of the speeds of the path; 0: 25
  int buffer_mode = 0;  ///< BufferMode
};

[[nodiscard]] GoalTraits traitsOf(const RetraceGoal& goal);
[[nodiscard]] std::vector<Failure> check(const RetraceGoal& goal);
/// From where the robot stands on the way.
[[nodiscard]] Outcome plan(const RetraceGoal& goal, const PlanningScene& scene);
[[nodiscard]] std::unique_ptr<Run> runOf(const RetraceGoal& goal, GoalId id, const Outcome& planned,
                                         Instant now);

}  // namespace cobot_command::blocks
