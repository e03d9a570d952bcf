// Runs the program that the robot has in its cell, frame by frame, each with a permit (cell.md, section 6).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cobot_command/blocks/programs/program_guide.h"
#include "cobot_command/blocks/shared/block_parts.h"
#include "cobot_command/blocks/shared/run.h"

namespace cobot_command::blocks {

struct RunProgramGoal {
  static constexpr const char* kName = "run_program";
  /// Who makes goals looks at it before the work that each path costs.
  static constexpr std::size_t kMostPaths = 1000;
  [[nodiscard]] static ErrorTable errors();

  std::vector<std::string> paths;  ///< at most kMostPaths
  std::string paths_fault;         ///< why they could not be read; empty: they could
  int cycles = 1;                  ///< 1..1000000; 0: until cancelled
};

/// Detail of its end.
struct ProgramReport {
  int cycles_done = 0;
  std::string place;
  std::vector<Duration> waited;  ///< for permits, in each of the last CycleWaits::kMost cycles
};

/// Detail of its progress.
struct ProgramProgress {
  ProgramStand stand;
};

[[nodiscard]] GoalTraits traitsOf(const RunProgramGoal& goal);
[[nodiscard]] std::vector<Failure> check(const RunProgramGoal& goal);
/// Whether the robot has such a program; its frames are planned one by one, as they leave.
[[nodiscard]] Outcome plan(const RunProgramGoal& goal, const PlanningScene& scene);
[[nodiscard]] std::unique_ptr<Run> runOf(const RunProgramGoal& goal, GoalId id, const Outcome& planned,
                                         Instant now);

}  // namespace cobot_command::blocks
