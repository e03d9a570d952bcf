#include "checks/program_checks.h"

#include <algorithm>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "checks/station_graph.h"
#include "checks/step_checks.h"
#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/units.h"

namespace cobot_command::cell {

namespace {

/// How far the end of a path may be from its station [rad].
constexpr double kStationTolerance = 1e-6;

std::string stepField(const std::string& field, std::size_t step) {
  return fmt::format("{}.steps[{}]", field, step);
}

/// Where a motion ends whose end is joints. Others end where planning finds them to; an arc of a given angle
/// does so wherever its end point is.
std::optional<arm::JointVector> endOf(const Step& step, const Robot& robot) {
  const auto* circle = std::get_if<blocks::MoveCircleGoal>(&step.goal);
  if (circle != nullptr && circle->arc_angle != 0) return {};
  if (!step.at.empty()) return find(robot.stations, step.at)->joints;
  const auto* move = std::get_if<blocks::MoveAbsoluteGoal>(&step.goal);
  if (move == nullptr || move->data_format != static_cast<int>(blocks::AbsoluteFormat::Jpp)) return {};
  return arm::toJointVector(move->target);
}

/// By how much a path misses its station, by its last motion.
void checkEnd(const Step& last, const Robot& robot, const Station& end, const std::string& field,
              FaultList& faults) {
  const auto joints = endOf(last, robot);
  if (!joints) return;
  const arm::JointVector gap = *joints - end.joints;
  Eigen::Index joint = 0;
  const double widest = gap.cwiseAbs().maxCoeff(&joint);
  if (widest <= kStationTolerance) return;
  const char* key =
      std::holds_alternative<blocks::MoveCircleGoal>(last.goal) ? "end_point" : "target_position";
  faults.add(last.place, field,
             {key,
              fmt::format("is {:.6g} deg of J{} away from station {}, where the path ends", radToDeg(widest),
                          joint + 1, end.name),
              "the joints of the station, to 1e-6 rad", fmt::format("write {}: {}", key, end.name)});
}

/// What there is of a robot at a station.
struct Standing {
  ActiveFrames frames;
  std::set<std::string> carried;
  std::string way;  ///< by which it came, for people

  [[nodiscard]] bool sameAs(const Standing& other) const {
    return std::tie(frames.base, frames.tcp, carried) ==
           std::tie(other.frames.base, other.frames.tcp, other.carried);
  }
  [[nodiscard]] std::string inWords() const {
    return fmt::format("carries {}, with the base [{}] and the TCP [{}]",
                       carried.empty() ? "nothing" : fmt::format("{}", fmt::join(carried, ", ")),
                       fmt::join(frames.base, ", "), fmt::join(frames.tcp, ", "));
  }
};

/// Walks all paths from home, and notes how the robot stands at each station.
class Walk {
 public:
  Walk(const Robot& robot, const std::vector<Part>& parts, std::string field, FaultList& faults)
      : robot_(robot), parts_(parts), field_(std::move(field)), faults_(faults) {}

  /// Of each station.
  std::map<std::string, ActiveFrames> go() {
    stands_[robot_.home] = Standing{{{}, robot_.tcp}, {}, "at the start"};
    for (std::deque<std::string> waiting{robot_.home}; !waiting.empty(); waiting.pop_front()) {
      for (std::size_t i = 0; i < robot_.program.size(); ++i) {
        const Path& path = robot_.program[i];
        if (path.from != waiting.front()) continue;
        if (arrive(path, fmt::format("{}[{}]", field_, i))) waiting.push_back(path.to);
      }
    }
    std::map<std::string, ActiveFrames> frames;
    for (const auto& [station, standing] : stands_) frames.emplace(station, standing.frames);
    return frames;
  }

