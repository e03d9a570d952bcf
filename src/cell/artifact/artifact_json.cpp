#include "artifact/artifact_json.h"

#include <cmath>

namespace cobot_command::cell {

using nlohmann::json;

void wrongInArtifact(const std::string& what) {
  throw json::other_error::create(501, what, nullptr);
}

double finiteFrom(const json& source) {
  const double number = source.get<double>();
  if (!std::isfinite(number)) wrongInArtifact("a number is not finite");
  return number;
}

namespace {

template <std::size_t Count>
std::array<double, Count> numbersFrom(const json& list) {
  if (list.size() != Count) wrongInArtifact("a list of numbers is too short or too long");
  std::array<double, Count> numbers{};
  for (std::size_t index = 0; index < Count; ++index) numbers[index] = finiteFrom(list.at(index));
  return numbers;
}

json written(Duration duration) {
  return duration.count();
}
Duration durationFrom(const json& value) {
  return Duration(value.get<Duration::rep>());
}

std::string hexOf(const std::string& bytes) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  text.reserve(2 * bytes.size());
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    text += kDigits[byte / 16];
    text += kDigits[byte % 16];
  }
  return text;
}

unsigned digitOf(char c) {
  if (c >= '0' && c <= '9') return static_cast<unsigned>(c - '0');
  if (c >= 'a' && c <= 'f') return static_cast<unsigned>(c - 'a') + 10;
  wrongInArtifact("voxels are not written in hexadecimal digits");
}

std::string bytesOf(const std::string& hex) {
  if (hex.size() % 2 != 0) wrongInArtifact("voxels are truncated");
  std::string bytes;
  bytes.reserve(hex.size() / 2);
  for (std::size_t at = 0; at < hex.size(); at += 2) {
    bytes += static_cast<char>(16 * digitOf(hex[at]) + digitOf(hex[at + 1]));
  }
  return bytes;
}

json written(const ArtifactFrame& frame) {
  json result = {{"step", frame.step},       {"lines", frame.lines},          {"base", toJson(frame.base)},
                 {"tcp", toJson(frame.tcp)}, {"stands", frame.stands},        {"carried", frame.carried},
                 {"dwell", frame.dwell},     {"begin", written(frame.begin)}, {"end", written(frame.end)}};
  if (frame.start) result["start"] = toJson(*frame.start);
  if (frame.output) {
    result["output"] = {{"kind", frame.output->kind},
                        {"module", frame.output->module},
                        {"output", frame.output->output},
                        {"value", frame.output->value}};
  }
  if (frame.input) {
    result["input"] = {{"module", frame.input->module},
                       {"input", frame.input->input},
                       {"value", frame.input->value},
                       {"timeout", frame.input->timeout}};
  }
  return result;
}

void outputFrom(const json& source, ArtifactFrame& frame) {
  if (source.contains("output")) {
    const json& output = source.at("output");
    frame.output.emplace();
    output.at("kind").get_to(frame.output->kind);
    output.at("module").get_to(frame.output->module);
    output.at("output").get_to(frame.output->output);
    frame.output->value = finiteFrom(output.at("value"));
  }
  if (source.contains("input")) {
    const json& input = source.at("input");
    frame.input.emplace();
    input.at("module").get_to(frame.input->module);
    input.at("input").get_to(frame.input->input);
    input.at("value").get_to(frame.input->value);
    frame.input->timeout = finiteFrom(input.at("timeout"));
  }
}

ArtifactFrame frameFrom(const json& source) {
  ArtifactFrame frame;
  source.at("step").get_to(frame.step);
  source.at("lines").get_to(frame.lines);
  frame.base = poseFrom(source.at("base"));
  frame.tcp = poseFrom(source.at("tcp"));
  source.at("stands").get_to(frame.stands);
  source.at("carried").get_to(frame.carried);
  outputFrom(source, frame);
  frame.dwell = finiteFrom(source.at("dwell"));
  frame.begin = durationFrom(source.at("begin"));
  frame.end = durationFrom(source.at("end"));
  if (source.contains("start")) frame.start = jointsFrom(source.at("start"));
  return frame;
}

