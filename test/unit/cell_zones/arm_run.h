// What an arm really does with the frames of a path: sent when it pleases, at project speeds as they come.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "random_program.h"

#include "cobot_command/cell/plan/planned_cell.h"
#include "cobot_command/motion/trajectory.h"

namespace cobot_command::cell {

/// A motion as the arm makes it, until the next one takes over.
struct MadeMotion {
  std::size_t frame = 0;   ///< of the path
  std::size_t motion = 0;  ///< of the frame
  motion::TrajectoryPtr trajectory;
  Duration start{};
  Duration end{};
  std::set<std::string> carried;
};

/// Whether all of a run has one project speed, or each frame has its own: it counts for the motions that
/// start from then on.
enum class ProjectSpeed { Constant, Changing };

/// Frames of the first path of the cell's first robot, each sent at a random moment before or after the one
/// before it is done. None is faster than the highest project speed of the cell.
[[nodiscard]] std::vector<MadeMotion> runOf(const Cell& cell, const PlannedPath& path, ProjectSpeed speed,
                                            Dice& dice);

}  // namespace cobot_command::cell
