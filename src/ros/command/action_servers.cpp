#include "command/action_servers.h"

#include "cobot_command/blocks/list/goal.h"

namespace cobot_command::ros_adapter {
namespace {

template <class... Goals>
std::vector<std::unique_ptr<GoalListener>> serveAll(const ActionSite& site,
                                                    const std::variant<Goals...>* /*list*/) {
  std::vector<std::unique_ptr<GoalListener>> servers;
  (servers.push_back(serve<Goals>(site)), ...);
  return servers;
}

}  // namespace

std::vector<std::unique_ptr<GoalListener>> serveActions(const ActionSite& site) {
  return serveAll(site, static_cast<const blocks::Goal*>(nullptr));
}

}  // namespace cobot_command::ros_adapter
