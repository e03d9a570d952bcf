// Pick and place (annex B and chapter 6.3.8 of the thesis): above pick, pick, up, dwell, above place, place,
// up, dwell; repeated. A step is a move_absolute, optionally followed by a set_output and a wait_for_input.
// The goal is checked as a whole before the first move. A pause of the robot also pauses dwells and timeouts.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/blocks/move_absolute.h"
#include "cobot_command/blocks/set_output.h"
#include "cobot_command/blocks/shared/block_parts.h"
#include "cobot_command/blocks/shared/run.h"
#include "cobot_command/blocks/shared/sequence_report.h"
#include "cobot_command/blocks/waits/wait_for_input.h"

namespace cobot_command::blocks {

/// One move of a pick-and-place cycle, and the actions after the robot has stopped at its target.
struct PickAndPlaceStep {
  MoveAbsoluteGoal move;
  std::optional<SetOutputGoal> output;    ///< set first, as a queued command, e.g. the gripper
  std::optional<WaitForInputGoal> input;  ///< awaited next, e.g. the switch of the gripper
  double dwell = 0;                       ///< then wait [s], 0..3600
};

struct PickAndPlaceGoal {
  static constexpr const char* kName = "pick_and_place";
  /// Check this limit before you create the steps of a goal, because each step costs work.
  static constexpr std::size_t kMostSteps = 50;
  [[nodiscard]] static ErrorTable errors();

  std::vector<PickAndPlaceStep> steps;  ///< 1..50; six in the thesis
  std::string steps_fault;              ///< why the steps could not be read; empty: they were read
  int cycles = 1;                       ///< 1..1000000; 0: until cancelled
  int buffer_mode = 0;
  bool check_only = false;
};

/// Detail of the outcome, also if the goal was refused.
struct CycleReport : SequenceReport {
  int cycles_done = 0;
};

/// Detail of the progress: the running step.
struct CyclePlace {
  int step = -1;  ///< from 0; -1: none yet
  int cycle = 0;  ///< from 1; 0: none yet
};

[[nodiscard]] GoalTraits traitsOf(const PickAndPlaceGoal& goal);
/// All violations of the goal's own parameters, and the first step that is invalid in itself.
[[nodiscard]] std::vector<Failure> check(const PickAndPlaceGoal& goal);
[[nodiscard]] std::optional<Failure> findMovedFrame(const PickAndPlaceGoal& goal, const FrameFinder& finder);
/// Plans the cycle as a whole. With more than one cycle the first step follows the last one.
[[nodiscard]] Outcome plan(const PickAndPlaceGoal& goal, const PlanningScene& scene);
/// `planned`: the result of plan() for the steps; may be empty.
[[nodiscard]] std::unique_ptr<Run> runOf(const PickAndPlaceGoal& goal, GoalId id, const Outcome& planned,
                                         Instant now);

}  // namespace cobot_command::blocks
