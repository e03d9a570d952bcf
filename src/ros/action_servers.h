// The action servers of one robot: one for each function block, under the block's name.
#pragma once

#include <memory>
#include <vector>

#include <ros/node_handle.h>

#include "cobot_command/ros/action_bridge.h"

namespace cobot_command::ros_adapter {

/// They serve until they are destroyed. What becomes of a goal has to be told to all: each knows its own.
[[nodiscard]] std::vector<std::unique_ptr<GoalListener>> serveActions(const ros::NodeHandle& node,
                                                                      const JointNames& joint_names,
                                                                      const GoalSink& sink);

}  // namespace cobot_command::ros_adapter
