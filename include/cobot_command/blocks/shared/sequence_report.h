// What the check or the execution of steps, one behind the other, has found of each: a detail of the blocks
// that have steps.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/blocks/shared/joint_path.h"
#include "cobot_command/blocks/shared/outcome.h"
#include "cobot_command/common/time.h"

namespace cobot_command::blocks {

struct StepReport {
  int error_id = 0;               ///< of the catalogue of the step's own block; 0: nothing wrong
  std::string error_description;  ///< and the remedy
  Duration
      start{};  ///< since the start of the sequence; earlier than the end of the step before when blended
  Duration duration{};  ///< of the step from rest to rest, zero for what is no motion
  Duration done{};      ///< since the start of the sequence, as executed; zero: not, or nobody looked
  /// The first offending point, TCP in the active base, mm and degrees; where one is to blame.
  std::optional<std::array<double, 6>> offending_point;
  std::vector<JointPathPoint> joint_path;  ///< when it was checked; time since the start of the step
};

struct SequenceReport {
  std::vector<StepReport> steps;  ///< of every one that was looked at
  int failed_step = -1;           ///< from 0; -1: none
};

/// Of a sequence of which nothing is known but the step that is to blame, from 0; `error_id`: of the step's
/// own block, 0 when what is wrong has no error there.
[[nodiscard]] SequenceReport blaming(std::size_t step, int error_id = 0, std::string error_description = "");

/// 16#251: the step `step` (from 0) of `count` cannot be made, for the reason `own`, that of its own block.
/// With a SequenceReport that blames it.
[[nodiscard]] Failure stepRefused(std::size_t step, std::size_t count, const Outcome& own);

/// Of a number of steps that may not be (16#250).
[[nodiscard]] std::string foundSteps(std::size_t count, std::size_t most);

}  // namespace cobot_command::blocks
