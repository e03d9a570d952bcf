#include "splitting/stages.h"

#include <utility>

namespace cobot_command::cell {
namespace {

std::vector<std::string> sentencesOf(const std::vector<Fault>& faults) {
  std::vector<std::string> sentences;
  sentences.reserve(faults.size());
  for (const Fault& fault : faults) sentences.push_back(describe(fault));
  return sentences;
}

Robot robotWith(const PathIn& where, const std::vector<Step>& steps) {
  Robot robot = where.stages.cell.robots[where.robot];
  robot.program[where.path].steps = steps;
  return robot;
}

}  // namespace

Result<SplitCell, std::vector<std::string>> stagesOf(const Cell& cell, unsigned threads) {
  SplitCell stages;
  stages.cell = cell;
  auto planned = planCell(cell);
  if (!planned) return refuse(sentencesOf(planned.error()));
  stages.planned = std::move(*planned);
  auto claims = claimCell(cell, stages.planned, threads);
  if (!claims) return refuse(sentencesOf(claims.error()));
  stages.claims = std::move(*claims);
  auto faults = findHolds(stages);
  if (!faults.empty()) return refuse(std::move(faults));
  return stages;
}

std::vector<std::string> findHolds(SplitCell& stages) {
  auto zones = findZones(stages.claims, stages.cell.parameters);
  if (!zones) return {zones.error()};
  stages.zones = std::move(*zones);
  auto held = holdZones(stages.cell, stages.planned, stages.claims, stages.zones);
  if (!held) return held.error();
  stages.held = std::move(*held);
  return {};
}

std::optional<PlannedRobot> planWith(const PathIn& where, const std::vector<Step>& steps) {
  Cell alone;
  alone.parameters = where.stages.cell.parameters;
  alone.robots.push_back(robotWith(where, steps));
  auto planned = planCell(alone);
  if (!planned) return std::nullopt;
  return std::move(planned->front());
}

std::optional<PathClaim> claimWith(const PathIn& where, const std::vector<Step>& steps,
                                   const PlannedRobot& planned) {
  auto claim = claimPath(where.stages.cell, robotWith(where, steps), planned, where.path);
  if (!claim) return std::nullopt;
  return std::move(*claim);
}

void takeOver(SplitCell& stages, RobotIndex robot, std::size_t path, std::vector<Step> steps,
              PathStages following) {
  stages.cell.robots[robot].program[path].steps = std::move(steps);
  stages.planned[robot].paths[path] = std::move(following.planned);
  RobotClaim& claim = stages.claims[robot];
  claim.paths[path] = std::move(following.claim);
  claim.all.clear();
  for (const Piece& piece : claim.stations) claim.all |= piece.claim;
  for (const PathClaim& of_path : claim.paths) {
    for (const Piece& piece : of_path.pieces) claim.all |= piece.claim;
  }
}

}  // namespace cobot_command::cell
