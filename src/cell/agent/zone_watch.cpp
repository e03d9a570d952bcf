#include "agent/zone_watch.h"

#include <algorithm>

#include "cobot_command/cell/sweep/capsule_claim.h"

namespace cobot_command::cell {
namespace {

/// As in claims.
constexpr double kRoundingRoom = 1e-6;

}  // namespace

Result<ZoneWatch, std::string> ZoneWatch::of(const Artifact& artifact, RobotIndex robot) {
  const ArtifactRobot& made = artifact.robots[robot];
  const auto known = arm::ArmModel::knownNames();
  if (std::find(known.begin(), known.end(), made.model) == known.end()) {
    return refuse("the artifact has a robot of the model " + made.model + ", which is unknown here");
  }
  auto bare =
      RobotBodies::fromUrdf(arm::ArmModel::urdfOf(made.model), made.base, {}, artifact.parameters.body_cell);
  if (!bare) return refuse(bare.error().message);
  return ZoneWatch(artifact, robot, bare->carrying(made.tool));
}

ZoneWatch::ZoneWatch(const Artifact& artifact, RobotIndex robot, RobotBodies bare)
    : artifact_(&artifact), robot_(robot), bare_(std::move(bare)) {
  const double edge = artifact.parameters.voxel;
  for (const auto& zone : artifact.zones) {
    const auto bounds = zone.voxels.bounds();
    boxes_.push_back(bounds ? std::optional(AlignedBox{cubeOf(bounds->lower, edge).lower,
                                                       cubeOf(bounds->upper, edge).upper})
                            : std::nullopt);
  }
}

const RobotBodies& ZoneWatch::carrying(const std::vector<std::string>& parts) {
  if (parts.empty()) return bare_;
  const auto known = known_.find(parts);
  if (known != known_.end()) return known->second;
  std::vector<FlangeCapsules> carried;
  for (const FlangeCapsules& part : artifact_->robots[robot_].parts) {
    if (std::find(parts.begin(), parts.end(), part.name) != parts.end()) carried.push_back(part);
  }
  return known_.emplace(parts, bare_.carrying(carried)).first->second;
}

void ZoneWatch::see(const arm::JointVector& joints, const std::vector<std::string>& carried, Of of) {
  const Parameters& parameters = artifact_->parameters;
  carrying(carried).place(joints, placed_);
  claim_.clear();
  const double clearance = parameters.body_tolerance + 0.5 * parameters.margin + kRoundingRoom;
  for (Capsule grown : placed_.capsules) {
    grown.radius += clearance;
    if (isNearOne(grown, of)) claimCapsule(claim_, grown, parameters.voxel);
  }
  touched_.clear();
  for (ZoneIndex zone = 0; zone < artifact_->zones.size(); ++zone) {
    if (isOfInterest(zone, of) && claim_.touches(artifact_->zones[zone].voxels)) touched_.push_back(zone);
  }
}

bool ZoneWatch::isOfInterest(ZoneIndex zone, Of of) const {
  const std::vector<RobotIndex>& users = artifact_->zones[zone].users;
  return of == Of::Everyone || std::find(users.begin(), users.end(), robot_) != users.end();
}

bool ZoneWatch::isNearOne(const Capsule& grown, Of of) const {
  const double reach = grown.radius + kRoundingRoom;
  for (ZoneIndex zone = 0; zone < boxes_.size(); ++zone) {
    const std::optional<AlignedBox>& box = boxes_[zone];
    if (box && isOfInterest(zone, of) && coreDistance(grown, *box) <= reach) return true;
  }
  return false;
}

bool ZoneWatch::touches(ZoneIndex zone) const {
  return std::binary_search(touched_.begin(), touched_.end(), zone);
}

}  // namespace cobot_command::cell
