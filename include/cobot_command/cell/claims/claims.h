// Where each robot of a cell can be, piece by piece of its programs: voxels that contain every body of it,
// whenever and however late its frames are sent (cell.md, section 3).
//
// SI [m, rad].
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "cobot_command/cell/bodies/robot_bodies.h"
#include "cobot_command/cell/plan/planned_cell.h"
#include "cobot_command/cell/program/cell.h"
#include "cobot_command/cell/sweep/voxel_set.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/joint_range.h"

namespace cobot_command::cell {

/// A part of a motion, or a rest, short enough that no body moves farther than `step_bound`.
struct Piece {
  enum class Kind {
    Corner,  ///< the motion before it and this one at once, for every arrival of this one
    Motion,
    Rest  ///< at the end of the frame
  };
  Kind kind = Kind::Motion;
  std::size_t frame = 0;   ///< of the path
  std::size_t motion = 0;  ///< of the frame
  Duration from{};         ///< since that motion began
  Duration to{};
  motion::JointRange range;  ///< contains the joints at every moment of it
  double displacement =
      0.0;  ///< no point of a body is farther than this from where it is at the centre of the range [m]
  std::shared_ptr<const RobotBodies> bodies;  ///< with what is carried
  VoxelSet claim;
};

struct PathClaim {
  /// By frames; of each its corners, its motions in the order of time, and its rest.
  std::vector<Piece> pieces;
};

struct RobotClaim {
  std::string name;
  std::vector<PathClaim> paths;  ///< as planned
  std::vector<Piece> stations;   ///< the rest at each
  VoxelSet all;                  ///< of all pieces

  [[nodiscard]] std::size_t pieces() const;
};

/// Of all robots of a cell, in its order; robots side by side on `threads` threads, with the same result.
/// Faults: a motion of which nothing can be proved (UNBOUNDED), bodies that cannot be made of capsules.
[[nodiscard]] Result<std::vector<RobotClaim>, std::vector<Fault>> claimCell(
    const Cell& cell, const std::vector<PlannedRobot>& robots, unsigned threads = 1);

/// One path of one of its robots, as claimCell() claims it.
[[nodiscard]] Result<PathClaim, std::vector<Fault>> claimPath(const Cell& cell, const Robot& robot,
                                                              const PlannedRobot& planned, std::size_t path);

/// How far a claimed point is at most from a body that is there at some moment: what the claim is too large
/// by [m].
[[nodiscard]] double claimError(const Parameters& parameters);

}  // namespace cobot_command::cell
