#include "cobot_command/blocks/shared/order.h"

#include <utility>

namespace cobot_command::blocks {

Order settingOrder(script::ScriptCommand command) {
  std::vector<script::ScriptCommand> commands;
  commands.push_back(std::move(command));
  return settingOrder(std::move(commands));
}

Order settingOrder(std::vector<script::ScriptCommand> commands) {
  Order order;
  order.lines.reserve(commands.size());
  for (const script::ScriptCommand& command : commands) order.lines.push_back(script::toText(command));
  order.commands = std::move(commands);
  return order;
}

Order motionOrder(script::ScriptCommand command) {
  Order order = settingOrder(std::move(command));
  order.moves = true;
  return order;
}

Order motionOrder(std::vector<script::ScriptCommand> commands) {
  Order order = settingOrder(std::move(commands));
  order.moves = true;
  return order;
}

}  // namespace cobot_command::blocks
