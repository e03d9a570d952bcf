// The action servers of one robot: one for each function block, under the block's name.
#pragma once

#include <memory>
#include <vector>

#include <ros/node_handle.h>

#include "cobot_command/ros/command/action_bridge.h"

namespace cobot_command::ros_adapter {

/// What each of them is made with.
struct ActionSite {
  const ros::NodeHandle& node;
  const JointNames& joint_names;  ///< of planned motions
  const GoalWay& goals;
  const GoalWay& stops;  ///< of what stops the robot, or holds it: it waits for no other goal
};

/// Serves the action of the block of `Goal`: defined for each in the block's own file, actions/<block>.cpp.
template <class Goal>
[[nodiscard]] std::unique_ptr<GoalListener> serve(const ActionSite& site);

/// In the order of the blocks. They serve until they are destroyed.
[[nodiscard]] std::vector<std::unique_ptr<GoalListener>> serveActions(const ActionSite& site);

}  // namespace cobot_command::ros_adapter
