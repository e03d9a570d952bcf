// What a robot carries is claimed with it, however it hangs on it (oracle 29).
#include "random_program.h"
#include "zoned_cell.h"
#include <gmock/gmock.h>

#include "cobot_command/arm/forward_kinematics.h"

namespace cobot_command::cell {
namespace {

/// 400 x 300 x 5 mm.
Part sheetOn(const std::string& on, const Eigen::Vector3d& at) {
  Part sheet;
  sheet.name = "sheet";
  sheet.on = on;
  sheet.shapes = {{BoxShape{{0.400, 0.300, 0.005}}, arm::Pose::Identity()}};
  sheet.at.translation() = at;
  sheet.at.rotate(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY()));
  return sheet;
}
Part hook() {
  Part hook;
  hook.name = "hook";
  hook.shapes = {{CapsuleShape{{0, 0, 0}, {0, 0, 0.1}, 0.01}, arm::Pose::Identity()}};
  hook.at.translation() = Eigen::Vector3d(0.1, 0.0, 0.12);
  hook.at.rotate(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()));
  return hook;
}

/// A point in the space of its own, of a PTP to these joints; at its end that is attached.
Step ptpTo(const blocks::SixValues& joints, const std::string& attach) {
  blocks::MoveAbsoluteGoal goal;
  goal.movement_command = static_cast<int>(blocks::Movement::Ptp);
  goal.data_format = static_cast<int>(blocks::AbsoluteFormat::Jpp);
  goal.target = joints;
  goal.speed = 30;
  goal.accel_time = 300;
  Step step;
  step.goal = goal;
  step.attach = attach;
  return step;
}

/// The robot takes the parts one after the other, and goes home with them.
Cell carrying(const std::vector<Part>& parts, const std::vector<std::string>& attached) {
  Cell cell = cellOfOne(arm::toJointVector({0, -30, 120, 0, 90, 0}));
  cell.parts = parts;
  auto& steps = cell.robots.front().program.front().steps;
  for (std::size_t i = 0; i < 2; ++i) {
    steps.push_back(ptpTo({20.0 + 10.0 * static_cast<double>(i), -10, 100, -10, 80, 20},
                          i < attached.size() ? attached[i] : ""));
  }
  steps.push_back(ptpTo({-40, 20, 80, 10, 60, -50}, ""));
  steps.push_back(ptpTo({0, -30, 120, 0, 90, 0}, ""));
  return cell;
}

/// Corners of the sheet, seen from the flange.
std::vector<Eigen::Vector3d> cornersOf(const arm::Pose& sheet) {
  std::vector<Eigen::Vector3d> corners;
  corners.reserve(8);
  for (int i = 0; i < 8; ++i) {
    corners.push_back(sheet * Eigen::Vector3d((i & 1) != 0 ? 0.2 : -0.2, (i & 2) != 0 ? 0.15 : -0.15,
                                              (i & 4) != 0 ? 0.0025 : -0.0025));
  }
  return corners;
}

/// How many corners of the sheet are outside of the claim.
int cornersOutside(const VoxelSet& claim, const Cell& cell, const arm::Pose& flange, const arm::Pose& sheet) {
  int outside = 0;
  for (const Eigen::Vector3d& corner : cornersOf(sheet)) {
    if (!claim.contains(voxelAt(flange * corner, cell.parameters.voxel))) ++outside;
  }
  return outside;
}

/// The same for the pieces of each moment, at 200 moments of each motion with it, and for the rests behind
/// these and before the first of them, where it is taken.
int cornersOutside(const Cell& cell, const std::vector<PlannedRobot>& planned,
                   const std::vector<RobotClaim>& claims, const arm::Pose& sheet, std::size_t first_frame) {
  const auto& frames = planned.front().paths.front().frames;
  const auto& pieces = claims.front().paths.front().pieces;
  const auto flange_at = [&](const motion::Trajectory& trajectory, Duration time) -> arm::Pose {
    return cell.robots.front().base *
           arm::forwardKinematics(planned.front().arm, trajectory.at(time).position);
  };
  int outside = 0;
  for (std::size_t frame = first_frame - 1; frame < frames.size(); ++frame) {
    const motion::Trajectory& trajectory = *frames[frame].motions.front().trajectory;
    VoxelSet rests;
    for (const Piece& piece : pieces) {
      if (piece.frame == frame && piece.kind == Piece::Kind::Rest) rests |= piece.claim;
    }
    outside += cornersOutside(rests, cell, flange_at(trajectory, trajectory.duration()), sheet);
    for (int i = 0; frame >= first_frame && i <= 200; ++i) {
      const Duration time = trajectory.duration() * i / 200;
      for (const Piece& piece : pieces) {
        const bool is_then = piece.frame == frame && piece.kind == Piece::Kind::Motion &&
                             piece.from <= time && time <= piece.to;
        if (is_then) outside += cornersOutside(piece.claim, cell, flange_at(trajectory, time), sheet);
      }
    }
  }
  return outside;
}

struct Claimed {
  explicit Claimed(const Cell& cell)
      : planned(orThrow(planCell(cell))), claims(orThrow(claimCell(cell, planned))) {}

  [[nodiscard]] const VoxelSet& all() const { return claims.front().all; }

  std::vector<PlannedRobot> planned;
  std::vector<RobotClaim> claims;
};

TEST(ASheetOnTheGripper, isInTheClaimAtEachMoment) {
  const Part sheet = sheetOn("", {0, 0, 0.125});
  const Cell cell = carrying({sheet}, {"sheet"});
  const Claimed with(cell);
  const Claimed without(carrying({sheet}, {}));
  EXPECT_GT(with.all().count(), without.all().count());
  EXPECT_EQ(cornersOutside(cell, with.planned, with.claims, sheet.at, 1), 0);
  EXPECT_GT(cornersOutside(cell, without.planned, without.claims, sheet.at, 1), 0)
      << "else this finds nothing";
}

TEST(ASheetOnAPartThatHangsOnTheGripper, isInTheClaimAtEachMoment) {
  const Part sheet = sheetOn("hook", {0.05, 0, 0.11});
  const Cell cell = carrying({hook(), sheet}, {"hook", "sheet"});
  const Claimed with(cell);
  const Claimed without(carrying({hook(), sheet}, {"hook"}));
  EXPECT_GT(with.all().count(), without.all().count());
  const arm::Pose at = hook().at * sheet.at;
  EXPECT_EQ(cornersOutside(cell, with.planned, with.claims, at, 2), 0);
  EXPECT_GT(cornersOutside(cell, without.planned, without.claims, at, 2), 0) << "else this finds nothing";
}

/// A gripper with two hands takes one before it sets down the other.
TEST(AStepThatTakesOnePartAndSetsDownAnother, isClaimedWithBoth) {
  const Part sheet = sheetOn("", {0, 0, 0.125});
  Cell cell = carrying({hook(), sheet}, {"hook", "sheet"});
  cell.robots.front().program.front().steps[1].detach = "hook";
  const Claimed claimed(cell);
  std::size_t most = 0;
  for (const Piece& piece : claimed.claims.front().paths.front().pieces) {
    if (piece.frame != 1 || piece.kind != Piece::Kind::Rest) continue;
    std::set<std::string> names;
    for (const Body& body : std::get<ArmPosture>(piece.posture).bodies->bodies()) names.insert(body.name);
    most = std::max(most, names.count("hook") + names.count("sheet"));
  }
  EXPECT_EQ(most, 2U);
}

}  // namespace
}  // namespace cobot_command::cell
