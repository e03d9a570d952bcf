#include "cobot_command/cell/claims/claims.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <thread>

#include "claims/bodies_of_robot.h"
#include "claims/mechanism_sweep.h"
#include "claims/piece_claim.h"
#include "claims/sweep.h"
#include <fmt/format.h>

#include "cobot_command/common/overloaded.h"
#include "cobot_command/common/units.h"

namespace cobot_command::cell {
namespace {

/// Of so many pieces one is claimed to see how much memory all would take.
constexpr std::size_t kSampled = 32;

struct Claimed {
  RobotClaim claim;
  std::vector<Fault> faults;
};

std::vector<Fault> badBodies(const Robot& robot, const std::string& why) {
  return {{robot.place.file, robot.place.line, robot.place.column, "robots." + robot.name, why, "", ""}};
}

Claimed piecesOfRobot(const Cell& cell, const Robot& robot, const PlannedRobot& planned) {
  auto bodies = BodiesOfRobot::of(cell, robot);
  if (!bodies) return {{}, badBodies(robot, bodies.error())};
  Sweep sweep(cell, robot, planned, std::move(*bodies));
  RobotClaim claim = sweep.pieces();
  return {std::move(claim), sweep.faults()};
}

Claimed piecesOfMechanismIn(const Cell& cell, const Mechanism& mechanism) {
  auto claim = piecesOfMechanism(cell.parameters, mechanism);
  if (claim) return {std::move(*claim), {}};
  return {{},
          {{mechanism.place.file, mechanism.place.line, mechanism.place.column,
            "mechanisms." + mechanism.name, claim.error(), "", ""}}};
}

template <class Visitor>
void forEachPiece(RobotClaim& claim, const Visitor& visit) {
  for (Piece& piece : claim.stations) visit(piece);
  for (PathClaim& path : claim.paths) {
    for (Piece& piece : path.pieces) visit(piece);
  }
}

/// What its claims will take [bytes].
double expectedMemory(RobotClaim& claim, const Parameters& parameters) {
  std::size_t count = 0;
  std::size_t sampled = 0;
  std::size_t memory = 0;
  forEachPiece(claim, [&](const Piece& piece) {
    if (count++ % kSampled != 0) return;
    ++sampled;
    memory += claimOf(piece, parameters).memory();
  });
  return static_cast<double>(memory) * static_cast<double>(count) /
         static_cast<double>(std::max<std::size_t>(1, sampled));
}

void claimAll(RobotClaim& claim, const Parameters& parameters) {
  forEachPiece(claim, [&](Piece& piece) {
    piece.claim = claimOf(piece, parameters);
    claim.all |= piece.claim;
  });
}

/// Does it for each of so many, side by side.
void sideBySide(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& task) {
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t one = next++; one < count; one = next++) task(one);
  };
  std::vector<std::thread> others;
  for (unsigned thread = 1; thread < std::min<std::size_t>(threads, count); ++thread) {
    others.emplace_back(work);
  }
  work();
  for (std::thread& thread : others) thread.join();
}

/// What is wrong where they are too large to be made.
std::optional<Fault> tooLarge(const Cell& cell, std::size_t pieces, double memory) {
  constexpr double kMiB = 1048576.0;
  const double times = memory / static_cast<double>(kMostClaimMemory);
  if (times <= 1.0) return std::nullopt;
  // Pieces are as many as they are short; voxels go with the surface at least.
  const double bound = std::ceil(mToMm(cell.parameters.step_bound) * times);
  const double voxel = std::ceil(mToMm(cell.parameters.voxel) * std::sqrt(times));
  const std::string file = cell.robots.empty() ? "" : cell.robots.front().place.file;
  return Fault{
      file,
      0,
      0,
      "parameters",
      fmt::format("make claims of {:.0f} MiB: {} pieces with step_bound {:g} mm, in voxels of {:g} mm",
                  memory / kMiB, pieces, mToMm(cell.parameters.step_bound), mToMm(cell.parameters.voxel)),
      fmt::format("{:.0f} MiB", static_cast<double>(kMostClaimMemory) / kMiB),
      fmt::format("make one of them larger: step_bound {:.0f} mm or voxel {:.0f} mm is sufficient", bound,
                  voxel)};
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

Result<std::vector<RobotClaim>, std::vector<Fault>> claimCell(const Cell& cell,
                                                              const std::vector<PlannedRobot>& robots,
                                                              unsigned threads) {
  std::vector<Claimed> claimed(robots.size() + cell.mechanisms.size());
  std::vector<double> memory(claimed.size());
  sideBySide(claimed.size(), threads, [&](std::size_t one) {
    claimed[one] = one < robots.size() ? piecesOfRobot(cell, cell.robots[one], robots[one])
                                       : piecesOfMechanismIn(cell, cell.mechanisms[one - robots.size()]);
    memory[one] = expectedMemory(claimed[one].claim, cell.parameters);
  });
  std::vector<Fault> faults;
  std::vector<RobotClaim> claims;
  std::size_t pieces = 0;
  for (Claimed& one : claimed) {
    faults.insert(faults.end(), one.faults.begin(), one.faults.end());
    pieces += one.claim.pieces();
    claims.push_back(std::move(one.claim));
  }
  if (!faults.empty()) return refuse(faults);
  if (auto fault = tooLarge(cell, pieces, std::accumulate(memory.begin(), memory.end(), 0.0))) {
    return refuse(std::vector<Fault>{*std::move(fault)});
  }
  sideBySide(claims.size(), threads, [&](std::size_t one) { claimAll(claims[one], cell.parameters); });
  return claims;
}

Result<PathClaim, std::vector<Fault>> claimPath(const Cell& cell, const Robot& robot,
                                                const PlannedRobot& planned, std::size_t path) {
  auto bodies = BodiesOfRobot::of(cell, robot);
  if (!bodies) return refuse(badBodies(robot, bodies.error()));
  Sweep sweep(cell, robot, planned, std::move(*bodies));
  PathClaim claim = sweep.piecesOf(path);
  if (!sweep.faults().empty()) return refuse(sweep.faults());
  for (Piece& piece : claim.pieces) piece.claim = claimOf(piece, cell.parameters);
  return claim;
}

double claimError(const Parameters& parameters) {
  // R - r, with the displacement once more for a body that is elsewhere in its piece; what tracking adds is
  // not counted, as a robot may be there.
  return 2.0 * parameters.step_bound + parameters.body_tolerance + 0.5 * parameters.margin +
         std::sqrt(3.0) * parameters.voxel;
}

}  // namespace cobot_command::cell
