#include "cobot_command/cell/artifact/artifact.h"

#include "artifact/artifact_json.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cobot_command/common/sha256.h"

namespace cobot_command::cell {
namespace {

using nlohmann::json;

constexpr const char* kFormat = "cobot-cell-artifact";
constexpr int kVersion = 3;

/// Calls for each parameter that is a number of its own, by its name.
template <class ParametersOrConst, class Visitor>
void forEachNumber(ParametersOrConst& parameters, const Visitor& visit) {
  visit("voxel", parameters.voxel);
  visit("step_bound", parameters.step_bound);
  visit("margin", parameters.margin);
  visit("tracking", parameters.tracking);
  visit("body_tolerance", parameters.body_tolerance);
  visit("body_cell", parameters.body_cell);
  visit("speed_override", parameters.speed_override);
  visit("zone_size", parameters.zone_size);
  visit("zone_overlap", parameters.zone_overlap);
  visit("max_zones", parameters.max_zones);
  visit("max_states", parameters.max_states);
}
template <class ParametersOrConst, class Visitor>
void forEachDuration(ParametersOrConst& parameters, const Visitor& visit) {
  visit("lease", parameters.lease);
  visit("report_period", parameters.report_period);
  visit("lookahead", parameters.lookahead);
  visit("wait_timeout", parameters.wait_timeout);
  visit("aging", parameters.aging);
}

json written(const Parameters& parameters) {
  json result = {{"split", parameters.split == Split::Auto}};
  forEachNumber(parameters, [&](const char* name, const auto& value) { result[name] = value; });
  forEachDuration(parameters, [&](const char* name, const Duration& value) { result[name] = value.count(); });
  return result;
}

Parameters parametersFrom(const json& source) {
  Parameters parameters;
  parameters.split = source.at("split").get<bool>() ? Split::Auto : Split::Never;
  forEachNumber(parameters, [&](const char* name, auto& value) { source.at(name).get_to(value); });
  forEachDuration(parameters, [&](const char* name, Duration& value) {
    value = Duration(source.at(name).get<Duration::rep>());
  });
  return parameters;
}

template <class Values>
json listOf(const Values& values) {
  json list = json::array();
  for (const auto& value : values) list.push_back(toJson(value));
  return list;
}

/// Indices that lead nowhere would be followed by who uses it.
class IndexCheck {
 public:
  explicit IndexCheck(const Artifact& artifact) : zones_(artifact.zones.size()) {}

  /// Of a robot or mechanism.
  template <class User>
  void check(const RobotProgram& program, const User& user) const {
    if (user.paths.size() != program.paths.size() || user.stations.size() != program.stations.size()) {
      wrongInArtifact("paths or stations differ from the program");
    }
    for (const auto& station : user.stations) requireZones(station.zones);
    for (std::size_t path = 0; path < user.paths.size(); ++path) {
      checkPath(program.paths[path], user.paths[path]);
    }
  }

 private:
  template <class OfPath>
  void checkPath(const PathProgram& program, const OfPath& path) const {
    if (path.places.size() != program.steps.size()) wrongInArtifact("a zone step has no place");
    const std::size_t frames = framesOf(path);
    for (const ZonePlace& place : path.places) {
      if (place.frame >= frames || place.piece >= path.pieces.size()) {
        wrongInArtifact("a zone step refers to no frame or piece");
      }
    }
    for (const Hold& hold : path.holds) requireZones({hold.zone});
    for (const auto& piece : path.pieces) {
      if (frameOf(piece) >= frames) wrongInArtifact("a piece belongs to no frame");
      requireZones(piece.zones);
    }
  }

  void requireZones(const std::vector<ZoneIndex>& list) const {
    for (const ZoneIndex zone : list) {
      if (zone >= zones_) wrongInArtifact("a zone is named that does not exist");
    }
  }

  static std::size_t framesOf(const ArtifactPath& path) { return path.frames.size(); }
  static std::size_t framesOf(const ArtifactMechanismPath& /*path*/) { return 1; }
  static std::size_t frameOf(const ArtifactPiece& piece) { return piece.frame; }
  static std::size_t frameOf(const ArtifactAxisPiece& /*piece*/) { return 0; }