json written(const ArtifactPiece& piece) {
  return {
      {"kind", static_cast<int>(piece.kind)}, {"frame", piece.frame},    {"motion", piece.motion},
      {"from", written(piece.from)},          {"to", written(piece.to)}, {"lower", toJson(piece.range.lower)},
      {"upper", toJson(piece.range.upper)},   {"zones", piece.zones}};
}

ArtifactPiece pieceFrom(const json& source) {
  ArtifactPiece piece;
  const int kind = source.at("kind").get<int>();
  if (kind < 0 || kind > static_cast<int>(Piece::Kind::Rest)) wrongInArtifact("a piece has an unknown kind");
  piece.kind = static_cast<Piece::Kind>(kind);
  source.at("frame").get_to(piece.frame);
  source.at("motion").get_to(piece.motion);
  piece.from = durationFrom(source.at("from"));
  piece.to = durationFrom(source.at("to"));
  piece.range = {jointsFrom(source.at("lower")), jointsFrom(source.at("upper"))};
  source.at("zones").get_to(piece.zones);
  return piece;
}

json written(const Hold& hold) {
  json result = {{"zone", hold.zone}, {"first_piece", hold.first_piece}};
  if (hold.first_frame) result["first_frame"] = *hold.first_frame;
  if (hold.last_piece) result["last_piece"] = *hold.last_piece;
  return result;
}

Hold holdFrom(const json& source) {
  Hold hold;
  source.at("zone").get_to(hold.zone);
  source.at("first_piece").get_to(hold.first_piece);
  if (source.contains("first_frame")) hold.first_frame = source.at("first_frame").get<std::size_t>();
  if (source.contains("last_piece")) hold.last_piece = source.at("last_piece").get<std::size_t>();
  return hold;
}

json written(const ArtifactPath& path) {
  json result = {{"frames", json::array()},
                 {"pieces", json::array()},
                 {"holds", toJson(path.holds)},
                 {"places", toJson(path.places)},
                 {"duration", written(path.duration)}};
  for (const ArtifactFrame& frame : path.frames) result["frames"].push_back(written(frame));
  for (const ArtifactPiece& piece : path.pieces) result["pieces"].push_back(written(piece));
  return result;
}

ArtifactPath pathFrom(const json& source) {
  ArtifactPath path;
  for (const auto& frame : source.at("frames")) path.frames.push_back(frameFrom(frame));
  for (const auto& piece : source.at("pieces")) path.pieces.push_back(pieceFrom(piece));
  path.holds = holdsFrom(source.at("holds"));
  path.places = placesFrom(source.at("places"));
  path.duration = durationFrom(source.at("duration"));
  return path;
}

json written(const std::vector<FlangeCapsules>& things) {
  json list = json::array();
  for (const FlangeCapsules& thing : things) {
    list.push_back({{"name", thing.name}, {"capsules", toJson(thing.capsules)}});
  }
  return list;
}

std::vector<FlangeCapsules> thingsFrom(const json& source) {
  std::vector<FlangeCapsules> things;
  for (const auto& thing : source) {
    FlangeCapsules& made = things.emplace_back();
    thing.at("name").get_to(made.name);
    made.capsules = capsulesFrom(thing.at("capsules"));
  }
  return things;
}

}  // namespace

json toJson(const Capsules& capsules) {
  json list = json::array();
  for (const Capsule& one : capsules) {
    list.push_back(
        {one.from.x(), one.from.y(), one.from.z(), one.to.x(), one.to.y(), one.to.z(), one.radius});
  }
  return list;
}

Capsules capsulesFrom(const json& source) {
  Capsules capsules;
  for (const auto& capsule : source) {
    const auto numbers = numbersFrom<7>(capsule);
    capsules.push_back(
        {{numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]}, numbers[6]});
  }
  return capsules;
}

json toJson(const std::vector<Hold>& holds) {
  json list = json::array();
  for (const Hold& hold : holds) list.push_back(written(hold));
  return list;
}

std::vector<Hold> holdsFrom(const json& source) {
  std::vector<Hold> holds;
  for (const auto& hold : source) holds.push_back(holdFrom(hold));
  return holds;
}

json toJson(const std::vector<ZonePlace>& places) {
  json list = json::array();
  for (const ZonePlace& place : places) list.push_back({place.frame, place.piece});
  return list;
}

