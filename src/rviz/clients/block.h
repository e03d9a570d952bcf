// A block as its page uses it: what carries it out, and what only plans it.
#pragma once

#include <functional>
#include <memory>

#include "clients/command.h"
#include "forms/form.h"
#include <ros/node_handle.h>

namespace cobot_command::rviz_plugin {

/// Of a page with one form.
struct Block {
  std::unique_ptr<Command> execution;
  std::function<void(const Form&)> execute;
  std::unique_ptr<Command> checking;  ///< nothing: there is nothing to plan
  std::function<void(const Form&)> check;
};

[[nodiscard]] Block connectBlock(const ros::NodeHandle& node);
[[nodiscard]] Block changeBaseBlock(const ros::NodeHandle& node);
[[nodiscard]] Block changeTcpBlock(const ros::NodeHandle& node);
[[nodiscard]] Block moveAbsoluteBlock(const ros::NodeHandle& node);
[[nodiscard]] Block moveRelativeBlock(const ros::NodeHandle& node);
[[nodiscard]] Block moveCircleBlock(const ros::NodeHandle& node);
[[nodiscard]] Block loadPathBlock(const ros::NodeHandle& node);
[[nodiscard]] Block interfaceBlock(const ros::NodeHandle& node);

}  // namespace cobot_command::rviz_plugin
