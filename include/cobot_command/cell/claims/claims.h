// The space that each robot and mechanism of a cell can occupy, for each piece of its programs: voxels that
// contain all its bodies, no matter when its frames are sent (doc/cell.md).
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

/// An arm whose joints are in a range.
struct ArmPosture {
  motion::JointRange range;                   ///< contains the joints at every time of the piece
  std::shared_ptr<const RobotBodies> bodies;  ///< including carried parts
};

/// A mechanism between two values of its axis [m or rad].
struct AxisPosture {
  double from = 0.0;  ///< in the order of motion; equal at rest
  double to = 0.0;
  std::shared_ptr<const MechanismBodies> bodies;

  [[nodiscard]] double centre() const { return 0.5 * (from + to); }
};

/// A part of a motion, or a rest, in which no body moves farther than `step_bound`.
struct Piece {
  enum class Kind {
    Corner,  ///< overlap with the previous motion, for every arrival time of this one
    Motion,
    Rest  ///< at the end of the frame
  };
  Kind kind = Kind::Motion;
  std::size_t frame = 0;   ///< of the path; a mechanism has one per path
  std::size_t motion = 0;  ///< of the frame
  Duration from{};         ///< since the start of that motion; unknown for a mechanism
  Duration to{};
  std::variant<ArmPosture, AxisPosture> posture;
  /// Largest distance of any point of a body from its position at the centre of the posture [m].
  double displacement = 0.0;
  VoxelSet claim;

  [[nodiscard]] bool isOfMechanism() const { return std::holds_alternative<AxisPosture>(posture); }
  /// The bodies at the centre of the posture, in the world [m].
  [[nodiscard]] Capsules capsulesAtCentre() const;
};

struct PathClaim {
  /// In the order of the frames; for each frame its corners, its motions in the order of time, and its rest.
  std::vector<Piece> pieces;
};

struct RobotClaim {
  std::string name;
  std::vector<PathClaim> paths;  ///< as planned; for a mechanism, as in the cell
  std::vector<Piece> stations;   ///< the rest at each station; for a mechanism, see stationsOf()
  VoxelSet all;                  ///< of all pieces

  [[nodiscard]] std::size_t pieces() const;
};

/// Claims that need more are refused before the memory is allocated [bytes].
inline constexpr std::size_t kMostClaimMemory = std::size_t{1} << 30;

/// The claims of all robots of a cell, then of its mechanisms, in the order of the cell. Computed in parallel
/// on `threads` threads, with the same result. Faults: a motion without provable bounds (UNBOUNDED), bodies
/// that cannot be converted to capsules, claims that would need more than kMostClaimMemory according to a
/// sample.
[[nodiscard]] Result<std::vector<RobotClaim>, std::vector<Fault>> claimCell(
    const Cell& cell, const std::vector<PlannedRobot>& robots, unsigned threads = 1);

/// The claim of one path of one robot, as in claimCell().
[[nodiscard]] Result<PathClaim, std::vector<Fault>> claimPath(const Cell& cell, const Robot& robot,
                                                              const PlannedRobot& planned, std::size_t path);

/// Largest distance of a claimed point from a body that is there at some time: the excess size of the claim
/// [m].
[[nodiscard]] double claimError(const Parameters& parameters);

}  // namespace cobot_command::cell
