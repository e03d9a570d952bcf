// A core with tool 3 and frame 4 that the controller's project knows by name, and an interface that is
// enabled.
#pragma once

#include <algorithm>
#include <functional>
#include <string>

#include "block_goals.h"
#include "core_and_robot.h"
#include <gmock/gmock.h>

#include "cobot_command/blocks/exchange_configuration.h"

namespace cobot_command::testing {

using namespace std::chrono_literals;

inline constexpr int kTool = 3;
inline constexpr int kFrame = 4;

/// A path of 50 mm of the gripper, from where the arm stands straight up.
inline blocks::LoadPathGoal withTheGripper(double speed) {
  blocks::LoadPathGoal goal;
  path::PathPoint point = pathLine({417.5, -122.3, 261.05, 180, 0, 90});
  point.pose_type = static_cast<int>(path::MovedFrame::Tool);
  point.pose_id = kTool;
  point.speed = speed;
  goal.path = {point};
  goal.number_of_moves = 1;
  return goal;
}

class SynchronisedRobot : public CoreAndRobot {
 public:
  explicit SynchronisedRobot(const command::ExchangeRules& rules = {}, const std::string& tmflow = "1.80")
      : CoreAndRobot("tm5-900", project(tmflow)) {
    useRules(rules);
    writeLoad(2);
    writeTool({0, 0, 150, 0, 0, 0});
    writeFrame({400, 100, 0, 0, 0, 0});
    connect();
    operate(
        simulator::SetLoad{"gripper", 2, std::array<double, 3>{0, 0, 0}, arm::ControllerPose{0, 0, -150}});
  }

  [[nodiscard]] static simulator::Settings project(const std::string& tmflow) {
    simulator::Settings settings;
    settings.tmflow_version = tmflow;
    settings.tcps["gripper"] = arm::toPose({0, 0, 150, 0, 0, 0});
    settings.bases["table"] = arm::toPose({400, 100, 0, 0, 0, 0});
    return settings;
  }

  void writeLoad(double mass) {
    tables::Load load;
    load.mass = mass;
    ASSERT_TRUE(write({1, std::optional(load)}));
  }
  void writeTool(const arm::ControllerPose& pose, const std::string& name = "gripper") {
    tables::Tool tool;
    tool.name = name;
    tool.pose = arm::toPose(pose);
    tool.load = 1;
    ASSERT_TRUE(write({kTool, std::optional(tool)}));
  }
  void writeFrame(const arm::ControllerPose& pose) {
    tables::Frame frame;
    frame.name = "table";
    frame.pose = arm::toPose(pose);
    ASSERT_TRUE(write({kFrame, std::optional(frame)}));
  }

  // --- The pendant.
  void setTcp(const arm::ControllerPose& pose) { operate(simulator::SetTcp{"gripper", pose}); }
  void setBase(const arm::ControllerPose& pose) { operate(simulator::SetBase{"table", pose}); }

  /// With tools and what `change` says.
  blocks::GoalId enable(const std::function<void(blocks::ExchangeSettings&)>& change = {}) {
    settings_ = good<blocks::ExchangeConfigurationGoal>().settings;
    settings_.data_enable_sync.tools = settings_.data_in_sync.tools = true;
    if (change) change(settings_);
    blocks::ExchangeConfigurationGoal goal;
    goal.settings = settings_;
    exchange_ = submit(goal);
    pass(100ms);
    return exchange_;
  }
  /// Other settings than those that rule.
  command::ExchangeAnswer change(const std::function<void(blocks::ExchangeSettings&)>& change) {
    change(settings_);
    return update(settings_);
  }
  /// As told last.
  blocks::ExchangeReport report() {
    return progress(exchange_).empty() ? blocks::ExchangeReport()
                                       : progress(exchange_).back().detail.as<blocks::ExchangeReport>();
  }
  [[nodiscard]] blocks::RiState riState() const { return group().ri_state; }
  [[nodiscard]] arm::ControllerPose tool() const {
    return arm::toControllerPose(*tables().entries().tools[kTool]->pose);
  }
  /// Of the scripts that were sent, those with that in them.
  [[nodiscard]] int countSent(const std::string& part) const {
    return static_cast<int>(std::count_if(scripts().begin(), scripts().end(), [&](const std::string& script) {
      return script.find(part) != std::string::npos;
    }));
  }
  [[nodiscard]] int countMessages(int code) const {
    return static_cast<int>(std::count_if(messages().begin(), messages().end(),
                                          [&](const auto& message) { return message.code == code; }));
  }
  [[nodiscard]] int errorOf(blocks::GoalId id) const {
    return outcome(id) == nullptr ? -1 : outcome(id)->error_id;
  }
  /// A line of 20 mm/s that goes up, in its own time.
  blocks::GoalId line(double length_mm, blocks::BufferMode mode = blocks::BufferMode::Buffered) {
    auto goal = good<blocks::MoveRelativeGoal>();
    goal.movement_command = static_cast<int>(blocks::Movement::Line);
    goal.data_format = static_cast<int>(blocks::RelativeFormat::Cap);
    goal.target = {0, 0, length_mm, 0, 0, 0};
    goal.speed = 20;
    goal.buffer_mode = static_cast<int>(mode);
    return submit(goal);
  }
  [[nodiscard]] bool isMoving() {
    const arm::JointVector before = robot().joints;
    pass(20ms);
    return (robot().joints - before).cwiseAbs().maxCoeff() > 1e-7;
  }
  blocks::GoalId resume() {
    blocks::ProgramControlGoal goal;
    goal.command = static_cast<int>(blocks::ProgramCommand::Resume);
    return submit(goal);
  }

 private:
  blocks::ExchangeSettings settings_;
  blocks::GoalId exchange_ = 0;
};

}  // namespace cobot_command::testing
