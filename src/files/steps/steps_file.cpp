#include "cobot_command/files/steps/steps_file.h"

#include <array>

#include <fmt/format.h>

namespace cobot_command::files {
namespace {

/// By their numbers, as RobotPose.msg has them too.
const std::array<YamlNames, 3> kPostures = {YamlNames{{"RIGHTY", 0}, {"LEFTY", 1}},
                                            YamlNames{{"ABOVE", 2}, {"BELOW", 3}},
                                            YamlNames{{"NOFLIP", 4}, {"FLIP", 5}}};

blocks::MoveAbsoluteGoal toMove(const YamlMap& step) {
  blocks::MoveAbsoluteGoal move;
  move.movement_command = step.named("movement_command", movementNames());
  move.data_format =
      toAbsoluteFormat(step, move.movement_command, "this file cannot contain moves relative to the tool");
  move.target = toSix(step, "target_position");
  takeMotion(step, move);
  takePosture(step, move);
  return move;
}

FileStep toStep(const YAML::Node& node, double usual_dwell) {
  refuseRetiredKey(node);
  const YamlMap map(node, "a step",
                    {"name", "command_id", "movement_command", "data_format", "target_position", "speed",
                     "accel_time", "blending_enable", "blending_value", "disable_precise_positioning",
                     "robot_pose", "exit_node", "output", "input", "dwell"});
  FileStep read;
  read.line = map.mark().line + 1;
  read.column = map.mark().column + 1;
  if (map.has("name")) read.name = map.text("name");
  read.step.move = toMove(map);
  read.step.output = toOutput(map);
  read.step.input = toInput(map);
  read.step.dwell = toDwell(map, usual_dwell);
  return read;
}

std::vector<FileStep> toSteps(const YAML::Node& document) {
  const YamlMap file(document, "the file", {"dwell", "steps"});
  const double usual_dwell = file.has("dwell") ? file.number("dwell") : kUsualDwell;
  const YAML::Node list = file.listOf("steps", blocks::PickAndPlaceGoal::kMostSteps, "steps");
  std::vector<FileStep> steps;
  for (const YAML::Node& node : list) steps.push_back(toStep(node, usual_dwell));
  return steps;
}

}  // namespace

const YamlNames& movementNames() {
  static const YamlNames kNames{{"LINE", static_cast<int>(blocks::Movement::Line)},
                                {"PTP", static_cast<int>(blocks::Movement::Ptp)}};
  return kNames;
}

const YamlNames& absoluteFormatNames() {
  using blocks::AbsoluteFormat;
  static const YamlNames kNames{{"JPP", static_cast<int>(AbsoluteFormat::Jpp)},
                                {"CPP", static_cast<int>(AbsoluteFormat::Cpp)},
                                {"CPR", static_cast<int>(AbsoluteFormat::Cpr)},
                                {"CAP", static_cast<int>(AbsoluteFormat::Cap)},
                                {"CAR", static_cast<int>(AbsoluteFormat::Car)}};
  return kNames;
}

int toFormat(const YamlMap& step, int movement, const YamlNames& all) {
  const YAML::Node node = step.required("data_format");
  YamlNames taken;
  for (const auto& format : all) {
    if (node.IsScalar() && node.Scalar() == format.first) return format.second;
    const std::string name = format.first;
    const bool is_taken = movement == static_cast<int>(blocks::Movement::Line)
                              ? name != "JPP"
                              : name == "JPP" || name == "CPP" || name == "TPP";
    if (is_taken) taken.push_back(format);
  }
  return toNamed(node, "data_format", taken);
}

int toAbsoluteFormat(const YamlMap& step, int movement, const std::string& of_tool) {
  const YAML::Node node = step.required("data_format");
  for (const char* name : {"TPP", "TPR", "TAP", "TAR"}) {
    if (!node.IsScalar() || node.Scalar() != name) continue;
    throw YamlFault(node.Mark(),
                    fmt::format("data_format is {}, which is relative to the tool: {}", name, of_tool),
                    {"data_format", fmt::format("is {}, which is relative to the tool", name),
                     "JPP, CPP, CPR, CAP or CAR", of_tool});
  }
  return toFormat(step, movement, absoluteFormatNames());
}

blocks::SixValues toSix(const YamlMap& map, const char* key) {
  blocks::SixValues values{};
  const YAML::Node list = map.list(key, values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = toNumber(list[i], fmt::format("{}[{}]", key, i));
  }
  return values;
}

void takePosture(const YamlMap& step, blocks::MoveAbsoluteGoal& move) {
  if (!step.has("robot_pose")) return;
  move.robot_pose_enable = true;
  const YAML::Node posture = step.list("robot_pose", kPostures.size());
  for (std::size_t i = 0; i < kPostures.size(); ++i) {
    move.robot_pose[i] = toNamed(posture[i], fmt::format("robot_pose[{}]", i), kPostures[i]);
  }
}

std::optional<blocks::SetOutputGoal> toOutput(const YamlMap& step) {
  if (!step.has("output")) return std::nullopt;
  const YamlMap output(step.required("output"), "output", {"module", "output", "value"});
  blocks::SetOutputGoal goal;
  goal.module = output.text("module");
  goal.output = output.whole("output");
  goal.value = output.truth("value") ? 1 : 0;
  return goal;
}

std::optional<blocks::WaitForInputGoal> toInput(const YamlMap& step) {
  if (!step.has("input")) return std::nullopt;
  const YamlMap input(step.required("input"), "input", {"module", "input", "value", "timeout"});
  blocks::WaitForInputGoal goal;
  goal.module = input.text("module");
  goal.input = input.whole("input");
  goal.value = input.truth("value");
  if (input.has("timeout")) goal.timeout = input.number("timeout");
  return goal;
}

double toDwell(const YamlMap& step, double usual) {
  if (!step.has("dwell")) return 0;
  const YAML::Node node = step.required("dwell");
  bool wanted = false;
  if (YAML::convert<bool>::decode(node, wanted)) return wanted ? usual : 0;
  return toNumber(node, "dwell", "true, false, or a number of seconds");
}

void refuseRetiredKey(const YAML::Node& step) {
  if (!step.IsMap()) return;
  for (const auto& entry : step) {
    if (entry.first.IsScalar() && entry.first.Scalar() == "precise_positioning") {
      const std::string advice =
          "remove it if it was true, write disable_precise_positioning: true if it was false";
      throw YamlFault(entry.first.Mark(),
                      "precise_positioning was replaced by disable_precise_positioning, which has the "
                      "opposite meaning: " +
                          advice,
                      {"precise_positioning",
                       "was replaced by disable_precise_positioning, which has the opposite meaning",
                       "disable_precise_positioning", advice});
    }
  }
}

Result<std::vector<FileStep>, FileFault> readSteps(const std::string& text, const std::string& name) {
  return tryYaml<std::vector<FileStep>>(text, name, toSteps);
}

}  // namespace cobot_command::files
