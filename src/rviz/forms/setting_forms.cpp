// Connect, Change Base and Change TCP.
#include <utility>

#include "forms/forms.h"
#include "forms/motion_fields.h"

namespace cobot_command::rviz_plugin {
namespace {

constexpr double kMostInertia = 1e9;

Preset noTool() {
  Preset preset{
      "Set null tool offset", {{"weight", 0}, {"ixx", 0}, {"iyy", 0}, {"izz", 0}}, {{"tcp_name", ""}}};
  for (const char* prefix : {"tcp_offset.", "mass_center."}) {
    for (int i = 0; i < 6; ++i) preset.numbers[prefix + std::to_string(i)] = 0;
  }
  return preset;
}

Preset robotBase() {
  Preset preset{"Set default robot base", {}, {{"base_name", ""}}};
  for (int i = 0; i < 6; ++i) preset.numbers["base." + std::to_string(i)] = 0;
  return preset;
}

}  // namespace

Form connectForm() {
  std::vector<Field> fields;
  fields.push_back(
      textField("host", "Robot address", "", "Name or IP address; empty: as set in the command node"));
  fields.push_back(numberField("port", "Script port", "", 0, 65535, 0));
  fields.back().hint = "Of the Listen node, 5890 on a controller; 0: as set in the command node";
  fields.push_back(numberField("status_port", "Status port", "", 0, 65535, 0));
  fields.back().hint = "Of the Ethernet Slave, 5891 on a controller; 0: as set in the command node";
  fields.push_back(numberField("timeout", "Timeout", "s", 10, 300, 30));
  fields.back().hint = "Time limit of connecting";
  return Form(std::move(fields), nullptr,
              {{"Preset values", {{"port", 0}, {"status_port", 0}, {"timeout", 30}}, {{"host", ""}}},
               {"Ports of a controller", {{"port", 5890}, {"status_port", 5891}}, {}}});
}

Form changeBaseForm() {
  std::vector<Field> fields;
  addPose(fields, "base", "Base in the robot base");
  fields.push_back(textField("base_name", "Base of the project", "",
                             "Name of a base of the controller's project, in place of the numbers"));
  fields.push_back(bufferModeField());
  return Form(std::move(fields),
              [](Form& form) { form.showGroup("Base in the robot base", form.text("base_name").empty()); },
              {robotBase()});
}

Form changeTcpForm() {
  std::vector<Field> fields;
  addPose(fields, "tcp_offset", "TCP in the flange");
  fields.push_back(numberField("weight", "Weight", "kg", 0, 14, 0, 3));
  for (const char* axis : {"ixx", "iyy", "izz"}) {
    fields.push_back(numberField(axis, axis, "kg·mm²", 0, kMostInertia, 0, 1));
    fields.back().group = "Moment of inertia";
  }
  addPose(fields, "mass_center", "Mass centre in the tool");
  fields.push_back(textField("tcp_name", "TCP of the project", "",
                             "Name of a TCP of the controller's project, in place of all these numbers"));
  fields.push_back(bufferModeField());
  const auto rule = [](Form& form) {
    const bool numbers = form.text("tcp_name").empty();
    for (const char* group : {"TCP in the flange", "Moment of inertia", "Mass centre in the tool"}) {
      form.showGroup(group, numbers);
    }
    form.show("weight", numbers);
  };
  return Form(std::move(fields), rule, {noTool()});
}

}  // namespace cobot_command::rviz_plugin
