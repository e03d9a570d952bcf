// Runs the program of the robot in its cell, frame by frame, each with a permit (doc/cell.md).
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
  /// Check this limit before you create the paths of a goal, because each path costs work.
  static constexpr std::size_t kMostPaths = 1000;
  [[nodiscard]] static ErrorTable errors();

  std::vector<std::string> paths;  ///< at most kMostPaths
  std::string paths_fault;         ///< why the paths could not be read; empty: they were read
  int cycles = 1;                  ///< 1..1000000; 0: until cancelled
};

/// Detail of the outcome.
struct ProgramReport {
  int cycles_done = 0;
  std::string place;
  std::vector<Duration> waited;  ///< for permits, in each of the last CycleWaits::kMost cycles
};

/// Detail of the progress.
struct ProgramProgress {
  ProgramStand stand;
};

[[nodiscard]] GoalTraits traitsOf(const RunProgramGoal& goal);
[[nodiscard]] std::vector<Failure> check(const RunProgramGoal& goal);
/// Checks that the robot has such a program. Its frames are planned one by one, when they are sent.
[[nodiscard]] Outcome plan(const RunProgramGoal& goal, const PlanningScene& scene);
[[nodiscard]] std::unique_ptr<Run> runOf(const RunProgramGoal& goal, GoalId id, const Outcome& planned,
                                         Instant now);

}  // namespace cobot_command::blocks
