#include "forms/motion_fields.h"
#include "goals/goals.h"

#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::rviz_plugin {
namespace {

/// What all moves have.
template <class Goal>
void fillMotion(Goal& goal, const Form& form) {
  goal.data_format = form.whole("data_format");
  goal.speed = form.whole(form.field("speed_mm_s").shown ? "speed_mm_s" : "speed_percent");
  goal.accel_time = form.whole("accel_time");
  goal.blending_enable = form.field("blending_enable").shown && form.isOn("blending_enable");
  goal.blending_value = form.whole(form.field("blending_mm").shown ? "blending_mm" : "blending_percent");
  // The sense of the field is the contrary of its name: true settles not.
  goal.disable_precise_positioning = !form.isOn("precise");
  if (form.has("buffer_mode")) goal.buffer_mode = form.whole("buffer_mode");
}

cobot_command::Transformation targetOf(const Form& form) {
  return ros_adapter::toTransformation(form.six(form.field("joints.0").shown ? "joints" : "target"));
}

template <class Goal>
cobot_command::CheckSequenceGoal checkOf(const Goal& goal, std::uint8_t kind,
                                         Goal cobot_command::SequenceStep::*part) {
  cobot_command::CheckSequenceGoal check;
  check.steps.resize(1);
  check.steps.front().kind = kind;
  check.steps.front().*part = goal;
  return check;
}

}  // namespace

cobot_command::MoveAbsoluteGoal toMoveAbsolute(const Form& form) {
  cobot_command::MoveAbsoluteGoal goal;
  fillMotion(goal, form);
  goal.movement_command = form.whole("movement_command");
  goal.target_position = targetOf(form);
  goal.robot_pose_enable = form.field("robot_pose_enable").shown && form.isOn("robot_pose_enable");
  goal.robot_pose.config1 = form.whole("config1");
  goal.robot_pose.config2 = form.whole("config2");
  goal.robot_pose.config3 = form.whole("config3");
  return goal;
}

cobot_command::MoveRelativeGoal toMoveRelative(const Form& form) {
  cobot_command::MoveRelativeGoal goal;
  fillMotion(goal, form);
  goal.movement_command = form.whole("movement_command");
  goal.target_position = targetOf(form);
  return goal;
}

cobot_command::MoveCircleGoal toMoveCircle(const Form& form) {
  cobot_command::MoveCircleGoal goal;
  fillMotion(goal, form);
  goal.arc_point = ros_adapter::toTransformation(form.six("arc"));
  goal.end_point = ros_adapter::toTransformation(form.six("end"));
  goal.arc_angle = form.number("arc_angle");
  return goal;
}

cobot_command::CheckSequenceGoal toCheck(const cobot_command::MoveAbsoluteGoal& goal) {
  return checkOf(goal, cobot_command::SequenceStep::MOVE_ABSOLUTE,
                 &cobot_command::SequenceStep::move_absolute);
}

cobot_command::CheckSequenceGoal toCheck(const cobot_command::MoveRelativeGoal& goal) {
  return checkOf(goal, cobot_command::SequenceStep::MOVE_RELATIVE,
                 &cobot_command::SequenceStep::move_relative);
}

cobot_command::CheckSequenceGoal toCheck(const cobot_command::MoveCircleGoal& goal) {
  return checkOf(goal, cobot_command::SequenceStep::MOVE_CIRCLE, &cobot_command::SequenceStep::move_circle);
}

}  // namespace cobot_command::rviz_plugin
