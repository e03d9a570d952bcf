// A robot that goes a line there and back is let into a zone no deeper than it lets it go (oracle 30: a
// thousand of them).
#include <cmath>

#include "random_program.h"
#include "zoned_cell.h"
#include <gtest/gtest.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"

namespace cobot_command::cell {
namespace {

const arm::ArmModel& model() {
  static const arm::ArmModel kModel = *arm::ArmModel::named("tm5-900");
  return kModel;
}

Step lineTo(const arm::Pose& pose) {
  blocks::MoveAbsoluteGoal goal;
  goal.movement_command = static_cast<int>(blocks::Movement::Line);
  goal.data_format = static_cast<int>(blocks::AbsoluteFormat::Cpr);
  goal.target = arm::toControllerPose(pose);
  goal.speed = 30;
  goal.accel_time = 300;
  Step step;
  step.goal = goal;
  return step;
}

/// Nothing: there is no such line.
std::optional<Cell> thereAndBack(Dice& dice) {
  const arm::JointVector home = arm::toJointVector({0, 10, 90, -10, 90, 0}) + dice.joints(0.5);
  Cell cell = cellOfOne(home);
  cell.parts.clear();
  cell.parameters.margin = 0.0;
  cell.parameters.voxel = 0.05;
  cell.parameters.step_bound = 0.04;
  const arm::Pose start = arm::forwardKinematics(model(), cell.robots.front().stations.front().joints);
  arm::Pose end = start;
  end.translation() += 0.3 * dice.joints(1).head<3>().normalized();
  cell.robots.front().program.front().steps = {lineTo(end), lineTo(start)};
  return cell;
}

/// Where on the way out the flange is, from the start [m].
double wayAt(const PlannedRobot& robot, std::size_t frame, Duration time) {
  const auto& frames = robot.paths.front().frames;
  const auto at = [&](std::size_t of, Duration when) -> Eigen::Vector3d {
    return arm::forwardKinematics(model(), frames[of].motions.front().trajectory->at(when).position)
        .translation();
  };
  return (at(frame, time) - at(0, Duration::zero())).norm();
}

/// Where on the way back the program lets the zone go.
double exitOf(const Cell& cell, const std::vector<PlannedRobot>& planned,
              const std::vector<RobotClaim>& claims, const VoxelSet& zone) {
  const HeldCell held = orThrow(holdZones(cell, planned, claims, {Zone{"Z1", {0}, zone}}));
  const auto& holds = held.robots.front().paths.front().holds;
  if (holds.size() != 1 || !holds.front().last_piece) throw std::runtime_error("there is not one hold");
  const Piece& last = claims.front().paths.front().pieces[*holds.front().last_piece];
  return wayAt(planned.front(), last.frame, last.to);
}

TEST(RandomLinesThereAndBack, areEnteredNoDeeperThanTheyAreLeft) {
  constexpr unsigned kLines = 1000;
  Dice dice(30);
  unsigned found = 0;
  double deepest = 0.0;
  for (unsigned tries = 0; found < kLines && tries < 20 * kLines; ++tries) {
    const auto cell = thereAndBack(dice);
    const auto planned = planCell(*cell);
    if (!planned) continue;
    const auto claims = claimCell(*cell, *planned);
    if (!claims) continue;
    const auto& pieces = claims->front().paths.front().pieces;
    // A zone that it reaches only at the end of the line.
    VoxelSet zone;
    for (const Piece& piece : pieces) {
      if (piece.frame == 0 && piece.kind == Piece::Kind::Rest) zone |= piece.claim;
    }
    zone -= claims->front().stations.front().claim;
    const double share = dice.within(0.3, 0.9);
    for (const Piece& piece : pieces) {
      const bool is_early = piece.frame == 0 && piece.kind == Piece::Kind::Motion &&
                            wayAt(planned->front(), 0, piece.to) < share * 0.3;
      if (is_early) zone -= piece.claim;
    }
    if (zone.empty()) continue;
    std::optional<double> entry;
    std::optional<double> exit;
    for (const Piece& piece : pieces) {
      if (piece.kind != Piece::Kind::Motion || !piece.claim.touches(zone)) continue;
      if (piece.frame == 0 && !entry) entry = wayAt(planned->front(), 0, piece.from);
      if (piece.frame == 1) exit = wayAt(planned->front(), 1, piece.to);
    }
    if (!entry || !exit) continue;
    ++found;
    EXPECT_EQ(exitOf(*cell, *planned, *claims, zone), *exit) << "line " << tries;
    deepest = std::max(deepest, *entry - *exit);
    EXPECT_LE(*entry, *exit + 1e-6) << "line " << tries;
  }
  EXPECT_EQ(found, kLines);
  RecordProperty("deepest_mm", std::to_string(1000 * deepest));
}

}  // namespace
}  // namespace cobot_command::cell
