#include <algorithm>
#include <utility>

#include "forms/forms.h"
#include "forms/motion_fields.h"

namespace cobot_command::rviz_plugin {
namespace {

constexpr const char* kTarget = "Target";
constexpr const char* kTargetJoints = "Target joints";
constexpr const char* kPose = "Robot pose";

constexpr Format kAbsoluteFormats[] = {{0, "JPP", "joints, %, blending %"},
                                       {1, "CPP", "pose, %, blending %"},
                                       {2, "CPR", "pose, %, blending mm"},
                                       {3, "CAP", "pose, mm/s, blending %"},
                                       {4, "CAR", "pose, mm/s, blending mm"}};
constexpr Format kRelativeFormats[] = {{0, "JPP", "joints, %, blending %"},
                                       {1, "CPP", "in the base, %, blending %"},
                                       {2, "CPR", "in the base, %, blending mm"},
                                       {3, "CAP", "in the base, mm/s, blending %"},
                                       {4, "CAR", "in the base, mm/s, blending mm"},
                                       {5, "TPP", "along the tool, %, blending %"},
                                       {6, "TPR", "along the tool, %, blending mm"},
                                       {7, "TAP", "along the tool, mm/s, blending %"},
                                       {8, "TAR", "along the tool, mm/s, blending mm"}};
constexpr Format kCircleFormats[] = {{0, "CPP", "poses, %, blending %"},
                                     {1, "CAP", "poses, mm/s, blending %"}};

/// The formats that suit the movement command are offered; the fields are those of the one that is chosen.
template <std::size_t N>
void ruleMove(Form& form, const Format (&formats)[N]) {
  std::vector<Option> offered;
  for (const Format& format : formats) {
    if (suits(format, form.whole("movement_command"))) offered.push_back(toOption(format));
  }
  form.offer("data_format", std::move(offered));
  const Format& chosen = formats[form.whole("data_format")];
  showUnits(form, chosen);
  form.showGroup(kTarget, !isInJoints(chosen));
  form.showGroup(kTargetJoints, isInJoints(chosen));
}

void ruleAbsolute(Form& form) {
  ruleMove(form, kAbsoluteFormats);
  const bool free = form.whole("movement_command") == kPtp && form.whole("data_format") != 0;
  form.show("robot_pose_enable", free);
  form.showGroup(kPose, free && form.isOn("robot_pose_enable"));
}

void addRobotPose(std::vector<Field>& fields) {
  fields.push_back(switchField("robot_pose_enable", "Choose the robot pose", false));
  fields.back().hint = "Otherwise the pose at the start is kept";
  for (Field field : {choiceField("config1", "Shoulder", {{0, "Righty"}, {1, "Lefty"}}, 0),
                      choiceField("config2", "Elbow", {{2, "Above"}, {3, "Below"}}, 2),
                      choiceField("config3", "Wrist", {{4, "Noflip"}, {5, "Flip"}}, 4)}) {
    field.group = kPose;
    fields.push_back(std::move(field));
  }
}

template <std::size_t N>
Field formatField(const Format (&formats)[N], int value) {
  std::vector<Option> options;
  std::transform(std::begin(formats), std::end(formats), std::back_inserter(options), toOption);
  return choiceField("data_format", "Format", std::move(options), value);
}

/// A pose in front of an arm of the smaller models, the tool down.
Preset inFront() {
  return {"Preset values",
          {{"movement_command", kPtp},
           {"data_format", 1},
           {"target.0", 400},
           {"target.1", -150},
           {"target.2", 400},
           {"target.3", 180},
           {"target.4", 0},
           {"target.5", 90},
           {"speed_percent", 20},
           {"accel_time", 300},
           {"blending_enable", 0},
           {"precise", 1},
           {"robot_pose_enable", 0}},
          {}};
}

}  // namespace

Form moveAbsoluteForm() {
  std::vector<Field> fields{movementField(), formatField(kAbsoluteFormats, 1)};
  addPose(fields, "target", kTarget);
  addJoints(fields, "joints", kTargetJoints);
  addRobotPose(fields);
  addMotion(fields);
  Form form(std::move(fields), ruleAbsolute, {inFront()});
  form.apply(inFront());
  return form;
}

Form::Rule moveAbsoluteRule() {
  return ruleAbsolute;
}

Form moveRelativeForm() {
  std::vector<Field> fields{movementField(), formatField(kRelativeFormats, 1)};
  addPose(fields, "target", kTarget);
  addJoints(fields, "joints", kTargetJoints);
  addMotion(fields);
  Preset nothing{"Preset values", {{"speed_percent", 20}, {"speed_mm_s", 100}, {"accel_time", 300}}, {}};
  for (const char* prefix : {"target.", "joints."}) {
    for (int i = 0; i < 6; ++i) nothing.numbers[prefix + std::to_string(i)] = 0;
  }
  return Form(std::move(fields), [](Form& form) { ruleMove(form, kRelativeFormats); }, {nothing});
}

Form moveCircleForm() {
  std::vector<Field> fields{formatField(kCircleFormats, 0)};
  addPose(fields, "arc", "Arc position");
  addPose(fields, "end", "End position");
  fields.push_back(numberField("arc_angle", "Arc angle", "°", 0, 360, 0));
  fields.back().hint = "0: to the end position; else by this angle along the circle through it";
  addMotion(fields);
  const Preset half_circle{"Preset values",
                           {{"data_format", 0},
                            {"arc.0", 450},
                            {"arc.1", 0},
                            {"arc.2", 400},
                            {"arc.3", 180},
                            {"arc.4", 0},
                            {"arc.5", 90},
                            {"end.0", 400},
                            {"end.1", 50},
                            {"end.2", 400},
                            {"end.3", 180},
                            {"end.4", 0},
                            {"end.5", 90},
                            {"arc_angle", 0},
                            {"speed_percent", 10},
                            {"accel_time", 300}},
                           {}};
  Form form(std::move(fields), [](Form& f) { showUnits(f, kCircleFormats[f.whole("data_format")]); },
            {half_circle});
  form.apply(half_circle);
  return form;
}

}  // namespace cobot_command::rviz_plugin
