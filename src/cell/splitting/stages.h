// All that is made of a cell up to its holds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cobot_command/cell/splitting/split_cell.h"

namespace cobot_command::cell {

[[nodiscard]] Result<SplitCell, std::vector<std::string>> stagesOf(const Cell& cell, unsigned threads);

/// Zones and holds anew, of the claims as they are now. Faults, each a sentence; none: it is done.
[[nodiscard]] std::vector<std::string> findHolds(SplitCell& stages);

/// What follows of other steps of one path.
struct PathStages {
  PlannedPath planned;
  PathClaim claim;
};
struct PathIn {
  const SplitCell& stages;
  RobotIndex robot = 0;
  std::size_t path = 0;
};
/// Nothing: they cannot be planned.
[[nodiscard]] std::optional<PlannedRobot> planWith(const PathIn& where, const std::vector<Step>& steps);
/// Of what planWith() gave. Nothing: they cannot be claimed.
[[nodiscard]] std::optional<PathClaim> claimWith(const PathIn& where, const std::vector<Step>& steps,
                                                 const PlannedRobot& planned);
/// Puts steps and what follows of them in the place of those that are there.
void takeOver(SplitCell& stages, RobotIndex robot, std::size_t path, std::vector<Step> steps,
              PathStages following);

}  // namespace cobot_command::cell
