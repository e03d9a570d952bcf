#include "cobot_command/ros/goal_messages.h"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cobot_command/blocks/goal_limits.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/ros/conversions.h"

namespace cobot_command::ros_adapter {
namespace {

/// Absent when the message leaves its frame empty.
std::optional<blocks::FramedPose> toFramedPose(const geometry_msgs::PoseStamped& message,
                                               const FrameLookup& frames) {
  if (message.header.frame_id.empty()) return std::nullopt;
  const auto& position = message.pose.position;
  const auto& quaternion = message.pose.orientation;
  FramePlace place = frames(message.header);
  blocks::FramedPose pose;
  pose.frame = message.header.frame_id;
  pose.position = {position.x, position.y, position.z};
  pose.quaternion = {quaternion.x, quaternion.y, quaternion.z, quaternion.w};
  pose.frame_in_robot_base = std::move(place.in_robot_base);
  pose.fault = std::move(place.fault);
  pose.latest = message.header.stamp.isZero();
  return pose;
}

/// What all commands have that wait for their turn and may leave the Listen node.
template <class Goal, class Message>
void takeCommand(Goal& goal, const Message& message) {
  goal.command_id = message.command_id;
  goal.exit_node = message.exit_node != 0;
  goal.buffer_mode = message.buffer_mode;
}

/// What all moves have.
template <class Goal, class Message>
void takeMotion(Goal& goal, const Message& message) {
  takeCommand(goal, message);
  goal.data_format = message.data_format;
  goal.speed = message.speed;
  goal.accel_time = message.accel_time;
  goal.blending_enable = message.blending_enable != 0;
  goal.blending_value = message.blending_value;
  goal.disable_precise_positioning = message.disable_precise_positioning != 0;
  goal.check_only = message.check_only != 0;
}

template <class Goal, class Message>
void takeTarget(Goal& goal, const Message& message) {
  goal.movement_command = message.movement_command;
  goal.target = toSix(message.target_position);
}

blocks::PickAndPlaceStep toStep(const cobot_command::PickAndPlaceStep& message, const Lookups& lookups) {
  blocks::PickAndPlaceStep step;
  step.move = toGoal(message.move, lookups);
  if (!message.output.module.empty()) {
    step.output = {message.output.module, message.output.output, message.output.value != 0};
  }
  step.dwell = message.dwell;
  return step;
}

/// Absent when the message names a kind that there is not.
std::optional<blocks::SequenceStep> toStep(const cobot_command::SequenceStep& message,
                                           const Lookups& lookups) {
  using Message = cobot_command::SequenceStep;
  switch (message.kind) {
    case Message::MOVE_ABSOLUTE:
      return toGoal(message.move_absolute, lookups);
    case Message::MOVE_RELATIVE:
      return toGoal(message.move_relative, lookups);
    case Message::MOVE_CIRCLE:
      return toGoal(message.move_circle, lookups);
    case Message::CHANGE_BASE:
      return toGoal(message.change_base, lookups);
    case Message::CHANGE_TCP:
      return toGoal(message.change_tcp, lookups);
    default:
      return std::nullopt;
  }
}

/// More steps than there may be: nothing is looked up for them. The core refuses the goal by their number
/// alone.
template <class Goal, class Steps>
bool hasTooMany(Goal& goal, const Steps& steps, std::size_t most) {
  if (steps.size() <= most) return false;
  goal.steps.resize(steps.size());
  return true;
}

}  // namespace

blocks::ConnectGoal toGoal(const cobot_command::ConnectGoal& message, const Lookups& /*lookups*/) {
  blocks::ConnectGoal goal;
  goal.host = message.host;
  goal.port = message.port;
  goal.timeout = message.timeout;
  if (message.status_port != 0) goal.status_port = message.status_port;
  return goal;
}

blocks::MoveAbsoluteGoal toGoal(const cobot_command::MoveAbsoluteGoal& message, const Lookups& lookups) {
  blocks::MoveAbsoluteGoal goal;
  takeMotion(goal, message);
  takeTarget(goal, message);
  goal.target_pose = toFramedPose(message.target_pose, lookups.frames);
  goal.robot_pose_enable = message.robot_pose_enable != 0;
  goal.robot_pose = {message.robot_pose.config1, message.robot_pose.config2, message.robot_pose.config3};
  return goal;
}

blocks::MoveRelativeGoal toGoal(const cobot_command::MoveRelativeGoal& message, const Lookups& /*lookups*/) {
  blocks::MoveRelativeGoal goal;
  takeMotion(goal, message);
  takeTarget(goal, message);
  return goal;
}

blocks::MoveCircleGoal toGoal(const cobot_command::MoveCircleGoal& message, const Lookups& lookups) {
  blocks::MoveCircleGoal goal;
  takeMotion(goal, message);
  goal.arc_point = toSix(message.arc_point);
  goal.end_point = toSix(message.end_point);
  goal.arc_pose = toFramedPose(message.arc_pose, lookups.frames);
  goal.end_pose = toFramedPose(message.end_pose, lookups.frames);
  goal.arc_angle = message.arc_angle;
  return goal;
}

blocks::ChangeBaseGoal toGoal(const cobot_command::ChangeBaseGoal& message, const Lookups& lookups) {
  blocks::ChangeBaseGoal goal;
  takeCommand(goal, message);
  goal.transformation = toSix(message.transformation);
  goal.base_pose = toFramedPose(message.base_pose, lookups.frames);
  goal.base_name = message.base_name;
  return goal;
}

blocks::ChangeTcpGoal toGoal(const cobot_command::ChangeTCPGoal& message, const Lookups& /*lookups*/) {
  blocks::ChangeTcpGoal goal;
  takeCommand(goal, message);
  goal.tcp_offset = toSix(message.tcp_offset);
  goal.weight = message.weight;
  goal.moment_of_inertia = {message.moment_of_inertia.ixx, message.moment_of_inertia.iyy,
                            message.moment_of_inertia.izz};
  goal.mass_center = toSix(message.mass_center);
  goal.tcp_name = message.tcp_name;
  return goal;
}

blocks::ProgramControlGoal toGoal(const cobot_command::ProgramControlGoal& message,
                                  const Lookups& /*lookups*/) {
  return {message.command_id, message.command};
}

blocks::StopGoal toGoal(const cobot_command::StopGoal& /*message*/, const Lookups& /*lookups*/) {
  return {};
}

blocks::ExitListenNodeGoal toGoal(const cobot_command::ExitListenNodeGoal& message,
                                  const Lookups& /*lookups*/) {
  return {message.buffer_mode};
}

blocks::RunScriptGoal toGoal(const cobot_command::RunScriptGoal& message, const Lookups& /*lookups*/) {
  return {message.script, message.await_motion != 0, message.reply_timeout, message.buffer_mode};
}

blocks::CheckSequenceGoal toGoal(const cobot_command::CheckSequenceGoal& message, const Lookups& lookups) {
  blocks::CheckSequenceGoal goal;
  goal.start_joints = message.start_joints;
  if (hasTooMany(goal, message.steps, blocks::kMostSequenceSteps)) return goal;
  for (std::size_t i = 0; i < message.steps.size(); ++i) {
    if (auto step = toStep(message.steps[i], lookups)) {
      goal.steps.push_back(std::move(*step));
    } else if (goal.steps_fault.empty()) {
      goal.steps_fault = fmt::format("step {}: kind is {}; allowed: 0 to 4, as in SequenceStep.msg", i + 1,
                                     message.steps[i].kind);
      goal.faulty_step = static_cast<int>(i);
    }
  }
  return goal;
}

blocks::PickAndPlaceGoal toGoal(const cobot_command::PickAndPlaceGoal& message, const Lookups& lookups) {
  blocks::PickAndPlaceGoal goal;
  goal.cycles = message.cycles;
  goal.buffer_mode = message.buffer_mode;
  goal.check_only = message.check_only != 0;
  if (message.steps_file.empty()) {
    if (hasTooMany(goal, message.steps, blocks::kMostCycleSteps)) return goal;
    for (const auto& step : message.steps) goal.steps.push_back(toStep(step, lookups));
    return goal;
  }
  if (!message.steps.empty()) {
    goal.steps_fault = "both steps_file and steps are given; give one of them";
    return goal;
  }
  auto steps = lookups.steps(message.steps_file);
  if (!steps) {
    goal.steps_fault = foreignText(message.steps_file) + ": it could not be read in the time there was";
  } else if (*steps) {
    goal.steps = std::move(**steps);
  } else {
    goal.steps_fault = steps->error();
  }
  return goal;
}

}  // namespace cobot_command::ros_adapter
