#include "reading/program_reading.h"

#include <utility>

#include "checks/program_checks.h"
#include "checks/step_checks.h"
#include "reading/document.h"
#include "reading/names.h"
#include "reading/station_poses.h"
#include "reading/step_goals.h"
#include <fmt/format.h>

#include "cobot_command/blocks/check_sequence.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/given.h"
#include "cobot_command/files/steps/steps_file.h"

namespace cobot_command::cell {

namespace {

using files::YamlMap;

constexpr std::size_t kMostSteps = blocks::CheckSequenceGoal::kMostSteps;

std::string partIn(const YamlMap& map, const char* key, const std::vector<Part>& parts) {
  if (!map.has(key)) return "";
  std::string name = nameIn(map, key);
  if (find(parts, name) == nullptr) {
    refuseUnknown(map.required(key).Mark(), key, name, "part", namesOf(parts));
  }
  return name;
}

/// It stands in reports, in lines of logs and in artifacts.
std::string nameForPeople(const YamlMap& map) {
  std::string name = map.text("name");
  if (name.size() > kForeignTextLimit || escaped(name) != name) {
    refuseAt(map.required("name").Mark(),
             {"name", "is " + quoted(name),
              fmt::format("at most {} bytes without control characters", kForeignTextLimit), ""});
  }
  return name;
}

/// That of steps whose dwell is true [s].
double usualDwell(const YamlMap& path) {
  if (!path.has("dwell")) return files::kUsualDwell;
  const double dwell = path.number("dwell");
  if (!isDwell(dwell)) {
    const YAML::Node node = path.required("dwell");
    refuseAt(node.Mark(), {"dwell", files::isShown(node), kDwellRange, ""});
  }
  return dwell;
}

Step toStep(const YAML::Node& node, double usual_dwell, const Robot& robot, const ProgramReading& reading) {
  Step step;
  step.place = placeOf(reading.faults, node.Mark());
  takeGoal(node, robot, step);
  const YamlMap map = mapOf(node);
  if (map.has("name")) step.name = nameForPeople(map);
  step.attach = partIn(map, "attach", reading.parts);
  step.output = files::toOutput(map);
  step.input = files::toInput(map);
  step.dwell = files::toDwell(map, usual_dwell);
  step.detach = partIn(map, "detach", reading.parts);
  return step;
}

void count(std::size_t steps, const YAML::Mark& mark, ProgramReading& reading) {
  reading.steps += steps;
  if (reading.steps > kMostStepsOfCell) {
    refuseAt(mark, {"steps", fmt::format("are {}, including those before them", reading.steps),
                    fmt::format("at most {} in a cell", kMostStepsOfCell), "split it into two cells"});
  }
}

void readSteps(const YamlMap& map, const std::string& field, const Robot& robot, Path& path,
               ProgramReading& reading) {
  const YAML::Node list = map.listOf("steps", kMostSteps, "steps");
  count(list.size(), list.Mark(), reading);
  const double usual_dwell = usualDwell(map);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string place = fmt::format("{}.steps[{}]", field, i);
    reading.faults.collect(place, [&] {
      path.steps.push_back(toStep(list[i], usual_dwell, robot, reading));
      checkStep(path.steps.back(), place, reading.faults);
    });
  }
}

/// The steps of the file that is named; nothing where it is refused as a whole.
std::vector<files::FileStep> stepsOfFile(const YamlMap& map, const std::string& field,
                                         ProgramReading& reading) {
  const YAML::Mark mark = map.required("steps_file").Mark();
  const std::string name = map.text("steps_file");
  const auto refuse_file = [&](const std::string& why) {
    refuseAt(mark, {"steps_file", fmt::format("is {}, which cannot be read: {}", quoted(name), why),
                    "a pick-and-place file, see config/pick_and_place.yaml", "check the path of the file"});
  };
  if (map.has("dwell")) {
    refuseAt(map.required("dwell").Mark(),
             {"dwell", "is given together with a steps_file", "that of the file", "write it into the file"});
  }
  const auto text = reading.read_file(name);
  if (!text) refuse_file(foreignText(text.error()));
  if (text->size() > kMostBytes) refuse_file(fmt::format("it is larger than {} bytes", kMostBytes));
  auto steps = files::readSteps(*text, foreignText(name));
  if (!steps) {
    reading.faults.add(joined(field, "steps_file"), steps.error());
    return {};
  }
  count(steps->size(), mark, reading);
  return *std::move(steps);
}

void readStepsFile(const YamlMap& map, const std::string& field, Path& path, ProgramReading& reading) {
  const std::vector<files::FileStep> steps = stepsOfFile(map, field, reading);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    Step step;
    step.name = foreignText(steps[i].name);
    step.goal = steps[i].step.move;
    step.output = steps[i].step.output;
    step.input = steps[i].step.input;
    step.dwell = steps[i].step.dwell;
    step.place = {foreignText(map.text("steps_file")), steps[i].line, steps[i].column};
    checkStep(step, fmt::format("{}.steps_file.steps[{}]", field, i), reading.faults);
    path.steps.push_back(std::move(step));
  }
}

std::string stationIn(const YamlMap& map, const char* key, const Robot& robot) {
  std::string name = nameIn(map, key);
  if (find(robot.stations, name) == nullptr) {
    refuseUnknown(map.required(key).Mark(), key, name, "station of the robot", namesOf(robot.stations));
  }
  return name;
}

void readPath(const YAML::Node& node, const std::string& field, Robot& robot, ProgramReading& reading) {
  const YamlMap map(node, "a path", {"path", "from", "to", "dwell", "steps", "steps_file"});
  Path path;
  path.place = placeOf(reading.faults, node.Mark());
  path.name = nameIn(map, "path");
  path.from = stationIn(map, "from", robot);
  path.to = stationIn(map, "to", robot);
  if (map.has("steps") == map.has("steps_file")) {
    refuseAt(map.mark(), {map.has("steps") ? "steps_file" : "steps",
                          map.has("steps") ? "is given together with steps" : "is missing",
                          "one of: steps, steps_file", ""});
  }
  const std::size_t before = reading.faults.count();
  if (map.has("steps")) {
    readSteps(map, field, robot, path, reading);
  } else {
    readStepsFile(map, field, path, reading);
  }
  if (reading.faults.count() == before) checkPath(path, robot, field, reading.faults);
  robot.program.push_back(std::move(path));
}

}  // namespace

void readProgram(const YAML::Node& node, const std::string& field, Robot& robot, ProgramReading& reading) {
  const std::size_t before = reading.faults.count();
  reading.faults.collect(field, [&] {
    if (!node.IsSequence() || node.size() > kMostPaths) {
      refuseAt(node.Mark(), {"", files::isShown(node), fmt::format("a list of 1..{} paths", kMostPaths), ""});
    }
    for (std::size_t i = 0; i < node.size(); ++i) {
      const std::string place = fmt::format("{}[{}]", field, i);
      reading.faults.collect(place, [&] { readPath(node[i], place, robot, reading); });
    }
  });
  if (reading.faults.count() > before) return;
  const auto frames =
      checkProgram(robot, reading.parts, placeOf(reading.faults, node.Mark()), field, reading.faults);
  if (reading.faults.count() == before) takeStationPoses(robot, frames);
}

}  // namespace cobot_command::cell
