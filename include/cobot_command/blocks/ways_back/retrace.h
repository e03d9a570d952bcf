// Moves the robot back along the path that was last driven, and forward again: retrace of SRCI.
// doc/actions/retrace.md.
#pragma once

#include <memory>

#include "cobot_command/blocks/shared/block_parts.h"
#include "cobot_command/blocks/shared/run.h"

namespace cobot_command::blocks {

struct RetraceGoal {
  static constexpr const char* kName = "retrace";
  [[nodiscard]] static ErrorTable errors();

  static constexpr int kStart = -1;  ///< where the motion to its first point began
  static constexpr int kEnd = -2;    ///< where the robot last was on the path

  int point = kStart;  ///< index in the array of its goal, or kStart or kEnd
  /// Goal of the point, as load_path has reported it; 0: the goal that moved the robot last.
  int method_id = 0;
  double speed = 0;     ///< 1..100 % of the speeds of the path; 0: 25
  int buffer_mode = 0;  ///< BufferMode
};

[[nodiscard]] GoalTraits traitsOf(const RetraceGoal& goal);
[[nodiscard]] std::vector<Failure> check(const RetraceGoal& goal);
/// Plans from the present position of the robot on the path.
[[nodiscard]] Outcome plan(const RetraceGoal& goal, const PlanningScene& scene);
[[nodiscard]] std::unique_ptr<Run> runOf(const RetraceGoal& goal, GoalId id, const Outcome& planned,
                                         Instant now);

}  // namespace cobot_command::blocks
