#include "forms/cycle.h"

#include <algorithm>
#include <utility>

#include "forms/forms.h"
#include "forms/motion_fields.h"

namespace cobot_command::rviz_plugin {
namespace {

constexpr double kPickY = -220;
constexpr double kPlaceY = 220;
constexpr double kHigh = 380;
constexpr double kLow = 260;
constexpr double kGripperTime = 2;  // [s]

constexpr int kCpp = 1;
constexpr int kCap = 3;

/// Point to point, in the posture that the cycle is meant for.
Preset approach(double y) {
  return {"",
          {{"movement_command", kPtp},
           {"data_format", kCpp},
           {"target.0", 430},
           {"target.1", y},
           {"target.2", kHigh},
           {"speed_percent", 60},
           {"accel_time", 400},
           {"robot_pose_enable", 1}},
          {}};
}

Preset straight(double y, double z, double speed, double dwell) {
  return {"",
          {{"movement_command", kLine},
           {"data_format", kCap},
           {"target.0", 430},
           {"target.1", y},
           {"target.2", z},
           {"speed_mm_s", speed},
           {"accel_time", 300},
           {"dwell", dwell}},
          {}};
}

/// A move, and what follows once the robot stands at its target.
Form stepForm(const Preset& preset) {
  std::vector<Field> fields = moveAbsoluteForm().fields();
  // That is of the cycle as a whole.
  fields.erase(
      std::remove_if(fields.begin(), fields.end(), [](const Field& f) { return f.key == "buffer_mode"; }),
      fields.end());
  fields.push_back(choiceField("output_module", "Then set an output of",
                               {{0, "nothing"}, {1, "EndModule"}, {2, "ControlBox"}}, 0));
  fields.push_back(numberField("output", "Output", "", 0, 15, 0));
  fields.push_back(switchField("output_value", "on", true));
  fields.push_back(numberField("dwell", "Then wait", "s", 0, 3600, 0, 1));
  const auto rule = [move_rule = moveAbsoluteRule()](Form& form) {
    move_rule(form);
    const bool sets = form.whole("output_module") != 0;
    form.show("output", sets);
    form.show("output_value", sets);
    // What follows a move needs a robot that stands.
    if (!sets && form.number("dwell") == 0) return;
    for (const char* key : {"blending_enable", "blending_percent", "blending_mm"}) form.show(key, false);
  };
  Form form(std::move(fields), rule);
  form.apply(preset);
  return form;
}

}  // namespace

Cycle presetCycle() {
  std::vector<Field> general;
  general.push_back(numberField("cycles", "Cycles", "", 0, 1000000, 1));
  general.back().hint = "0: until it is stopped";
  general.push_back(bufferModeField());
  return {{stepForm(approach(kPickY)), stepForm(straight(kPickY, kLow, 150, 0)),
           stepForm(straight(kPickY, kHigh, 250, kGripperTime)), stepForm(approach(kPlaceY)),
           stepForm(straight(kPlaceY, kLow, 150, 0)), stepForm(straight(kPlaceY, kHigh, 250, kGripperTime))},
          Form(std::move(general))};
}

}  // namespace cobot_command::rviz_plugin
