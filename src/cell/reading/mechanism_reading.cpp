#include <cmath>

#include "checks/station_graph.h"
#include "reading/names.h"
#include "reading/program_reading.h"
#include "reading/shape_reading.h"
#include "reading/thing_reading.h"
#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/units.h"

namespace cobot_command::cell {

namespace {

using files::YamlMap;

constexpr std::size_t kMostMechanisms = 64;
constexpr std::size_t kMostPositions = 256;
constexpr double kLongestDuration = 3600;

void takeAxis(const YamlMap& mechanism, Mechanism& made) {
  const YamlMap axis(mechanism.required("axis"), "an axis", {"kind", "along"});
  made.axis = static_cast<Mechanism::Axis>(
      axis.named("kind", {{"prismatic", static_cast<int>(Mechanism::Axis::Prismatic)},
                          {"revolute", static_cast<int>(Mechanism::Axis::Revolute)}}));
  const auto values = coordinates(axis.required("along"), "along", 3);
  const Eigen::Vector3d along(values[0], values[1], values[2]);
  constexpr double kShortest = 1e-3;  // what is shorter has lost its direction to rounding
  if (along.norm() < kShortest) {
    refuseAt(axis.required("along").Mark(),
             {"along", fmt::format("has the length {}", along.norm()), "a direction, of length 0.001 or more",
              "write [0, 0, 1] for z, for instance"});
  }
  made.direction = along.normalized();
}

void readPositions(const YAML::Node& node, Mechanism& made, FaultList& faults) {
  const std::string field = "mechanisms." + made.name + ".positions";
  forEachName(node, field, kMostPositions, faults, [&](const std::string& name, const YAML::Node& value) {
    const double number = files::toNumber(value, "");
    if (std::abs(number) > arm::kMaxCoordinate) {
      refuseAt(value.Mark(), {"", files::isShown(value),
                              fmt::format("{} to {}", -arm::kMaxCoordinate, arm::kMaxCoordinate), ""});
    }
    const bool prismatic = made.axis == Mechanism::Axis::Prismatic;
    if (find(made.positions, name) == nullptr) {
      made.positions.push_back({name, prismatic ? mmToM(number) : degToRad(number)});
    }
  });
  sortByName(made.positions);
}

/// Which of its events happen by themselves.
void takeUncontrollable(const YamlMap& map, MechanismPath& path) {
  if (!map.has("uncontrollable")) return;
  const YAML::Node list = map.listOf("uncontrollable", 2, "events");
  for (std::size_t i = 0; i < list.size(); ++i) {
    const int event = files::toNamed(list[i], fmt::format("uncontrollable[{}]", i), {{"go", 0}, {"book", 1}});
    bool& controllable = event == 0 ? path.controllable_go : path.controllable_book;
    if (!controllable) {
      refuseAt(list[i].Mark(),
               {fmt::format("uncontrollable[{}]", i), "appears twice", "each event once", ""});
    }
    controllable = false;
  }
}

MechanismPath toPath(const YAML::Node& node, const Mechanism& mechanism, const FaultList& faults) {
  const YamlMap map(node, "a path of a mechanism", {"path", "from", "to", "duration", "uncontrollable"});
  MechanismPath path;
  path.place = placeOf(faults, node.Mark());
  path.name = nameIn(map, "path");
  for (const auto& [key, name] : {std::pair{"from", &path.from}, std::pair{"to", &path.to}}) {
    *name = nameIn(map, key);
    if (find(mechanism.positions, *name) == nullptr) {
      refuseUnknown(map.required(key).Mark(), key, *name, "position of the mechanism",
                    namesOf(mechanism.positions));
    }
  }
  if (map.has("duration")) path.duration = map.number("duration");
  if (path.duration < 0 || path.duration > kLongestDuration) {
    const YAML::Node duration = map.required("duration");
    refuseAt(duration.Mark(),
             {"duration", files::isShown(duration), fmt::format("0 to {} s", kLongestDuration), ""});
  }
  takeUncontrollable(map, path);
  return path;
}

void readProgram(const YamlMap& map, Mechanism& made, FaultList& faults) {
  const std::string field = "mechanisms." + made.name;
  const YAML::Node program = map.listOf("program", kMostPaths, "paths");
  const std::size_t before = faults.count();
  for (std::size_t i = 0; i < program.size(); ++i) {
    faults.collect(fmt::format("{}.program[{}]", field, i),
                   [&] { made.program.push_back(toPath(program[i], made, faults)); });
  }
  if (faults.count() == before) {
    checkGraph(linksOf(made.program), made.home, placeOf(faults, program.Mark()), field + ".program", faults);
  }
}

}  // namespace

std::vector<Mechanism> readMechanisms(const YAML::Node& node, FaultList& faults) {
  std::vector<Mechanism> mechanisms;
  const auto read = [&](const std::string& name, const YAML::Node& value) {
    const YamlMap map(value, "a mechanism",
                      {"at", "axis", "shapes", "positions", "home", "holds", "program"});
    Mechanism made;
    made.name = name;
    made.place = placeOf(faults, value.Mark());
    made.at = poseIn(map, "at");
    within("axis", [&] { takeAxis(map, made); });
    made.shapes = toShapes(map.required("shapes"), "shapes");
    readPositions(map.required("positions"), made, faults);
    made.home = nameIn(map, "home");
    if (find(made.positions, made.home) == nullptr) {
      refuseUnknown(map.required("home").Mark(), "home", made.home, "position of the mechanism",
                    namesOf(made.positions));
    }
    if (map.has("holds")) made.holds = map.truth("holds");
    readProgram(map, made, faults);
    mechanisms.push_back(std::move(made));
  };
  forEachName(node, "mechanisms", kMostMechanisms, faults, read);
  sortByName(mechanisms);
  return mechanisms;
}

}  // namespace cobot_command::cell
