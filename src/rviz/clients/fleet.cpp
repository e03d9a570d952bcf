#include "clients/fleet.h"

#include <algorithm>
#include <map>
#include <string>

#include "clients/action_command.h"
#include <cobot_command/StopAction.h>
#include <fmt/format.h>

namespace cobot_command::rviz_plugin {
namespace {

ros::NodeHandle handleOf(const std::string& name, ros::CallbackQueue& queue) {
  ros::NodeHandle node(name);
  node.setCallbackQueue(&queue);
  return node;
}

bool failed(const CommandState& state) {
  return state.phase == CommandState::Phase::Error || state.unanswered;
}

}  // namespace

struct Fleet::Member {
  Member(const std::string& name, ros::CallbackQueue& queue)
      : stop(handleOf(name, queue), "stop", Unanswered::Kept) {}

  ActionCommand<cobot_command::StopAction> stop;
};

Fleet::Fleet() = default;
Fleet::~Fleet() = default;

void Fleet::offer(const std::vector<std::string>& names) {
  const bool are_many = names.size() > 1;
  for (auto it = robots_.begin(); it != robots_.end();) {
    const bool there = are_many && std::find(names.begin(), names.end(), it->first) != names.end();
    // One that has gone in the middle of a stop is still told of.
    it = there || it->second->stop.isBusy() ? std::next(it) : robots_.erase(it);
  }
  for (const std::string& name : names) {
    if (are_many && robots_.count(name) == 0) robots_.emplace(name, std::make_unique<Member>(name, queue_));
  }
}

void Fleet::stop() {
  for (const auto& [name, robot] : robots_) robot->stop.send({});
}

void Fleet::look() {
  queue_.callAvailable();
  for (const auto& [name, robot] : robots_) robot->stop.look();
}

std::string Fleet::told() const {
  int asked = 0;
  int done = 0;
  std::map<std::string, std::string> not_stopped;  // names by what is known of them
  for (const auto& [name, robot] : robots_) {
    const CommandState& state = robot->stop.state();
    if (state.phase == CommandState::Phase::Idle) continue;
    ++asked;
    if (state.phase == CommandState::Phase::Done) ++done;
    if (!failed(state)) continue;
    std::string& names =
        not_stopped[state.unanswered ? "use the emergency stop: " + state.text : state.description];
    names += (names.empty() ? "" : ", ") + name;
  }
  if (asked == 0) return "";
  std::string text = fmt::format("{} of {} robots stopped", done, asked);
  for (const auto& [why, names] : not_stopped) text += fmt::format("; {}: {}", names, why);
  return text;
}

bool Fleet::isBusy() const {
  return std::any_of(robots_.begin(), robots_.end(),
                     [](const auto& robot) { return robot.second->stop.isBusy(); });
}

void Fleet::forget() {
  for (const auto& [name, robot] : robots_) robot->stop.forget();
}

bool Fleet::hasFailed() const {
  return std::any_of(robots_.begin(), robots_.end(),
                     [](const auto& robot) { return failed(robot.second->stop.state()); });
}

}  // namespace cobot_command::rviz_plugin
