// Wherever the arm really is on its path, its bodies are in what the frame under way claims (oracle 22).
#include <cmath>
#include <map>

#include "arm_run.h"
#include "random_program.h"
#include "thorough.h"
#include "zoned_cell.h"
#include <gtest/gtest.h>

#include "cobot_command/cell/bodies/part_tree.h"
#include "cobot_command/cell/sweep/displacement.h"
#include "cobot_command/cell/sweep/robot_claim.h"

namespace cobot_command::cell {
namespace {

/// Postures are compared with ranges: what two plans of one path may differ by [rad].
constexpr double kSame = 1e-7;

bool isIn(const motion::JointRange& range, const arm::JointVector& joints) {
  return (joints.array() >= range.lower.array() - kSame).all() &&
         (joints.array() <= range.upper.array() + kSame).all();
}

Eigen::Vector3d pointOf(const Capsule& capsule, Dice& dice) {
  const double along = dice.upTo(2) == 0 ? dice.upTo(1) : dice.within(0, 1);
  const Eigen::Vector3d out = dice.joints(1).head<3>().normalized();
  return capsule.from + along * (capsule.to - capsule.from) + capsule.radius * out;
}

/// A cell with one robot, planned and claimed, and where its arm was found outside.
class Claimed {
 public:
  explicit Claimed(Cell of)
      : cell(std::move(of)), planned(orThrow(planCell(cell))), claims(orThrow(claimCell(cell, planned))) {}

  [[nodiscard]] const std::vector<Piece>& pieces() const { return claims.front().paths.front().pieces; }

  /// As many postures of a run as said, at any moments.
  void sample(ProjectSpeed speed, int count, Dice& dice) {
    const auto made = runOf(cell, planned.front().paths.front(), speed, dice);
    for (int i = 0; i < count; ++i) {
      const MadeMotion& motion = made[static_cast<std::size_t>(dice.upTo(static_cast<int>(made.size()) - 1))];
      const double share = dice.coin() ? dice.within(0, 1) : dice.ofAnySize(1e-4, 1);
      const auto time = fromSeconds(share * toSeconds(motion.end - motion.start));
      look(motion, motion.trajectory->at(time).position, dice);
    }
  }

  Cell cell;
  std::vector<PlannedRobot> planned;
  std::vector<RobotClaim> claims;
  int postures_outside = 0;  ///< in no piece of the motion
  int points_outside = 0;    ///< of the claim of a piece that the posture is in
  int unclaimed = 0;         ///< of the claim of the whole robot
  int points = 0;
  std::string first;

 private:
  void look(const MadeMotion& motion, const arm::JointVector& joints, Dice& dice) {
    const Piece* found = nullptr;
    for (const Piece& piece : pieces()) {
      const bool is_of_it = piece.frame == motion.frame && piece.motion == motion.motion;
      if (is_of_it && piece.kind != Piece::Kind::Rest &&
          isIn(std::get<ArmPosture>(piece.posture).range, joints)) {
        found = &piece;
      }
      if (found != nullptr) break;
    }
    if (found == nullptr) {
      ++postures_outside;
      if (first.empty()) {
        first = "frame " + std::to_string(motion.frame) + " motion " + std::to_string(motion.motion);
      }
    }
    const auto& bodies = bodiesWith(motion.carried);
    for (const Capsule& capsule : bodies.at(joints).capsules) {
      const Voxel voxel = voxelAt(pointOf(capsule, dice), cell.parameters.voxel);
      ++points;
      if (!claims.front().all.contains(voxel)) ++unclaimed;
      if (found != nullptr && !found->claim.contains(voxel)) ++points_outside;
    }
  }

  /// Made here once more, not taken from the claim.
  [[nodiscard]] const RobotBodies& bodiesWith(const std::set<std::string>& carried) {
    const auto known = bodies_.find(carried);
    if (known != bodies_.end()) return known->second;
    const Robot& robot = cell.robots.front();
    std::vector<CarriedPart> parts;
    for (const Part& part : cell.parts) {
      parts.push_back({part.name, part.shapes, part.on.empty() ? kOnFlange : part.on, part.at});
    }
    const auto bare = RobotBodies::fromUrdf(arm::ArmModel::urdfOf(robot.model), robot.base, robot.tool);
    return bodies_.emplace(carried, bare->carrying(PartTree::of(parts)->bodiesOf(carried))).first->second;
  }

