#include "clients/command.h"

#include <utility>

namespace cobot_command::rviz_plugin {

void Command::become(CommandState state) {
  state_ = std::move(state);
  if (listener_) listener_();
}

void Command::become(CommandState state, Plan plan) {
  plan_ = std::move(plan);
  become(std::move(state));
}

}  // namespace cobot_command::rviz_plugin
