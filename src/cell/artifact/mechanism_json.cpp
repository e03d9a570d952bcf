#include "artifact/artifact_json.h"

namespace cobot_command::cell {

using nlohmann::json;

namespace {

json written(const ArtifactMechanismPath& path) {
  json pieces = json::array();
  for (const ArtifactAxisPiece& piece : path.pieces) {
    pieces.push_back({{"from", piece.from}, {"to", piece.to}, {"zones", piece.zones}});
  }
  json result = {
      {"pieces", std::move(pieces)}, {"holds", toJson(path.holds)}, {"places", toJson(path.places)}};
  if (path.duration) result["duration"] = path.duration->count();
  return result;
}

ArtifactMechanismPath pathFrom(const json& source) {
  ArtifactMechanismPath path;
  for (const auto& piece : source.at("pieces")) {
    path.pieces.push_back({finiteFrom(piece.at("from")), finiteFrom(piece.at("to")),
                           piece.at("zones").get<std::vector<ZoneIndex>>()});
  }
  path.holds = holdsFrom(source.at("holds"));
  path.places = placesFrom(source.at("places"));
  if (source.contains("duration")) path.duration = Duration(source.at("duration").get<Duration::rep>());
  return path;
}

}  // namespace

json toJson(const ArtifactMechanism& mechanism) {
  const MotionAxis& axis = mechanism.bodies.axis();
  json result = {{"turns", axis.turns},
                 {"at", toJson(axis.at)},
                 {"direction", {axis.direction.x(), axis.direction.y(), axis.direction.z()}},
                 {"bodies", toJson(mechanism.bodies.capsules())},
                 {"stations", json::array()},
                 {"paths", json::array()}};
  for (const ArtifactPosition& station : mechanism.stations) {
    result["stations"].push_back({{"value", station.value}, {"zones", station.zones}});
  }
  for (const ArtifactMechanismPath& path : mechanism.paths) result["paths"].push_back(written(path));
  return result;
}

ArtifactMechanism mechanismFrom(const json& source) {
  ArtifactMechanism mechanism;
  const auto& direction = source.at("direction");
  const MotionAxis axis{
      source.at("turns").get<bool>(),
      poseFrom(source.at("at")),
      {finiteFrom(direction.at(0)), finiteFrom(direction.at(1)), finiteFrom(direction.at(2))}};
  mechanism.bodies = MechanismBodies(axis, capsulesFrom(source.at("bodies")));
  for (const auto& station : source.at("stations")) {
    mechanism.stations.push_back(
        {finiteFrom(station.at("value")), station.at("zones").get<std::vector<ZoneIndex>>()});
  }
  for (const auto& path : source.at("paths")) mechanism.paths.push_back(pathFrom(path));
  return mechanism;
}

}  // namespace cobot_command::cell
