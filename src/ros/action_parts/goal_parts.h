// The fields that the goal messages of several blocks have, each written out: one that is renamed does not
// compile.
#pragma once

#include <cstddef>
#include <optional>

#include <geometry_msgs/PoseStamped.h>

#include "cobot_command/blocks/shared/goal_values.h"
#include "cobot_command/ros/command/goal_lookups.h"
#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::ros_adapter {

/// `place`: where its frame is.
[[nodiscard]] blocks::FramedPose toFramedPose(const geometry_msgs::PoseStamped& message, FramePlace place);
/// Absent when the message leaves its frame empty.
[[nodiscard]] std::optional<blocks::FramedPose> toFramedPose(const geometry_msgs::PoseStamped& message,
                                                             const FrameLookup& frames);

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

/// More steps than there may be: nothing is looked up for them. The core refuses the goal by their number
/// alone.
template <class Goal, class Steps>
[[nodiscard]] bool hasTooMany(Goal& goal, const Steps& steps) {
  if (steps.size() <= Goal::kMostSteps) return false;
  goal.steps.resize(steps.size());
  return true;
}

}  // namespace cobot_command::ros_adapter
