#include "cobot_command/blocks/shared/order.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace cobot_command::blocks {
namespace {

/// Of what has speeds: the motions but PVTs and velocities, which have no such options.
template <class Command>
auto optionsOf(Command& command, int /*preferred*/) -> decltype(&command.options) {
  return &command.options;
}
template <class Command>
script::MotionOptions* optionsOf(Command& /*command*/, long /*otherwise*/) {
  return nullptr;
}

void slow(script::ScriptCommand& command, double share) {
  constexpr double kRounding = 1e-9;  // 29 % of 100 is 29
  script::MotionOptions* const options = std::visit([](auto& c) { return optionsOf(c, 0); }, command);
  if (options == nullptr) return;
  options->speed = std::max(1, static_cast<int>(std::floor(options->speed * share + kRounding)));
}

}  // namespace

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

Order moveOrder(script::ScriptCommand command) {
  Order order = motionOrder(std::move(command));
  order.takes_override = true;
  return order;
}

Order motionOrder(std::vector<script::ScriptCommand> commands) {
  Order order = settingOrder(std::move(commands));
  order.moves = true;
  return order;
}

Order slowed(Order order, double share) {
  if (!order.takes_override || share >= 1.0) return order;
  order.speed_share = share;
  for (std::size_t i = 0; i < order.commands->size(); ++i) {
    script::ScriptCommand& command = (*order.commands)[i];
    slow(command, share);
    order.lines[i] = script::toText(command);
  }
  return order;
}

}  // namespace cobot_command::blocks
