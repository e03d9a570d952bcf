// The results of checking or executing consecutive steps: a detail of the blocks that have steps.
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
  int error_id = 0;               ///< from the catalogue of the step's own block; 0: no error
  std::string error_description;  ///< and the remedy
  /// Since the start of the sequence; before the end of the previous step if the two blend.
  Duration start{};
  Duration duration{};  ///< of the step from rest to rest, zero if it is no motion
  /// End of the step as executed, since the start of the sequence; zero: not executed, or not measured.
  Duration done{};
  /// The first point that causes the error, if there is one: TCP in the active base [mm, deg].
  std::optional<std::array<double, 6>> offending_point;
  std::vector<JointPathPoint> joint_path;  ///< if it was checked; time since the start of the step
};

struct SequenceReport {
  std::vector<StepReport> steps;  ///< of every step that was checked or executed
  int failed_step = -1;           ///< from 0; -1: none
};

/// Report of a sequence that contains only the step that caused the error (index from 0). `error_id`: from
/// the step's own block, 0 if that has no such error.
[[nodiscard]] SequenceReport blaming(std::size_t step, int error_id = 0, std::string error_description = "");

/// 16#251: the step `step` (from 0) of `count` cannot be executed, for the reason `own`, which is of the
/// step's own block. Includes a SequenceReport with that step.
[[nodiscard]] Failure stepRefused(std::size_t step, std::size_t count, const Outcome& own);

/// Text for an invalid number of steps (16#250).
[[nodiscard]] std::string foundSteps(std::size_t count, std::size_t most);

}  // namespace cobot_command::blocks
