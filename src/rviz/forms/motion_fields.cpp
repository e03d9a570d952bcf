#include "forms/motion_fields.h"

#include <fmt/format.h>

namespace cobot_command::rviz_plugin {
namespace {

constexpr const char* kMotion = "Motion";

}  // namespace

bool isInJoints(const Format& format) {
  return format.letters[0] == 'J';
}

bool hasAbsoluteSpeed(const Format& format) {
  return format.letters[1] == 'A';
}

bool blendsByRadius(const Format& format) {
  return format.letters[2] == 'R';
}

bool suits(const Format& format, int movement_command) {
  if (movement_command == kLine) return !isInJoints(format);
  return !hasAbsoluteSpeed(format) && !blendsByRadius(format);
}

Option toOption(const Format& format) {
  return {format.value, fmt::format("{}: {}", format.letters, format.meaning)};
}

Field movementField() {
  return choiceField("movement_command", "Motion", {{kPtp, "PTP: joints"}, {kLine, "Line: straight"}}, kPtp);
}

Field bufferModeField() {
  Field field = choiceField("buffer_mode", "While another is busy",
                            {{0, "refuse"}, {1, "wait its turn"}, {2, "stop the others"}}, 0);
  field.hint = "What happens to the command while another one is running";
  return field;
}

void addMotion(std::vector<Field>& fields) {
  const auto add = [&](Field field, const char* group, const char* hint) {
    field.group = group;
    field.hint = hint;
    fields.push_back(std::move(field));
  };
  add(numberField("speed_percent", "Speed", "%", 1, 100, 20), kMotion, "Percentage of the rated speed");
  add(numberField("speed_mm_s", "Speed", "mm/s", 1, 4500, 100), kMotion, "Speed of the tool");
  add(numberField("accel_time", "Ramp", "ms", 150, 9999, 300), kMotion, "Time to top speed");
  fields.push_back(switchField("blending_enable", "Enable blending", false));
  fields.back().hint = "Blend into the next motion before the target is reached";
  add(numberField("blending_percent", "Blending", "%", 0, 100, 50), "", "How early blending starts");
  add(numberField("blending_mm", "Blending radius", "mm", 0, 2000, 20), "", "How early blending starts");
  fields.push_back(switchField("precise", "Precise point", true));
  fields.back().hint = "Settle at the target before the motion is done";
  fields.push_back(bufferModeField());
}

void showUnits(Form& form, const Format& format) {
  const bool blends = form.isOn("blending_enable");
  form.show("blending_enable", true);
  form.show("speed_percent", !hasAbsoluteSpeed(format));
  form.show("speed_mm_s", hasAbsoluteSpeed(format));
  form.show("blending_percent", blends && !blendsByRadius(format));
  form.show("blending_mm", blends && blendsByRadius(format));
}

}  // namespace cobot_command::rviz_plugin
