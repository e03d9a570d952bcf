#include "cobot_command/cell/plan/planned_cell.h"

#include <algorithm>
#include <deque>

#include "plan/path_planning.h"
#include <fmt/format.h>

namespace cobot_command::cell {
namespace {

class RobotPlanner {
 public:
  RobotPlanner(const Cell& cell, const Robot& robot, std::vector<Fault>& faults)
      : cell_(cell), robot_(robot), faults_(faults) {
    for (const Station& station : robot.stations) {
      const bool rests = station.name == robot.home ||
                         std::any_of(robot.program.begin(), robot.program.end(), [&](const Path& path) {
                           return path.from == station.name || path.to == station.name;
                         });
      if (rests) stations_.push_back(&station);
    }
    standing_.resize(stations_.size());
  }

  PlannedRobot plan() {
    PlannedRobot planned{robot_.name, *arm::ArmModel::named(robot_.model), indexOf(robot_.home), {}, {}};
    planned.paths.resize(robot_.program.size());
    standing_[planned.home] = Standing{arm::Pose::Identity(), tcpOf(robot_), {}};
    // Paths in the order in which stations are reached: what is carried, and which frames are active, comes
    // with the way.
    std::deque<std::size_t> open = {planned.home};
    while (!open.empty()) {
      const std::size_t station = open.front();
      open.pop_front();
      for (std::size_t path = 0; path < robot_.program.size(); ++path) {
        if (indexOf(robot_.program[path].from) != station) continue;
        planned.paths[path] = planPathFrom(planned.arm, station, path);
        const std::size_t to = planned.paths[path].to;
        if (!standing_[to]) {
          standing_[to] = end_;
          open.push_back(to);
        }
      }
    }
    for (std::size_t station = 0; station < stations_.size(); ++station) {
      planned.stations.push_back(
          {stations_[station]->name, stations_[station]->joints,
           standing_[station] ? standing_[station]->carried : std::set<std::string>()});
    }
    return planned;
  }

 private:
  PlannedPath planPathFrom(const arm::ArmModel& arm, std::size_t station, std::size_t index) {
    const Path& path = robot_.program[index];
    const std::string field = fmt::format("programs.{}[{}]", robot_.name, index);
    PathPlanning planning(
        {arm, cell_.parameters.speed_override, stations_[station]->joints, *standing_[station]}, field);
    PlannedPath planned = planning.plan(path, find(robot_.stations, path.to)->joints);
    planned.from = station;
    planned.to = indexOf(path.to);
    end_ = planning.end();
    for (const Fault& fault : planning.faults()) faults_.push_back(fault);
    return planned;
  }

  [[nodiscard]] std::size_t indexOf(const std::string& name) const {
    const auto at =
        std::find_if(stations_.begin(), stations_.end(), [&](const auto* one) { return one->name == name; });
    return static_cast<std::size_t>(at - stations_.begin());
  }

  const Cell& cell_;
  const Robot& robot_;
  std::vector<Fault>& faults_;
  std::vector<const Station*> stations_;           ///< where it rests; others only have a name
  std::vector<std::optional<Standing>> standing_;  ///< by station
  Standing end_;                                   ///< of the last path
};

}  // namespace

Result<std::vector<PlannedRobot>, std::vector<Fault>> planCell(const Cell& cell) {
  std::vector<Fault> faults;
  std::vector<PlannedRobot> robots;
  for (const Robot& robot : cell.robots) robots.push_back(RobotPlanner(cell, robot, faults).plan());
  if (!faults.empty()) return refuse(faults);
  return robots;
}

}  // namespace cobot_command::cell