 private:
  /// True: nobody was there before.
  bool arrive(const Path& path, const std::string& field) {
    Standing standing = stands_.at(path.from);
    for (std::size_t i = 0; i < path.steps.size(); ++i) take(path.steps[i], stepField(field, i), standing);
    standing.way = fmt::format("by {} of line {}", path.name, path.place.line);
    const auto [there, is_new] = stands_.emplace(path.to, standing);
    if (!is_new && !there->second.sameAs(standing)) {
      faults_.add(path.place, field,
                  {"to",
                   fmt::format("is {}, where the robot then {}; {} it {}", path.to, standing.inWords(),
                               there->second.way, there->second.inWords()),
                   "the same parts and frames at a station, on every path to it",
                   "give it another station, with the same joints, for the other case"});
    }
    return is_new;
  }

  void take(const Step& step, const std::string& field, Standing& standing) {
    takeFrames(step, standing.frames);
    if (!step.attach.empty()) attach(step, field, standing.carried);
    if (!step.detach.empty()) detach(step, field, standing.carried);
  }

  void attach(const Step& step, const std::string& field, std::set<std::string>& carried) {
    const std::string& carrier = find(parts_, step.attach)->on;
    if (!carrier.empty() && carried.count(carrier) == 0) {
      faults_.add(step.place, field,
                  {"attach", fmt::format("is {}, on {}, which is not attached", step.attach, carrier),
                   "a part whose carrier is attached", "attach " + carrier + " first"});
    }
    if (!carried.insert(step.attach).second) {
      faults_.add(step.place, field,
                  {"attach", fmt::format("is {}, which is attached already", step.attach),
                   "a part that is not attached", "detach it first"});
    }
  }

  void detach(const Step& step, const std::string& field, std::set<std::string>& carried) {
    if (carried.erase(step.detach) == 0) {
      faults_.add(step.place, field,
                  {"detach", fmt::format("is {}, which is not attached", step.detach),
                   "a part that is attached", "attach it first"});
    }
    for (const std::string& part : carried) {
      if (find(parts_, part)->on != step.detach) continue;
      faults_.add(step.place, field,
                  {"detach", fmt::format("is {}, which carries {}", step.detach, part),
                   "a part that carries no other", "detach " + part + " first"});
    }
  }

  const Robot& robot_;
  const std::vector<Part>& parts_;
  std::string field_;
  FaultList& faults_;
  std::map<std::string, Standing> stands_;
};

}  // namespace

void checkPath(const Path& path, const Robot& robot, const std::string& field, FaultList& faults) {
  if (path.steps.empty()) {
    faults.add(path.place, field,
               {"steps", "has no entries", "at least one step", "add a step that moves to " + path.to});
    return;
  }
  const auto last = std::find_if(path.steps.rbegin(), path.steps.rend(), moves);
  const Station& end = *find(robot.stations, path.to);
  if (last == path.steps.rend()) {
    const arm::JointVector gap = end.joints - find(robot.stations, path.from)->joints;
    if (gap.cwiseAbs().maxCoeff() <= kStationTolerance) return;
    faults.add(path.place, field,
               {"steps", fmt::format("do not move the robot to {}", path.to),
                "a path that ends at its station", "add a step that moves there"});
    return;
  }
  const auto index = static_cast<std::size_t>(path.steps.rend() - last) - 1;
  if (blends(*last)) {
    faults.add(last->place, stepField(field, index),
               {"blending_enable", "blends at the end of a path, so the robot would not stop at its station",
                "false for the last motion", "remove it, or split the path"});
  }
  checkEnd(*last, robot, end, stepField(field, index), faults);
}

std::map<std::string, ActiveFrames> checkProgram(const Robot& robot, const std::vector<Part>& parts,
                                                 const Place& place, const std::string& field,
                                                 FaultList& faults) {
  const std::size_t before = faults.count();
  checkGraph(linksOf(robot.program), robot.home, place, field, faults);
  if (faults.count() > before) return {};
  return Walk(robot, parts, field, faults).go();
}

}  // namespace cobot_command::cell
