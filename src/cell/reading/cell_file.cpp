#include "cobot_command/cell/program/cell_file.h"

#include <algorithm>
#include <map>

#include "checks/fault_list.h"
#include "reading/document.h"
#include "reading/names.h"
#include "reading/program_reading.h"
#include "reading/robot_reading.h"
#include "reading/thing_reading.h"
#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::cell {

namespace {

using files::YamlMap;

constexpr std::size_t kMostRobots = 64;

void readParameters(const YAML::Node& node, Parameters& parameters, FaultList& faults) {
  const SettingTable table = parameterTable(parameters);
  std::vector<std::string> keys;
  for (const Setting& row : table) keys.push_back(row.name);
  const YamlMap map(node, "parameters", keys);
  for (const Setting& row : table) {
    if (!map.has(row.name.c_str())) continue;
    const YAML::Node value = map.required(row.name.c_str());
    if (const auto found = row.kind.take(files::toGiven(value))) {
      faults.collect("parameters", [&] {
        refuseAt(value.Mark(), {row.name, *found, allowedBy(row.kind), ""});
      });
    }
  }
  if (parameters.report_period * 2 > parameters.lease) {
    refuseAt(map.mark(), {"report_period", "is more than half of lease", "two reports within a lease",
                          "make report_period shorter, or lease longer"});
  }
  if (parameters.zone_size < parameters.voxel) {
    refuseAt(map.mark(), {"zone_size", "is below voxel", "a zone of at least one voxel", "make it larger"});
  }
}

/// What stands below "stations" or "programs" for each robot, and nothing for others.
class ByRobot {
 public:
  ByRobot(const YAML::Node& map, const char* key, const std::vector<std::string>& robots, FaultList& faults)
      : place_(map.Mark()), key_(key) {
    forEachName(map, key, kMostRobots, faults, [&](const std::string& name, const YAML::Node& value) {
      const bool known = std::find(robots.begin(), robots.end(), name) != robots.end();
      if (!known) refuseUnknown(value.Mark(), "", name, "robot", robots);
      values_.emplace(name, value);
    });
  }
  [[nodiscard]] const YAML::Node* of(const std::string& robot, FaultList& faults) const {
    const auto found = values_.find(robot);
    if (found != values_.end()) return &found->second;
    faults.add(placeOf(faults, place_), std::string(key_) + "." + robot, {"", "is missing", "", "add it"});
    return nullptr;
  }

 private:
  YAML::Mark place_;
  const char* key_;
  std::map<std::string, YAML::Node> values_;
};

class CellReading {
 public:
  CellReading(const YamlMap& file, FaultList& faults, const ReadFile& read_file)
      : file_(file), faults_(faults), read_file_(read_file) {}

  Cell read() {
    faults_.collect("", [&] { cell_.name = nameIn(file_, "cell"); });
    if (file_.has("parameters")) {
      faults_.collect("parameters",
                      [&] { readParameters(file_.required("parameters"), cell_.parameters, faults_); });
    }
    things();
    faults_.collect("", [&] { robots(); });
    namesOfUsers();
    return std::move(cell_);
  }

 private:
  void things() {
    if (file_.has("parts")) cell_.parts = readParts(file_.required("parts"), faults_);
    if (file_.has("obstacles")) cell_.obstacles = readObstacles(file_.required("obstacles"), faults_);
    if (file_.has("mechanisms")) cell_.mechanisms = readMechanisms(file_.required("mechanisms"), faults_);
  }

  void robots() {
    const YAML::Node robots = file_.required("robots");
    if (robots.IsMap() && robots.size() == 0) {
      refuseAt(robots.Mark(), {"robots", "has no entries", "at least one robot", "add one"});
    }
    std::vector<std::string> names;
    std::map<std::string, YAML::Node> nodes;
    forEachName(robots, "robots", kMostRobots, faults_,
                [&](const std::string& name, const YAML::Node& value) {
                  names.push_back(name);
                  Robot robot = toRobot(name, value, faults_);
                  if (nodes.emplace(name, value).second) cell_.robots.push_back(std::move(robot));
                });
    sortByName(cell_.robots);
    const ByRobot stations(file_.required("stations"), "stations", names, faults_);
    const ByRobot programs(file_.required("programs"), "programs", names, faults_);
    ProgramReading reading{faults_, cell_.parts, read_file_};
    for (Robot& robot : cell_.robots) {
      const std::size_t before = faults_.count();
      if (const YAML::Node* node = stations.of(robot.name, faults_)) {
        readStations(*node, "stations." + robot.name, robot, faults_);
      }
      const YAML::Node* program = programs.of(robot.name, faults_);
      // What is wrong with a station would be told again by each path to it.
      if (faults_.count() > before) continue;
      if (!faults_.collect("robots." + robot.name, [&] { checkHome(nodes.at(robot.name), robot); })) continue;
      readProgram(*program, "programs." + robot.name, robot, reading);
    }
  }

  /// Zones are held by names, and reports come from name spaces.
  void namesOfUsers() {
    std::map<std::string, const Robot*> spaces;
    for (const Robot& robot : cell_.robots) {
      const auto [first, is_new] = spaces.emplace(robot.name_space, &robot);
      if (is_new) continue;
      faults_.add(robot.place, "robots." + robot.name,
                  {"namespace",
                   fmt::format("is {}, the same as that of {} in line {}", robot.name_space,
                               first->second->name, first->second->place.line),
                   "a different namespace for each robot", "change one of them"});
    }
    for (const Mechanism& mechanism : cell_.mechanisms) {
      const Robot* robot = find(cell_.robots, mechanism.name);
      if (robot == nullptr) continue;
      faults_.add(mechanism.place, "mechanisms." + mechanism.name,
                  {"", fmt::format("has the same name as the robot of line {}", robot->place.line),
                   "different names for robots and mechanisms", "rename one of them"});
    }
  }

  const YamlMap& file_;
  FaultList& faults_;
  const ReadFile& read_file_;
  Cell cell_;
};

}  // namespace

Result<Cell, std::vector<Fault>> parseCell(const std::string& text, const std::string& name,
                                           const ReadFile& read_file) {
  FaultList faults(foreignText(name));
  Cell cell;
  CellText source{text, {}};
  const ReadFile read_and_keep = [&](const std::string& other) {
    auto of_other = read_file(other);
    if (of_other) source.files[other] = *of_other;
    return of_other;
  };
  checkText(text, faults);
  if (faults.isEmpty()) {
    faults.collect("", [&] {
      const YamlMap file(
          files::documentIn(text), "the file",
          {"cell", "parameters", "robots", "stations", "programs", "parts", "obstacles", "mechanisms"});
      cell = CellReading(file, faults, read_and_keep).read();
    });
  }
  if (!faults.isEmpty()) return refuse(std::move(faults).all());
  cell.source = std::move(source);
  return cell;
}

}  // namespace cobot_command::cell
