// Load Path, Interface and Jog.
#include <utility>

#include "forms/forms.h"
#include "forms/motion_fields.h"

namespace cobot_command::rviz_plugin {
namespace {

constexpr int kPointsOfExample = 7;  // config/path.yaml
constexpr int kAxes = 2;             // Jog.action: mode
constexpr const char* kCompared = "Data that are compared";

void ruleJog(Form& form) {
  const bool turns = form.whole("mode") == kAxes;
  const bool steps = form.isOn("stepwise");
  form.show("increment_mm", steps && !turns);
  form.show("increment_deg", steps);
}

}  // namespace

Form loadPathForm() {
  std::vector<Field> fields;
  fields.push_back(textField("path_file", "Path file", "package://cobot_command/config/path.yaml",
                             "YAML, on the command node's machine; or package://NAME/file"));
  fields.push_back(numberField("start_index", "First point", "", 0, 999, 0));
  fields.push_back(numberField("number_of_moves", "Points", "", 1, 1000, kPointsOfExample));
  fields.push_back(choiceField("execution", "Execution", {{0, "automatic"}, {1, "script"}, {2, "PVT"}}, 0));
  fields.push_back(switchField("allow_approximation", "Allow approximations", false));
  fields.back().hint = "A script approximates what it cannot express exactly";
  fields.push_back(numberField("max_deviation", "Stop at a deviation of", "mm", 0, 1000, 0, 1));
  fields.back().hint = "The robot is stopped if it deviates further from the planned path; 0: never";
  fields.push_back(bufferModeField());
  return Form(
      std::move(fields), nullptr,
      {{"Preset values",
        {{"start_index", 0}, {"number_of_moves", kPointsOfExample}, {"execution", 0}, {"max_deviation", 0}},
        {{"path_file", "package://cobot_command/config/path.yaml"}}}});
}

Form interfaceForm() {
  std::vector<Field> fields;
  fields.push_back(
      choiceField("log_level", "Log level",
                  {{0, "off"}, {4, "debug"}, {5, "info"}, {20, "warning"}, {28, "error"}, {29, "fatal"}}, 5));
  fields.push_back(numberField("life_sign_time_out", "Life sign", "ms", 10, 65535, 300));
  fields.back().hint = "The link counts as lost after this time without a frame from the controller";
  fields.push_back(numberField("delay_time", "Wait for a blend", "ms", 0, 65535, 0));
  fields.back().hint = "How long the first motion waits for motions to blend into";
  fields.push_back(numberField("wait_for_nr_of_cmd", "or until there are", "motions", 0, 64, 0));
  fields.push_back(switchField("allow_dynamic_blending", "Blend before a script", false));
  fields.push_back(numberField("sync_delay", "Delay of the reaction", "ms", 0, 65535, 0));
  fields.push_back(choiceField("sync_reaction", "Data out of sync",
                               {{0, "are reported"},
                                {1, "prevent enabling"},
                                {2, "interrupt when the queue is empty"},
                                {3, "interrupt at once"}},
                               0));
  for (const auto& [key, label] : {std::pair("tools", "Tools"), std::pair("frames", "Frames"),
                                   std::pair("loads", "Loads"), std::pair("software_limits", "Limits")}) {
    fields.push_back(switchField(key, label, false));
    fields.back().group = kCompared;
  }
  return Form(std::move(fields), nullptr,
              {{"Preset values",
                {{"log_level", 5},
                 {"life_sign_time_out", 300},
                 {"delay_time", 0},
                 {"wait_for_nr_of_cmd", 0},
                 {"allow_dynamic_blending", 0},
                 {"sync_delay", 0},
                 {"sync_reaction", 0}},
                {}}});
}

Form jogForm() {
  std::vector<Field> fields;
  fields.push_back(choiceField("mode", "Along", {{kAxes, "joints"}, {0, "base"}, {1, "tool"}}, kAxes));
  fields.push_back(numberField("speed", "Speed", "%", 1, 100, 10));
  fields.push_back(switchField("stepwise", "In steps", false));
  fields.back().hint = "On: each press is a step. Off: the arm moves while the button is held";
  fields.push_back(numberField("increment_mm", "Step", "mm", 0.1, 1000, 10, 1));
  fields.push_back(numberField("increment_deg", "Step", "°", 0.1, 360, 5, 1));
  return Form(std::move(fields), ruleJog);
}

}  // namespace cobot_command::rviz_plugin