  std::map<std::set<std::string>, RobotBodies> bodies_;
};

Cell randomCell(std::uint64_t seed) {
  Cell cell = RandomProgram(seed, 2 + static_cast<int>(seed % 6)).cell;
  Dice dice(seed);
  cell.parameters.margin = 0.0;
  cell.parameters.tracking = 0.0;
  cell.parameters.voxel = dice.coin() ? 0.02 : 0.03;
  cell.parameters.step_bound = dice.coin() ? 0.02 : 0.04;
  return cell;
}

TEST(TheClaimOfAPath, hasEveryBodyWheneverFramesAreSentAndAtAnyProjectSpeed) {
  const unsigned programs =
      testing::fromEnvironment("COBOT_CELL_PROGRAMS", testing::quickOrThorough(60U, 10000U));
  const int samples = testing::quickOrThorough(60, 250);
  for (unsigned seed = 1; seed <= programs; ++seed) {
    Claimed claimed(randomCell(seed));
    Dice dice(seed + 1000000);
    for (const auto speed : {ProjectSpeed::Constant, ProjectSpeed::Changing}) {
      for (int run = 0; run < 4; ++run) claimed.sample(speed, samples, dice);
      EXPECT_EQ(claimed.postures_outside, 0)
          << "program " << seed << (speed == ProjectSpeed::Constant ? ", one" : ", changing")
          << " project speed, " << claimed.first;
      EXPECT_EQ(claimed.points_outside, 0) << "program " << seed;
      EXPECT_EQ(claimed.unclaimed, 0) << "program " << seed << " of " << claimed.points;
    }
  }
}

/// In a voxel of 5 mm that no body of a piece reaches with half of what it may move.
bool isOutsideOfHalf(const ArmPosture& posture, const PlacedRobot& placed, const Eigen::Vector3d& point) {
  constexpr double kEdge = 0.005;
  const Voxel voxel = voxelAt(point, kEdge);
  const Eigen::Vector3d lower = kEdge * Eigen::Vector3d(voxel[0], voxel[1], voxel[2]);
  const AlignedBox cube{lower, lower + Eigen::Vector3d::Constant(kEdge)};
  for (std::size_t body = 0; body < placed.capsules.size(); ++body) {
    const Capsule& capsule = placed.capsules[body];
    const double displacement = displacementBound(capsule, posture.bodies->bodies()[body].link, placed.axes,
                                                  0.5 * posture.range.widths());
    if (coreDistance(capsule, cube) <= capsule.radius + 0.5 * displacement) return false;
  }
  return true;
}

/// Points of bodies at the beginning of a piece, on the side to which they are away from its centre.
int outsideOfHalf(const Piece& piece, const arm::JointVector& joints) {
  const auto& posture = std::get<ArmPosture>(piece.posture);
  const PlacedRobot centre = posture.bodies->at(posture.range.centre());
  const PlacedRobot moved = posture.bodies->at(joints);
  int outside = 0;
  for (std::size_t body = 0; body < centre.capsules.size(); ++body) {
    const Eigen::Vector3d way = moved.capsules[body].to - centre.capsules[body].to;
    const Eigen::Vector3d point = moved.capsules[body].to + moved.capsules[body].radius * way.normalized();
    if (isOutsideOfHalf(posture, centre, point)) ++outside;
  }
  return outside;
}

TEST(TheClaimOfAPath, wouldBeTooSmallWithHalfOfTheBound) {
  int outside = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    Cell cell = randomCell(seed);
    cell.parameters.step_bound = 0.05;
    const Claimed claimed(std::move(cell));
    const auto& frames = claimed.planned.front().paths.front().frames;
    for (const Piece& piece : claimed.pieces()) {
      if (piece.kind != Piece::Kind::Motion) continue;
      const auto& trajectory = frames[piece.frame].motions[piece.motion].trajectory;
      outside += outsideOfHalf(piece, trajectory->at(piece.from).position);
    }
  }
  EXPECT_GT(outside, 0);
}

}  // namespace
}  // namespace cobot_command::cell
