// Where each robot and mechanism of a cell can be, piece by piece of its programs: voxels that contain every
// body of it, whenever and however late its frames are sent (cell.md, section 3).
//
// SI [m, rad].
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "cobot_command/cell/bodies/mechanism_bodies.h"
#include "cobot_command/cell/bodies/robot_bodies.h"
#include "cobot_command/cell/plan/planned_cell.h"
#include "cobot_command/cell/program/cell.h"
#include "cobot_command/cell/sweep/voxel_set.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/joint_range.h"

namespace cobot_command::cell {

/// An arm while its joints are in a box.
struct ArmPosture {
  motion::JointRange range;                   ///< contains the joints at every moment of the piece
  std::shared_ptr<const RobotBodies> bodies;  ///< with what is carried
};

/// A mechanism while it is between two values of its axis [m or rad].
struct AxisPosture {
  double from = 0.0;  ///< in the order in which they are passed; both the same where it rests
  double to = 0.0;
  std::shared_ptr<const MechanismBodies> bodies;

  [[nodiscard]] double centre() const { return 0.5 * (from + to); }
};

/// A part of a motion, or a rest, short enough that no body moves farther than `step_bound`.
struct Piece {
  enum class Kind {
    Corner,  ///< the motion before it and this one at once, for every arrival of this one
    Motion,
    Rest  ///< at the end of the frame
  };
  Kind kind = Kind::Motion;
  std::size_t frame = 0;   ///< of the path; a mechanism makes one of each path
  std::size_t motion = 0;  ///< of the frame
  Duration from{};         ///< since that motion began; of a mechanism nobody knows
  Duration to{};
  std::variant<ArmPosture, AxisPosture> posture;
  /// No point of a body is farther than this from where it is at the centre of the posture [m].
  double displacement = 0.0;
  VoxelSet claim;

  [[nodiscard]] bool isOfMechanism() const { return std::holds_alternative<AxisPosture>(posture); }
  /// Where the bodies are at the centre of the posture, in the world [m].
  [[nodiscard]] Capsules capsulesAtCentre() const;
};

struct PathClaim {
  /// By frames; of each its corners, its motions in the order of time, and its rest.
  std::vector<Piece> pieces;
};

struct RobotClaim {
  std::string name;
  std::vector<PathClaim> paths;  ///< as planned; of a mechanism, as in the cell
  std::vector<Piece> stations;   ///< the rest at each; of a mechanism, at stationsOf() it
  VoxelSet all;                  ///< of all pieces

  [[nodiscard]] std::size_t pieces() const;
};

/// More is refused before it is taken [bytes].
inline constexpr std::size_t kMostClaimMemory = std::size_t{1} << 30;

/// Of all robots of a cell, and then of its mechanisms, in its order; side by side on `threads` threads, with
/// the same result. Faults: a motion of which nothing can be proved (UNBOUNDED), bodies that cannot be made
/// of capsules, claims that would take more than kMostClaimMemory by a sample of them.
[[nodiscard]] Result<std::vector<RobotClaim>, std::vector<Fault>> claimCell(
    const Cell& cell, const std::vector<PlannedRobot>& robots, unsigned threads = 1);

/// One path of one of its robots, as claimCell() claims it.
[[nodiscard]] Result<PathClaim, std::vector<Fault>> claimPath(const Cell& cell, const Robot& robot,
                                                              const PlannedRobot& planned, std::size_t path);

/// How far a claimed point is at most from a body that is there at some moment: what the claim is too large
/// by [m].
[[nodiscard]] double claimError(const Parameters& parameters);

}  // namespace cobot_command::cell
