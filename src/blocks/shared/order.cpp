#include "cobot_command/blocks/shared/order.h"

#include <utility>

namespace cobot_command::blocks {

Order settingOrder(script::ScriptCommand command) {
  Order order;
  order.lines.push_back(script::toText(command));
  order.commands.emplace().push_back(std::move(command));
  return order;
}

Order motionOrder(script::ScriptCommand command) {
  Order order = settingOrder(std::move(command));
  order.moves = true;
  return order;
}

}  // namespace cobot_command::blocks
