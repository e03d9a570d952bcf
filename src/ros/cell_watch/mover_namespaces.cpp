#include "cell_watch/mover_namespaces.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <ros/names.h>

#include "cobot_command/common/given.h"

namespace cobot_command::ros_adapter {
namespace {

/// Longer than any status stream is silent by itself.
constexpr Duration kSilence = std::chrono::seconds(1);

std::string absolute(const std::string& space) {
  return space.empty() || space.front() == '/' ? space : '/' + space;
}

/// Of a node, "/RA/command_node": "/RA"; of "/command_node" "".
std::string spaceOf(const std::string& node) {
  const auto end = node.rfind('/');
  return end == std::string::npos ? "" : node.substr(0, end);
}

}  // namespace

Result<MoverNamespaces, std::string> MoverNamespaces::of(const cell::Cell& cell) {
  std::vector<Mover> movers;
  std::set<std::string> spaces;
  for (const cell::Robot& robot : cell.robots) {
    const std::string space = absolute(robot.name_space);
    std::string reason;
    if (!ros::names::validate(space, reason)) {
      return refuse(
          fmt::format("robots.{}.namespace is {}; allowed: a ROS name of letters, digits, _ and /, that "
                      "begins with a letter or /",
                      robot.name, quoted(robot.name_space)));
    }
    if (!spaces.insert(space).second) {
      return refuse(fmt::format(
          "robots.{}.namespace is {}, the same as for another robot; give each robot its own namespace",
          robot.name, quoted(robot.name_space)));
    }
    movers.push_back({robot.name, space, false, std::nullopt});
  }
  for (const cell::Mechanism& mechanism : cell.mechanisms) {
    const std::string space = absolute(mechanism.name);
    if (!spaces.insert(space).second) {
      return refuse(
          fmt::format("mechanisms.{} is expected in the namespace {}, which belongs to a robot; give the "
                      "robot another namespace",
                      mechanism.name, quoted(space)));
    }
    movers.push_back({mechanism.name, space, true, std::nullopt});
  }
  return MoverNamespaces(std::move(movers));
}

std::optional<std::size_t> MoverNamespaces::reported(const std::string& name, const std::string& node,
                                                     Instant now) {
  const std::string space = spaceOf(node);
  // One of them would be taken for the other.
  const auto is_there = [&](const Mover& one) { return one.name != name && one.space == space; };
  if (std::any_of(movers_.begin(), movers_.end(), is_there)) return std::nullopt;
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    Mover& known = movers_[i];
    if (known.name != name) continue;
    const bool is_heard = known.heard && now - *known.heard < kSilence;
    // Nor back and forth between two that report for it.
    const bool is_new_here = known.moved && now - *known.moved < kSilence;
    if (known.space == space || is_heard || is_new_here) return std::nullopt;
    known.space = space;
    known.heard.reset();
    known.moved = now;
    return i;
  }
  return std::nullopt;
}

}  // namespace cobot_command::ros_adapter
