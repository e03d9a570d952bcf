#include "cobot_command/cell/claims/claims.h"

#include <atomic>
#include <cmath>
#include <optional>
#include <thread>

#include "claims/bodies_of_robot.h"
#include "claims/mechanism_sweep.h"
#include "claims/sweep.h"

#include "cobot_command/common/overloaded.h"

namespace cobot_command::cell {
namespace {

/// What rounding could do to a claim [m].
constexpr double kRoundingRoom = 1e-6;

struct Claimed {
  RobotClaim claim;
  std::vector<Fault> faults;
};

std::vector<Fault> badBodies(const Robot& robot, const std::string& why) {
  return {{robot.place.file, robot.place.line, robot.place.column, "robots." + robot.name, why, "", ""}};
}

Claimed claimRobotOf(const Cell& cell, const Robot& robot, const PlannedRobot& planned) {
  auto bodies = BodiesOfRobot::of(cell, robot);
  if (!bodies) return {{}, badBodies(robot, bodies.error())};
  Sweep sweep(cell, robot, planned, std::move(*bodies));
  RobotClaim claim = sweep.claim();
  return {std::move(claim), sweep.faults()};
}

Claimed claimMechanismOf(const Cell& cell, const Mechanism& mechanism) {
  auto claim = claimMechanism(cell.parameters, mechanism);
  if (claim) return {std::move(*claim), {}};
  return {{},
          {{mechanism.place.file, mechanism.place.line, mechanism.place.column,
            "mechanisms." + mechanism.name, claim.error(), "", ""}}};
}

}  // namespace

Capsules Piece::capsulesAtCentre() const {
  return std::visit(
      Overloaded{[](const ArmPosture& arm) { return arm.bodies->at(arm.range.centre()).capsules; },
                 [](const AxisPosture& axis) { return axis.bodies->at(axis.centre()); }},
      posture);
}

std::size_t RobotClaim::pieces() const {
  std::size_t count = stations.size();
  for (const PathClaim& path : paths) count += path.pieces.size();
  return count;
}

double clearanceOf(const Parameters& parameters) {
  return parameters.body_tolerance + 0.5 * parameters.margin + kRoundingRoom;
}

Result<std::vector<RobotClaim>, std::vector<Fault>> claimCell(const Cell& cell,
                                                              const std::vector<PlannedRobot>& robots,
                                                              unsigned threads) {
  std::vector<Claimed> claimed(robots.size() + cell.mechanisms.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t one = next++; one < claimed.size(); one = next++) {
      claimed[one] = one < robots.size() ? claimRobotOf(cell, cell.robots[one], robots[one])
                                         : claimMechanismOf(cell, cell.mechanisms[one - robots.size()]);
    }
  };
  std::vector<std::thread> others;
  for (unsigned thread = 1; thread < threads; ++thread) others.emplace_back(work);
  work();
  for (std::thread& thread : others) thread.join();

  std::vector<Fault> faults;
  std::vector<RobotClaim> claims;
  for (Claimed& one : claimed) {
    faults.insert(faults.end(), one.faults.begin(), one.faults.end());
    claims.push_back(std::move(one.claim));
  }
  if (!faults.empty()) return refuse(faults);
  return claims;
}

Result<PathClaim, std::vector<Fault>> claimPath(const Cell& cell, const Robot& robot,
                                                const PlannedRobot& planned, std::size_t path) {
  auto bodies = BodiesOfRobot::of(cell, robot);
  if (!bodies) return refuse(badBodies(robot, bodies.error()));
  Sweep sweep(cell, robot, planned, std::move(*bodies));
  PathClaim claim = sweep.claimPath(path);
  if (!sweep.faults().empty()) return refuse(sweep.faults());
  return claim;
}

double claimError(const Parameters& parameters) {
  // R - r, with the displacement once more for a body that is elsewhere in its piece; what tracking adds is
  // not counted, as a robot may be there.
  return 2.0 * parameters.step_bound + parameters.body_tolerance + 0.5 * parameters.margin +
         std::sqrt(3.0) * parameters.voxel;
}

}  // namespace cobot_command::cell
