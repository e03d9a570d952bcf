#include <utility>

#include "clients/action_command.h"
#include "clients/block.h"
#include "goals/goals.h"
#include <cobot_command/ChangeBaseAction.h>
#include <cobot_command/ChangeTCPAction.h>
#include <cobot_command/CheckSequenceAction.h>
#include <cobot_command/ConnectAction.h>
#include <cobot_command/ExchangeConfigurationAction.h>
#include <cobot_command/LoadPathAction.h>
#include <cobot_command/MoveAbsoluteAction.h>
#include <cobot_command/MoveCircleAction.h>
#include <cobot_command/MoveRelativeAction.h>

namespace cobot_command::rviz_plugin {
namespace {

/// `to_goal`: Form → goal of the action.
template <class Action, class ToGoal>
Block blockOf(const ros::NodeHandle& node, const char* name, ToGoal to_goal) {
  auto command = std::make_unique<ActionCommand<Action>>(node, name);
  Block block;
  block.execute = [&sender = *command, to_goal](const Form& form) { sender.send(to_goal(form)); };
  block.execution = std::move(command);
  return block;
}

/// The check of a move goes through check_sequence, which also tells where an offending point is.
template <class Action, class ToGoal>
Block moveOf(const ros::NodeHandle& node, const char* name, ToGoal to_goal) {
  Block block = blockOf<Action>(node, name, to_goal);
  auto checking = std::make_unique<ActionCommand<cobot_command::CheckSequenceAction>>(node, "check_sequence");
  block.check = [&sender = *checking, to_goal](const Form& form) { sender.send(toCheck(to_goal(form))); };
  block.checking = std::move(checking);
  return block;
}

}  // namespace

Block connectBlock(const ros::NodeHandle& node) {
  return blockOf<cobot_command::ConnectAction>(node, "connect", toConnect);
}

Block changeBaseBlock(const ros::NodeHandle& node) {
  return blockOf<cobot_command::ChangeBaseAction>(node, "change_base", toChangeBase);
}

Block changeTcpBlock(const ros::NodeHandle& node) {
  return blockOf<cobot_command::ChangeTCPAction>(node, "change_tcp", toChangeTcp);
}

Block moveAbsoluteBlock(const ros::NodeHandle& node) {
  return moveOf<cobot_command::MoveAbsoluteAction>(node, "move_absolute", toMoveAbsolute);
}

Block moveRelativeBlock(const ros::NodeHandle& node) {
  return moveOf<cobot_command::MoveRelativeAction>(node, "move_relative", toMoveRelative);
}

Block moveCircleBlock(const ros::NodeHandle& node) {
  return moveOf<cobot_command::MoveCircleAction>(node, "move_circle", toMoveCircle);
}

Block loadPathBlock(const ros::NodeHandle& node) {
  Block block = blockOf<cobot_command::LoadPathAction>(
      node, "load_path", [](const Form& form) { return toLoadPath(form, false); });
  auto checking = std::make_unique<ActionCommand<cobot_command::LoadPathAction>>(node, "load_path");
  block.check = [&sender = *checking](const Form& form) { sender.send(toLoadPath(form, true)); };
  block.checking = std::move(checking);
  return block;
}

Block interfaceBlock(const ros::NodeHandle& node) {
  return blockOf<cobot_command::ExchangeConfigurationAction>(node, "exchange_configuration", toInterface);
}

}  // namespace cobot_command::rviz_plugin
