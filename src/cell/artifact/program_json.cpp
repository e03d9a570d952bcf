#include "artifact/artifact_json.h"

namespace cobot_command::cell {

using nlohmann::json;

namespace {

json written(const RobotProgram& robot) {
  json paths = json::array();
  for (const PathProgram& path : robot.paths) {
    json steps = json::array();
    for (const ZoneStep& step : path.steps) {
      steps.push_back(
          {{"books", step.books}, {"zones", step.zones}, {"uncontrollable", step.uncontrollable}});
    }
    paths.push_back({{"name", path.name},
                     {"from", path.from},
                     {"to", path.to},
                     {"steps", std::move(steps)},
                     {"uncontrollable_go", path.uncontrollable_go}});
  }
  return {{"name", robot.name},
          {"stations", robot.stations},
          {"home", robot.home},
          {"held_at_home", robot.held_at_home},
          {"paths", std::move(paths)}};
}

RobotProgram robotProgramFrom(const json& source) {
  RobotProgram robot;
  source.at("name").get_to(robot.name);
  source.at("stations").get_to(robot.stations);
  source.at("home").get_to(robot.home);
  source.at("held_at_home").get_to(robot.held_at_home);
  for (const auto& path : source.at("paths")) {
    PathProgram& of_robot = robot.paths.emplace_back();
    path.at("name").get_to(of_robot.name);
    path.at("from").get_to(of_robot.from);
    path.at("to").get_to(of_robot.to);
    path.at("uncontrollable_go").get_to(of_robot.uncontrollable_go);
    for (const auto& step : path.at("steps")) {
      of_robot.steps.push_back({step.at("books").get<bool>(), step.at("zones").get<std::vector<ZoneIndex>>(),
                                step.at("uncontrollable").get<bool>()});
    }
  }
  return robot;
}

}  // namespace

json toJson(const CellProgram& program) {
  json robots = json::array();
  for (const RobotProgram& robot : program.robots) robots.push_back(written(robot));
  return {{"name", program.name}, {"zones", program.zones}, {"robots", std::move(robots)}};
}

CellProgram programFrom(const json& source) {
  CellProgram program;
  source.at("name").get_to(program.name);
  source.at("zones").get_to(program.zones);
  for (const auto& robot : source.at("robots")) program.robots.push_back(robotProgramFrom(robot));
  return program;
}

}  // namespace cobot_command::cell
