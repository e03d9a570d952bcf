// The whole chain without ROS: a command runtime and a simulated controller, joined by loopback.
#pragma once

#include <algorithm>
#include <functional>
#include <future>
#include <optional>
#include <utility>
#include <vector>

#include "event_log.h"
#include "motion_goals.h"
#include <gtest/gtest.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/runtime/command/command_runtime.h"
#include "cobot_command/runtime/simulation/simulator_runtime.h"

namespace cobot_command::runtime {

inline arm::ArmModel testArm() {
  return *arm::ArmModel::named("tm5-900");
}

/// A simulated controller on given ports, or on any.
class Robot {
 public:
  explicit Robot(double time_scale, SimulatorPorts ports = {}, simulator::Settings settings = {})
      : runtime_(testArm(), std::move(settings), optionsFor(time_scale, ports)) {
    const auto started = runtime_.start();
    EXPECT_TRUE(started.has_value()) << started.error().message;
    ports_ = started.value_or(SimulatorPorts{});
  }
  [[nodiscard]] SimulatorPorts ports() const { return ports_; }
  void powerOff() { runtime_.stop(); }
  bool operate(SimulatorRuntime::Operation operation) { return runtime_.post(std::move(operation)); }
  /// Where it truly is.
  [[nodiscard]] simulator::RobotState state() {
    std::promise<simulator::RobotState> state;
    EXPECT_TRUE(operate([&](auto& controller, Instant) { state.set_value(controller.state()); }));
    return state.get_future().get();
  }

 private:
  static SimulatorOptions optionsFor(double time_scale, SimulatorPorts ports) {
    SimulatorOptions options;
    options.script_port = ports.script;
    options.status_port = ports.status;
    options.time_scale = time_scale;
    return options;
  }

  SimulatorRuntime runtime_;
  SimulatorPorts ports_;
};

/// A command runtime that keeps everything it is told.
class Commander {
 public:
  explicit Commander(int status_port, const link::LinkSettings& settings = {})
      : runtime_(testArm(), withStatusPort(settings, status_port),
                 [this](const command::Action& action, Instant /*now*/) { log_.add(action); }) {}

  blocks::GoalId submit(const blocks::Goal& goal) {
    EXPECT_TRUE(runtime_.submit(++last_goal_, goal));
    return last_goal_;
  }
  void cancel(blocks::GoalId goal) { runtime_.cancel(goal); }
  void stop() { runtime_.stop(); }
  [[nodiscard]] CommandRuntime& runtime() { return runtime_; }

  /// Waits for the end of the goal.
  [[nodiscard]] std::optional<blocks::Outcome> outcomeOf(blocks::GoalId goal) {
    std::optional<blocks::Outcome> outcome;
    EXPECT_TRUE(waitFor<command::GoalEnded>([&](const command::GoalEnded& ended) {
      outcome = ended.outcome;
      return ended.goal == goal;
    })) << "goal "
        << goal << " has no end";
    return outcome;
  }
  [[nodiscard]] bool reaches(blocks::GoalId goal, blocks::Phase phase) {
    return waitFor<command::GoalProgressed>([&](const command::GoalProgressed& progressed) {
      return progressed.goal == goal && progressed.progress.phase == phase;
    });
  }
  /// Connects to a robot and waits until it listens and tells its status; the goal that stays Busy.
  [[nodiscard]] blocks::GoalId connect(SimulatorPorts ports) {
    const auto goal = submit(blocks::ConnectGoal{"127.0.0.1", ports.script, 60, {}});
    EXPECT_TRUE(reaches(goal, blocks::Phase::Connected));
    EXPECT_TRUE(waitFor<command::RobotStatusReceived>([](const auto&) { return true; }));
    return goal;
  }
  [[nodiscard]] std::optional<blocks::Outcome> run(const blocks::Goal& goal) {
    return outcomeOf(submit(goal));
  }

  template <class Kind, class Condition>
  [[nodiscard]] bool waitFor(Condition condition) {
    return log_.waitUntil([&](const std::vector<command::Action>& actions) {
      return std::any_of(actions.begin(), actions.end(), [&](const command::Action& action) {
        const auto* const wanted = std::get_if<Kind>(&action);
        return wanted != nullptr && condition(*wanted);
      });
    });
  }
  template <class Kind>
  [[nodiscard]] std::vector<Kind> told() const {
    std::vector<Kind> kinds;
    for (const auto& action : log_.events()) {
      if (const auto* const wanted = std::get_if<Kind>(&action)) {
        kinds.push_back(*wanted);
      }
    }
    return kinds;
  }
  [[nodiscard]] std::size_t submitted() const { return last_goal_; }
  [[nodiscard]] std::size_t toldCount() const { return log_.events().size(); }

 private:
  static link::LinkSettings withStatusPort(link::LinkSettings settings, int port) {
    settings.status_port = port;
    return settings;
  }

  testing::EventLog<command::Action> log_;
  blocks::GoalId last_goal_ = 0;
  CommandRuntime runtime_;
};

using testing::moveJoints;

/// A line to where the flange would be at these joints, moved by `offset` [mm].
inline blocks::MoveAbsoluteGoal moveLine(const std::array<double, 6>& joints_deg,
                                         const std::array<double, 3>& offset, double speed_mm_s = 200) {
  blocks::MoveAbsoluteGoal goal;
  goal.movement_command = static_cast<int>(blocks::Movement::Line);
  goal.data_format = static_cast<int>(blocks::AbsoluteFormat::Cap);
  goal.target = arm::toControllerPose(arm::forwardKinematics(testArm(), arm::toJointVector(joints_deg)));
  std::transform(offset.begin(), offset.end(), goal.target.begin(), goal.target.begin(), std::plus<>());
  goal.speed = speed_mm_s;
  goal.accel_time = 200;
  return goal;
}

/// The simulated arm starts here.
inline constexpr std::array<double, 6> kStartJoints{0, 0, 90, 0, 90, 0};
/// At 1 % and real time this takes the better part of a minute: long enough for anything to happen on the
/// way.
inline blocks::MoveAbsoluteGoal endlessMove() {
  return moveJoints({90, 0, 90, 0, 90, 0}, 1);
}

}  // namespace cobot_command::runtime
