// A TM5-900 that stands at J = 0 0 90 0 90 0, and what is done to its motions.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "block_goals.h"
#include "core_and_robot.h"
#include "motion_goals.h"
#include <gmock/gmock.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/units.h"

namespace cobot_command::testing {

using namespace std::chrono_literals;
using blocks::BufferMode;
using blocks::Ending;
using blocks::GoalId;

/// The pose of the flange where it stands at first.
inline const blocks::SixValues kHome = {517.5, -122.3, 461.05, 180, 0, 90};

template <class Goal>
[[nodiscard]] Goal inMode(BufferMode mode, Goal goal) {
  goal.buffer_mode = static_cast<int>(mode);
  return goal;
}

/// At 100 mm/s.
inline blocks::MoveAbsoluteGoal lineTo(const blocks::SixValues& pose) {
  auto goal = good<blocks::MoveAbsoluteGoal>();
  goal.movement_command = static_cast<int>(blocks::Movement::Line);
  goal.data_format = static_cast<int>(blocks::AbsoluteFormat::Cap);
  goal.target = pose;
  goal.speed = 100;
  return goal;
}
inline blocks::MoveRelativeGoal lineBy(const blocks::SixValues& offset,
                                       blocks::RelativeFormat format = blocks::RelativeFormat::Cap) {
  auto goal = good<blocks::MoveRelativeGoal>();
  goal.movement_command = static_cast<int>(blocks::Movement::Line);
  goal.data_format = static_cast<int>(format);
  goal.target = offset;
  goal.speed = 100;
  return goal;
}
template <class Goal>
[[nodiscard]] Goal blended(double value, Goal goal) {
  goal.blending_enable = true;
  goal.blending_value = value;
  return goal;
}

class InterruptedRobot : public CoreAndRobot {
 public:
  explicit InterruptedRobot(const simulator::Settings& settings = {}, Duration planning = {})
      : CoreAndRobot("tm5-900", settings, {}, planning) {
    connect();
  }

  /// Until the robot stands, and that was answered.
  command::InterruptAnswer interruptNow() {
    const auto promise = interrupt();
    EXPECT_TRUE(passUntil([&] { return promise->has_value(); }, 5s)) << "no answer";
    return promise->value_or(command::InterruptAnswer());
  }
  void expectInterrupted() {
    const auto answer = interruptNow();
    EXPECT_TRUE(answer.success) << answer.error_id << " " << answer.message;
    EXPECT_TRUE(stands());
  }
  void expectGoesOn() {
    const auto answer = goOn();
    EXPECT_TRUE(answer.success) << answer.error_id << " " << answer.message;
  }
  void expectDone(GoalId id) {
    const blocks::Outcome& outcome = endOf(id);
    EXPECT_EQ(outcome.ending, Ending::Done) << outcome.error_id << " " << outcome.error_description;
  }
  [[nodiscard]] bool stands() const { return robot().velocities.isZero(1e-9); }
  /// Of the flange [mm, deg].
  [[nodiscard]] arm::ControllerPose pose() const { return arm::toControllerPose(robot().flange); }
  [[nodiscard]] Eigen::Vector3d place() const { return 1000 * robot().flange.translation(); }
  [[nodiscard]] double jointDeg(Eigen::Index joint) const { return radToDeg(robot().joints[joint]); }
  [[nodiscard]] bool passUntilZ(double mm) {
    return passUntil([&] { return place().z() < mm; }, 1min);
  }
  GoalId moveTo(const std::array<double, 6>& joints_deg) {
    const GoalId id = submit(moveJoints(joints_deg));
    expectDone(id);
    pass(200ms);
    return id;
  }
  [[nodiscard]] std::array<double, 6> jointsDeg() const { return arm::toControllerJoints(robot().joints); }
  /// Where the flange was, each 5 ms, until the goal ends [mm].
  std::vector<Eigen::Vector3d> wayUntilTheEndOf(GoalId id) {
    std::vector<Eigen::Vector3d> way;
    passUntil([&] {
      way.push_back(place());
      pass(5ms);
      return outcome(id) != nullptr;
    });
    return way;
  }
};

}  // namespace cobot_command::testing
