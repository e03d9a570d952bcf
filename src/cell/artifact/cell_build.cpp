#include "cobot_command/cell/artifact/cell_build.h"

#include <algorithm>
#include <utility>

#include "artifact/carried_bodies.h"
#include <fmt/format.h>

#include "cobot_command/cell/claims/cell_bodies.h"
#include "cobot_command/cell/program/canonical.h"
#include "cobot_command/common/units.h"

namespace cobot_command::cell {
namespace {

using Faults = std::vector<std::string>;

Faults described(const std::vector<Fault>& faults) {
  Faults texts;
  for (const Fault& fault : faults) texts.push_back(describe(fault));
  return texts;
}

}  // namespace

const char* toString(BuildStage stage) {
  constexpr const char* kNames[] = {"plan",      "sweep",      "zones",      "split",
                                    "soundness", "instrument", "synthesize", "verify"};
  return kNames[static_cast<std::size_t>(stage)];
}

CellBuild::CellBuild(Cell cell, Policy policy, unsigned threads)
    : cell_(std::move(cell)), hash_(hashOf(cell_)), policy_(policy), threads_(threads) {}

Faults CellBuild::run(BuildStage stage) {
  switch (stage) {
    case BuildStage::Plan:
      return plan();
    case BuildStage::Sweep:
      return sweep();
    case BuildStage::Zones:
      return findZonesAndHolds();
    case BuildStage::Split:
      return split();
    case BuildStage::Soundness:
      soundness_ = checkSoundness(cell_, claims_, held_);
      return soundness_.faults;
    case BuildStage::Instrument: {
      auto model = modelOf(held_.program);
      if (!model) return model.error();
      model_ = std::move(*model);
      return {};
    }
    case BuildStage::Synthesize:
      return synthesize();
    case BuildStage::Verify:
      return verify();
  }
  return {};
}

Faults CellBuild::plan() {
  auto planned = planCell(cell_);
  if (!planned) return described(planned.error());
  planned_ = std::move(*planned);
  return {};
}

Faults CellBuild::sweep() {
  auto claims = claimCell(cell_, planned_, threads_);
  if (!claims) return described(claims.error());
  claims_ = std::move(*claims);
  return {};
}

Faults CellBuild::findZonesAndHolds() {
  auto zones = findZones(claims_, cell_.parameters);
  if (!zones) return {zones.error()};
  zones_ = std::move(*zones);
  auto held = holdZones(cell_, planned_, claims_, zones_);
  if (!held) return held.error();
  held_ = std::move(*held);
  return {};
}

Faults CellBuild::split() {
  auto split = splitCell(
      {std::move(cell_), {}, std::move(planned_), std::move(claims_), std::move(zones_), std::move(held_)},
      threads_);
  if (!split) return split.error();
  cell_ = std::move(split->cell);
  planned_ = std::move(split->planned);
  claims_ = std::move(split->claims);
  zones_ = std::move(split->zones);
  held_ = std::move(split->held);
  cuts_ = std::move(split->cuts);
  return {};
}

Faults CellBuild::synthesize() {
  auto supervisors = synthesizeParts(model_, policy_, static_cast<std::size_t>(cell_.parameters.max_states));
  if (!supervisors) return {supervisors.error()};
  supervisors_ = std::move(*supervisors);
  bytes_ = toBytes(artifact());
  return {};
}

/// Of the bytes, as who runs them would read them: whatever was lost on the way is found here.
Faults CellBuild::verify() {
  const auto again = fromBytes(bytes_);
  if (!again) return {again.error()};
  const auto model = modelOf(again->program);
  if (!model) return model.error();
  verified_ = verifyParts(*model, again->supervisors, static_cast<std::size_t>(cell_.parameters.max_states));
  Faults faults;
  for (const auto& part : verified_) faults.insert(faults.end(), part.faults.begin(), part.faults.end());
  if (toBytes(*again) != bytes_) {
    faults.emplace_back("the artifact changes when it is read and written again");
  }
  return faults;
}

Artifact CellBuild::artifact() const {
  Artifact artifact;
  artifact.hash = hash_;
  artifact.parameters = cell_.parameters;
  artifact.program = held_.program;
  artifact.zones = zones_;
  artifact.policy = policy_;
  artifact.supervisors = supervisors_;
  artifact.least_distance = soundness_.least;
  artifact.source = cell_.source;
  for (RobotIndex robot = 0; robot < planned_.size(); ++robot) artifact.robots.push_back(robotOf(robot));
  for (std::size_t index = 0; index < cell_.mechanisms.size(); ++index) {
    artifact.mechanisms.push_back(mechanismOf(cell_.mechanisms[index], planned_.size() + index));
  }
  return artifact;
}

ArtifactRobot CellBuild::robotOf(RobotIndex robot) const {
  ArtifactRobot of_robot;
  of_robot.model = cell_.robots[robot].model;
  of_robot.name_space = cell_.robots[robot].name_space;
  of_robot.base = cell_.robots[robot].base;
  of_robot.tool = toolOf(cell_, cell_.robots[robot]);
  of_robot.parts = partsOf(cell_, planned_[robot]);
  for (std::size_t station = 0; station < planned_[robot].stations.size(); ++station) {
    const PlannedStation& planned = planned_[robot].stations[station];
    of_robot.stations.push_back({planned.joints,
                                 held_.robots[robot].at_stations[station],
                                 {planned.carried.begin(), planned.carried.end()}});
  }
  for (std::size_t path = 0; path < planned_[robot].paths.size(); ++path) {
    of_robot.paths.push_back(pathOf(robot, path));
  }
  return of_robot;
}

std::vector<ZoneIndex> CellBuild::touchedBy(const Piece& piece, RobotIndex user) const {
  std::vector<ZoneIndex> touched;
  for (ZoneIndex zone = 0; zone < zones_.size(); ++zone) {
    const auto& users = zones_[zone].users;
    const bool is_user = std::find(users.begin(), users.end(), user) != users.end();
    if (is_user && piece.claim.touches(zones_[zone].voxels)) touched.push_back(zone);
  }
  return touched;
}

ArtifactMechanism CellBuild::mechanismOf(const Mechanism& mechanism, RobotIndex user) const {
  ArtifactMechanism artifact;
  artifact.bodies = *mechanismBodiesOf(cell_.parameters, mechanism);
  const std::vector<MechanismPosition> stations = stationsOf(mechanism);
  for (std::size_t station = 0; station < stations.size(); ++station) {
    artifact.stations.push_back({stations[station].value, held_.robots[user].at_stations[station]});
  }
  for (std::size_t index = 0; index < mechanism.program.size(); ++index) {
    ArtifactMechanismPath& path = artifact.paths.emplace_back();
    path.holds = held_.robots[user].paths[index].holds;
    path.places = held_.robots[user].paths[index].places;
    const double seconds = mechanism.program[index].duration;
    if (seconds > 0.0) path.duration = fromSeconds(seconds);
    for (const Piece& piece : claims_[user].paths[index].pieces) {
      const auto& axis = std::get<AxisPosture>(piece.posture);
      path.pieces.push_back({axis.from, axis.to, touchedBy(piece, user)});
    }
  }
  return artifact;
}

ArtifactPath CellBuild::pathOf(RobotIndex robot, std::size_t index) const {
  const PlannedPath& planned = planned_[robot].paths[index];
  ArtifactPath path;
  path.holds = held_.robots[robot].paths[index].holds;
  path.places = held_.robots[robot].paths[index].places;
  path.duration = planned.duration;
  for (const PlannedFrame& frame : planned.frames) {
    ArtifactFrame& of_path = path.frames.emplace_back();
    of_path.step = frame.step;
    of_path.lines = frame.lines;
    of_path.stands = frame.stands;
    of_path.carried.assign(frame.carried.begin(), frame.carried.end());
    const Step& step = cell_.robots[robot].program[index].steps[frame.step];
    of_path.output = step.output;
    of_path.input = step.input;
    of_path.dwell = frame.dwell;
    of_path.begin = frame.begin;
    of_path.end = frame.end;
    if (frame.motions.empty()) continue;
    of_path.start = frame.motions.front().trajectory->at(Duration::zero()).position;
    of_path.base = frame.motions.front().base;
    of_path.tcp = frame.motions.front().tcp;
  }
  for (const Piece& piece : claims_[robot].paths[index].pieces) {
    path.pieces.push_back({piece.kind, piece.frame, piece.motion, piece.from, piece.to,
                           std::get<ArmPosture>(piece.posture).range, touchedBy(piece, robot)});
  }
  return path;
}

}  // namespace cobot_command::cell