std::vector<ZonePlace> placesFrom(const json& source) {
  std::vector<ZonePlace> places;
  for (const auto& place : source) {
    places.push_back({place.at(0).get<std::size_t>(), place.at(1).get<std::size_t>()});
  }
  return places;
}

json toJson(const arm::JointVector& joints) {
  return {joints[0], joints[1], joints[2], joints[3], joints[4], joints[5]};
}

arm::JointVector jointsFrom(const json& source) {
  const auto numbers = numbersFrom<arm::kJointCount>(source);
  return Eigen::Map<const arm::JointVector>(numbers.data());
}

/// Its upper three rows, one behind the other.
json toJson(const arm::Pose& pose) {
  json numbers = json::array();
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 4; ++column) numbers.push_back(pose.matrix()(row, column));
  }
  return numbers;
}

arm::Pose poseFrom(const json& source) {
  const auto numbers = numbersFrom<12>(source);
  arm::Pose pose = arm::Pose::Identity();
  for (std::size_t index = 0; index < numbers.size(); ++index) {
    pose.matrix()(static_cast<Eigen::Index>(index / 4), static_cast<Eigen::Index>(index % 4)) =
        numbers[index];
  }
  return pose;
}

json toJson(const ArtifactRobot& robot) {
  json result = {{"model", robot.model},        {"namespace", robot.name_space}, {"base", toJson(robot.base)},
                 {"tool", written(robot.tool)}, {"parts", written(robot.parts)}, {"stations", json::array()},
                 {"paths", json::array()}};
  for (const ArtifactStation& station : robot.stations) {
    result["stations"].push_back(
        {{"joints", toJson(station.joints)}, {"zones", station.zones}, {"carried", station.carried}});
  }
  for (const ArtifactPath& path : robot.paths) result["paths"].push_back(written(path));
  return result;
}

ArtifactRobot robotFrom(const json& source) {
  ArtifactRobot robot;
  source.at("model").get_to(robot.model);
  source.at("namespace").get_to(robot.name_space);
  robot.base = poseFrom(source.at("base"));
  robot.tool = thingsFrom(source.at("tool"));
  robot.parts = thingsFrom(source.at("parts"));
  for (const auto& station : source.at("stations")) {
    robot.stations.push_back({jointsFrom(station.at("joints")),
                              station.at("zones").get<std::vector<ZoneIndex>>(),
                              station.at("carried").get<std::vector<std::string>>()});
  }
  for (const auto& path : source.at("paths")) robot.paths.push_back(pathFrom(path));
  return robot;
}

json toJson(const Zone& zone) {
  return {{"name", zone.name}, {"users", zone.users}, {"voxels", hexOf(zone.voxels.bytes())}};
}

Zone zoneFrom(const json& source) {
  Zone zone;
  source.at("name").get_to(zone.name);
  source.at("users").get_to(zone.users);
  auto voxels = VoxelSet::fromBytes(bytesOf(source.at("voxels").get<std::string>()));
  if (!voxels) wrongInArtifact("voxels are invalid");
  zone.voxels = std::move(*voxels);
  return zone;
}

json toJson(const PartSupervisor& supervisor) {
  const automata::SynthesisCounts& counts = supervisor.counts;
  return {{"automata", supervisor.automata},
          {"policy", toString(supervisor.policy)},
          {"compressed", supervisor.is_compressed},
          {"frontier", supervisor.frontier},
          {"fingerprint", supervisor.fingerprint},
          {"counts",
           {counts.states, counts.transitions, counts.marked, counts.refused_by_spec,
            counts.refused_beyond_spec, counts.frontier}}};
}

PartSupervisor supervisorFrom(const json& source) {
  PartSupervisor supervisor;
  source.at("automata").get_to(supervisor.automata);
  const auto policy = policyNamed(source.at("policy").get<std::string>());
  if (!policy) wrongInArtifact("a supervisor has no policy");
  supervisor.policy = *policy;
  source.at("compressed").get_to(supervisor.is_compressed);
  source.at("frontier").get_to(supervisor.frontier);
  source.at("fingerprint").get_to(supervisor.fingerprint);
  const auto counts = source.at("counts").get<std::array<std::size_t, 6>>();
  supervisor.counts = {counts[0], counts[1], counts[2], counts[3], counts[4], counts[5]};
  return supervisor;
}

}  // namespace cobot_command::cell