  std::size_t zones_;
};

void checkIndices(const Artifact& artifact) {
  const auto& programs = artifact.program.robots;
  if (artifact.program.zones.size() != artifact.zones.size() ||
      programs.size() != artifact.robots.size() + artifact.mechanisms.size()) {
    wrongInArtifact("zones or robots differ from the program");
  }
  for (const Zone& zone : artifact.zones) {
    for (const RobotIndex user : zone.users) {
      if (user >= programs.size()) wrongInArtifact("a zone has a user that does not exist");
    }
  }
  const IndexCheck indices(artifact);
  for (RobotIndex robot = 0; robot < programs.size(); ++robot) {
    if (robot < artifact.robots.size()) {
      indices.check(programs[robot], artifact.robots[robot]);
    } else {
      indices.check(programs[robot], artifact.mechanisms[robot - artifact.robots.size()]);
    }
  }
}

Artifact artifactFrom(const json& source) {
  if (source.at("format") != kFormat) wrongInArtifact("it is not an artifact of a cell");
  if (source.at("version") != kVersion) {
    wrongInArtifact(fmt::format("it has version {}, but this program reads version {}: rebuild it",
                                source.at("version").dump(), kVersion));
  }
  Artifact artifact;
  source.at("hash").get_to(artifact.hash);
  artifact.parameters = parametersFrom(source.at("parameters"));
  artifact.program = programFrom(source.at("program"));
  for (const auto& zone : source.at("zones")) artifact.zones.push_back(zoneFrom(zone));
  for (const auto& robot : source.at("robots")) artifact.robots.push_back(robotFrom(robot));
  for (const auto& mechanism : source.at("mechanisms")) {
    artifact.mechanisms.push_back(mechanismFrom(mechanism));
  }
  const auto policy = policyNamed(source.at("policy").get<std::string>());
  if (!policy) wrongInArtifact("it has no policy");
  artifact.policy = *policy;
  for (const auto& supervisor : source.at("supervisors")) {
    artifact.supervisors.push_back(supervisorFrom(supervisor));
  }
  source.at("least_distance").get_to(artifact.least_distance);
  checkIndices(artifact);
  return artifact;
}

CellText sourceFrom(const json& source) {
  return {source.at("cell").get<std::string>(), source.at("files").get<std::map<std::string, std::string>>()};
}

}  // namespace

json toJson(const Artifact& artifact) {
  return {{"format", kFormat},
          {"version", kVersion},
          {"hash", artifact.hash},
          {"parameters", written(artifact.parameters)},
          {"program", toJson(artifact.program)},
          {"zones", listOf(artifact.zones)},
          {"robots", listOf(artifact.robots)},
          {"mechanisms", listOf(artifact.mechanisms)},
          {"policy", toString(artifact.policy)},
          {"supervisors", listOf(artifact.supervisors)},
          {"least_distance", artifact.least_distance}};
}

std::string toBytes(const Artifact& artifact) {
  const json source = {{"cell", artifact.source.text}, {"files", artifact.source.files}};
  const std::string text =
      toJson(artifact).dump() + "\n" + source.dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
  return text + sha256Hex(text) + "\n";
}

std::string digestOf(std::string_view bytes) {
  return sha256Hex(bytes.substr(0, bytes.find('\n') + 1));
}

Result<Artifact, std::string> fromBytes(std::string_view bytes) {
  if (bytes.empty() || bytes.front() != '{') {
    return refuse(std::string("it is not an artifact, which tm_cell build makes from a cell file"));
  }
  // What is cut off by one byte has no last line.
  const std::size_t checksum = bytes.size() < 2 ? 0 : bytes.rfind('\n', bytes.size() - 2) + 1;
  if (checksum == 0 || bytes.substr(checksum) != sha256Hex(bytes.substr(0, checksum)) + "\n") {
    return refuse(std::string("the artifact is damaged: its checksum is wrong. Rebuild it"));
  }
  const std::size_t source = bytes.find('\n') + 1;
  try {
    Artifact artifact = artifactFrom(json::parse(bytes.substr(0, source)));
    artifact.source = sourceFrom(json::parse(bytes.substr(source, checksum - source)));
    artifact.digest = digestOf(bytes);
    return artifact;
  } catch (const json::exception& wrong) {
    return refuse(fmt::format("the artifact cannot be read: {}", wrong.what()));
  }
}

}  // namespace cobot_command::cell
