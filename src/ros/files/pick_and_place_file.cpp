#include "files/pick_and_place_file.h"

#include <array>

#include "files/named_file.h"
#include "files/yaml_map.h"
#include <fmt/format.h>

#include "cobot_command/RobotPose.h"

namespace cobot_command::ros_adapter {
namespace {

constexpr std::size_t kMaxFileSize = 1 << 20;  // a thousand times the steps of the thesis
constexpr double kDefaultDwell = 2;            // [s] as in the thesis

const YamlNames kMovements = {{"LINE", static_cast<int>(blocks::Movement::Line)},
                              {"PTP", static_cast<int>(blocks::Movement::Ptp)}};
const YamlNames kFormats = {{"JPP", static_cast<int>(blocks::AbsoluteFormat::Jpp)},
                            {"CPP", static_cast<int>(blocks::AbsoluteFormat::Cpp)},
                            {"CPR", static_cast<int>(blocks::AbsoluteFormat::Cpr)},
                            {"CAP", static_cast<int>(blocks::AbsoluteFormat::Cap)},
                            {"CAR", static_cast<int>(blocks::AbsoluteFormat::Car)}};
const std::array<YamlNames, 3> kPostures = {
    YamlNames{{"RIGHTY", cobot_command::RobotPose::RIGHTY}, {"LEFTY", cobot_command::RobotPose::LEFTY}},
    YamlNames{{"ABOVE", cobot_command::RobotPose::ABOVE}, {"BELOW", cobot_command::RobotPose::BELOW}},
    YamlNames{{"NOFLIP", cobot_command::RobotPose::NOFLIP}, {"FLIP", cobot_command::RobotPose::FLIP}}};

blocks::MoveAbsoluteGoal toMove(const YamlMap& step) {
  blocks::MoveAbsoluteGoal move;
  move.movement_command = step.named("movement_command", kMovements);
  move.data_format = step.named("data_format", kFormats);
  const YAML::Node target = step.list("target_position", move.target.size());
  for (std::size_t i = 0; i < move.target.size(); ++i) {
    move.target[i] = toNumber(target[i], fmt::format("target_position[{}]", i));
  }
  move.speed = step.whole("speed");
  move.accel_time = step.whole("accel_time");
  if (step.has("command_id")) move.command_id = step.whole("command_id");
  if (step.has("blending_enable")) move.blending_enable = step.truth("blending_enable");
  if (step.has("blending_value")) move.blending_value = step.whole("blending_value");
  if (step.has("exit_node")) move.exit_node = step.truth("exit_node");
  if (step.has("disable_precise_positioning")) {
    move.disable_precise_positioning = step.truth("disable_precise_positioning");
  }
  if (!step.has("robot_pose")) return move;
  move.robot_pose_enable = true;
  const YAML::Node posture = step.list("robot_pose", kPostures.size());
  for (std::size_t i = 0; i < kPostures.size(); ++i) {
    move.robot_pose[i] = toNamed(posture[i], fmt::format("robot_pose[{}]", i), kPostures[i]);
  }
  return move;
}

/// true: `usual`; a number: that long [s].
double toDwell(const YamlMap& step, double usual) {
  if (!step.has("dwell")) return 0;
  const YAML::Node node = step.required("dwell");
  bool wanted = false;
  if (YAML::convert<bool>::decode(node, wanted)) return wanted ? usual : 0;
  return toNumber(node, "dwell", "true, false, or a number of seconds");
}

/// A file from before says the contrary with it.
void refuseRetiredKey(const YAML::Node& step) {
  if (!step.IsMap()) return;
  for (const auto& entry : step) {
    if (entry.first.IsScalar() && entry.first.Scalar() == "precise_positioning") {
      throw YamlFault(entry.first.Mark(),
                      "precise_positioning has become disable_precise_positioning, which says the contrary: "
                      "leave it out where it was true, write disable_precise_positioning: true where it was "
                      "false");
    }
  }
}

blocks::PickAndPlaceStep toStep(const YAML::Node& node, double usual_dwell) {
  refuseRetiredKey(node);
  const YamlMap map(node, "a step",
                    {"name", "command_id", "movement_command", "data_format", "target_position", "speed",
                     "accel_time", "blending_enable", "blending_value", "disable_precise_positioning",
                     "robot_pose", "exit_node", "output", "input", "dwell"});
  if (map.has("name")) static_cast<void>(map.text("name"));
  blocks::PickAndPlaceStep step;
  step.move = toMove(map);
  if (map.has("output")) {
    const YamlMap output(map.required("output"), "output", {"module", "output", "value"});
    step.output.emplace();
    step.output->module = output.text("module");
    step.output->output = output.whole("output");
    step.output->value = output.truth("value") ? 1 : 0;
  }
  if (map.has("input")) {
    const YamlMap input(map.required("input"), "input", {"module", "input", "value", "timeout"});
    step.input.emplace();
    step.input->module = input.text("module");
    step.input->input = input.whole("input");
    step.input->value = input.truth("value");
    if (input.has("timeout")) step.input->timeout = input.number("timeout");
  }
  step.dwell = toDwell(map, usual_dwell);
  return step;
}

PickAndPlaceSteps toSteps(const YAML::Node& document) {
  const YamlMap file(document, "the file", {"dwell", "steps"});
  const double usual_dwell = file.has("dwell") ? file.number("dwell") : kDefaultDwell;
  const YAML::Node list = file.listOf("steps", blocks::PickAndPlaceGoal::kMostSteps, "steps");
  PickAndPlaceSteps steps;
  for (const YAML::Node& node : list) steps.push_back(toStep(node, usual_dwell));
  return steps;
}

}  // namespace

Result<PickAndPlaceSteps, std::string> parsePickAndPlace(const std::string& text, const std::string& name) {
  return readYaml<PickAndPlaceSteps>(text, name, toSteps);
}

Result<PickAndPlaceSteps, std::string> readPickAndPlaceFile(const std::string& location) {
  const auto file = readNamedFile("steps_file", location, kMaxFileSize);
  if (!file) return refuse(file.error());
  return parsePickAndPlace(file->text, file->name);
}

}  // namespace cobot_command::ros_adapter
