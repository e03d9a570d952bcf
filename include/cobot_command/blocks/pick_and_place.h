// Annex B and chapter 6.3.8: above pick, pick, up, dwell, above place, place, up, dwell; again and again. A
// step is a move_absolute, and may have a set_output and a wait_for_input behind it. Checked as a whole
// before the first move. A pause of the robot holds dwells and timeouts too.
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

/// One move of a pick-and-place cycle, and what follows once the robot stands at its target.
struct PickAndPlaceStep {
  MoveAbsoluteGoal move;
  std::optional<SetOutputGoal> output;    ///< set first, e.g. the gripper; in its turn
  std::optional<WaitForInputGoal> input;  ///< then waited for, e.g. the switch of the gripper
  double dwell = 0;                       ///< then wait [s], 0..3600
};

struct PickAndPlaceGoal {
  static constexpr const char* kName = "pick_and_place";
  /// Who makes goals looks at it before the work that each step costs.
  static constexpr std::size_t kMostSteps = 50;
  [[nodiscard]] static ErrorTable errors();

  std::vector<PickAndPlaceStep> steps;  ///< 1..50; six in the thesis
  std::string steps_fault;              ///< why the steps could not be read; empty: they could
  int cycles = 1;                       ///< 1..1000000; 0: until cancelled
  int buffer_mode = 0;
  bool check_only = false;
};

/// Detail of its end; also where it was refused.
struct CycleReport : SequenceReport {
  int cycles_done = 0;
};

/// Detail of its progress: what is under way.
struct CyclePlace {
  int step = -1;  ///< from 0; -1: none yet
  int cycle = 0;  ///< from 1; 0: none yet
};

[[nodiscard]] GoalTraits traitsOf(const PickAndPlaceGoal& goal);
/// All violations of the goal's own parameters, and the first of its steps that is wrong by itself.
[[nodiscard]] std::vector<Failure> check(const PickAndPlaceGoal& goal);
[[nodiscard]] std::optional<Failure> findMovedFrame(const PickAndPlaceGoal& goal, const FrameFinder& finder);
/// The cycle as a whole: its steps, which come round when there is more than one cycle.
[[nodiscard]] Outcome plan(const PickAndPlaceGoal& goal, const PlanningScene& scene);
/// `planned`: what plan() found of its steps; may be nothing.
[[nodiscard]] std::unique_ptr<Run> runOf(const PickAndPlaceGoal& goal, GoalId id, const Outcome& planned,
                                         Instant now);

}  // namespace cobot_command::blocks
