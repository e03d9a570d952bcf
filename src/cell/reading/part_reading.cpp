#include <set>

#include "reading/names.h"
#include "reading/shape_reading.h"
#include "reading/thing_reading.h"

namespace cobot_command::cell {

namespace {

using files::YamlMap;

constexpr std::size_t kMostThings = 256;
constexpr const char* kFlange = "flange";

Part toPart(const std::string& name, const YAML::Node& node, const FaultList& faults) {
  const YamlMap map(node, "a part", {"shapes", "on", "at"});
  if (name == kFlange) {
    refuseAt(node.Mark(), {"", "is the name of every robot's flange", "any other name", "rename it"});
  }
  Part part;
  part.name = name;
  part.place = placeOf(faults, node.Mark());
  part.shapes = toShapes(map.required("shapes"), "shapes");
  part.on = nameIn(map, "on");
  if (part.on == kFlange) part.on.clear();
  part.at = poseIn(map, "at");
  return part;
}

/// What carries it is there, and is not carried by it in turn.
void checkCarrier(const Part& part, const std::vector<Part>& parts, FaultList& faults) {
  const std::string field = "parts." + part.name;
  std::set<std::string> seen{part.name};
  for (const Part* carried = &part; !carried->on.empty();) {
    const Part* carrier = find(parts, carried->on);
    if (carrier == nullptr) {
      if (carried != &part) return;  // told by the one that hangs on it
      std::vector<std::string> known = namesOf(parts);
      known.emplace_back(kFlange);
      faults.add(part.place, field, unknown("on", part.on, "part or the flange", known));
      return;
    }
    if (!seen.insert(carrier->name).second) {
      faults.add(part.place, field,
                 {"on", "is mounted on itself, through " + carrier->name,
                  "flange, or a part that is mounted on the flange", "mount one of them on the flange"});
      return;
    }
    carried = carrier;
  }
}

}  // namespace

std::vector<Part> readParts(const YAML::Node& node, FaultList& faults) {
  std::vector<Part> parts;
  forEachName(node, "parts", kMostThings, faults, [&](const std::string& name, const YAML::Node& value) {
    parts.push_back(toPart(name, value, faults));
  });
  sortByName(parts);
  for (const Part& part : parts) checkCarrier(part, parts, faults);
  return parts;
}

std::vector<Obstacle> readObstacles(const YAML::Node& node, FaultList& faults) {
  std::vector<Obstacle> obstacles;
  forEachName(node, "obstacles", kMostThings, faults, [&](const std::string& name, const YAML::Node& value) {
    obstacles.push_back({name, toShapes(value, ""), placeOf(faults, value.Mark())});
  });
  sortByName(obstacles);
  return obstacles;
}

}  // namespace cobot_command::cell
