// A command layer and a simulated controller with a fault proxy between them, joined by loopback.
#pragma once

#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "chain.h"
#include "fault_proxy.h"

#include "cobot_command/blocks/shared/error_catalogue.h"

namespace cobot_command::hostile {

using namespace std::chrono_literals;
using runtime::Robot;

/// What a command runtime has told of its goals and its link.
struct Told {
  std::map<blocks::GoalId, std::vector<blocks::Outcome>> ends;
  std::map<blocks::GoalId, std::set<blocks::Phase>> phases;
  command::CommandStatus status;
  int robot_statuses = 0;

  [[nodiscard]] bool ended(blocks::GoalId goal) const { return ends.count(goal) != 0; }
  [[nodiscard]] bool reached(blocks::GoalId goal, blocks::Phase phase) const {
    const auto found = phases.find(goal);
    return found != phases.end() && found->second.count(phase) != 0;
  }
};

/// Quick ones, and yet longer than a loaded machine keeps anything waiting.
inline link::LinkSettings quickSettings() {
  link::LinkSettings settings;
  settings.open_timeout = 1s;
  settings.retry_min = 20ms;
  settings.retry_max = 100ms;
  settings.reply_timeout = 1500ms;
  settings.supervision_period = 500ms;
  settings.supervision_misses = 6;
  settings.tag_deadline_margin = 1s;
  settings.unplanned_motion_timeout = 20s;
  return settings;
}

/// A command runtime, watched.
class Layer {
 public:
  explicit Layer(int status_port, const link::LinkSettings& settings = quickSettings())
      : runtime_(runtime::testArm(), withStatusPort(settings, status_port),
                 [this](const command::Action& action, Instant /*now*/) { take(action); }) {}

  blocks::GoalId submit(const blocks::Goal& goal) {
    const blocks::GoalId id = ++last_goal_;
    EXPECT_TRUE(runtime_.submit(id, goal));
    return id;
  }
  void cancel(blocks::GoalId goal) { runtime_.cancel(goal); }
  void keepJogging() { runtime_.keepJogging(); }
  void stop() { runtime_.stop(); }

  /// False when it does not become true in time.
  template <class Condition>
  [[nodiscard]] bool waitUntil(Condition condition, Duration within = testing::kDeadline) {
    std::unique_lock<std::mutex> lock(mutex_);
    return changed_.wait_for(lock, within, [&] { return condition(std::as_const(told_)); });
  }
  [[nodiscard]] bool reaches(blocks::GoalId goal, blocks::Phase phase) {
    return waitUntil([&](const Told& told) { return told.reached(goal, phase); });
  }
  [[nodiscard]] std::optional<blocks::Outcome> endOf(blocks::GoalId goal) {
    if (!waitUntil([&](const Told& told) { return told.ended(goal); })) return std::nullopt;
    return told().ends.at(goal).front();
  }
  [[nodiscard]] Told told() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return told_;
  }

 private:
  static link::LinkSettings withStatusPort(link::LinkSettings settings, int port) {
    settings.status_port = port;
    return settings;
  }
  void take(const command::Action& action) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (const auto* const ended = std::get_if<command::GoalEnded>(&action)) {
      told_.ends[ended->goal].push_back(ended->outcome);
    } else if (const auto* const progressed = std::get_if<command::GoalProgressed>(&action)) {
      told_.phases[progressed->goal].insert(progressed->progress.phase);
    } else if (const auto* const changed = std::get_if<command::StatusChanged>(&action)) {
      told_.status = changed->status;
    } else if (std::holds_alternative<command::RobotStatusReceived>(action)) {
      ++told_.robot_statuses;
    } else {
      return;
    }
    changed_.notify_all();
  }

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Told told_;
  blocks::GoalId last_goal_ = 0;
  runtime::CommandRuntime runtime_;
};

/// Real seconds are so much shorter than those of the simulated arm.
inline constexpr double kTimeScale = 10;

inline simulator::Settings robotSettings() {
  simulator::Settings settings;
  settings.status_period = fromSeconds(0.03 * kTimeScale);
  settings.reentry_delay.reset();  // a node that was left stays left, so that it can be seen
  return settings;
}

class HostileRig {
 public:
  explicit HostileRig(unsigned seed)
      : proxy({robot().ports().script, robot().ports().status}, seed), layer(proxy.ports().status) {}

  [[nodiscard]] Robot& robot() {
    if (!robot_) robot_.emplace(kTimeScale, runtime::SimulatorPorts{}, robotSettings());
    return *robot_;
  }
  void operate(const simulator::OperatorAction& action) {
    robot().operate([action](auto& controller, Instant now) { controller.operate(action, now); });
  }
  /// A fault of the simulated controller itself.
  void setFault(const std::string& name) {
    simulator::SetFault fault;
    fault.name = name;
    operate(fault);
  }
  /// The power goes off and on again: ids, tags and posture begin anew.
  void restartRobot() {
    const auto ports = robot().ports();
    robot_.reset();
    robot_.emplace(kTimeScale, ports, robotSettings());
  }
  [[nodiscard]] blocks::ConnectGoal controller() const { return {"127.0.0.1", proxy.ports().script, 10, {}}; }
  /// A connect goal that is Connected, with a status stream; fails when it cannot be.
  [[nodiscard]] blocks::GoalId connect() {
    const int before = layer.told().robot_statuses;
    const auto goal = layer.submit(controller());
    EXPECT_TRUE(layer.waitUntil([&](const Told& told) {
      return told.ended(goal) ||
             (told.reached(goal, blocks::Phase::Connected) && told.robot_statuses > before);
    }));
    EXPECT_FALSE(layer.told().ended(goal)) << "the connect goal ended: " << layer.told().status.diagnosis;
    return goal;
  }

 private:
  std::optional<Robot> robot_;

 public:
  testing::FaultProxy proxy;
  Layer layer;
};

}  // namespace cobot_command::hostile
