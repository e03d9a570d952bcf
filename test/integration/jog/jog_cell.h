// Jogs of a TM5-900 that stands at J = 0 0 90 0 90 0, and who holds them.
#pragma once

#include <array>
#include <string>

#include "core_and_robot.h"
#include <gtest/gtest.h>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/common/units.h"

namespace cobot_command::testing {

using namespace std::chrono_literals;

inline blocks::JogGoal jog(blocks::JogMode mode, std::size_t which, int direction, double speed) {
  blocks::JogGoal goal;
  goal.mode = static_cast<int>(mode);
  goal.directions[which] = direction;
  goal.speed = speed;
  goal.frame = goal.tool = blocks::JogGoal::kActive;
  return goal;
}

inline simulator::Settings withVelocities(bool licence, simulator::Settings settings = {}) {
  settings.velocity_licence = licence;
  return settings;
}

/// They were asked for by name.
inline link::LinkSettings velocitiesPermitted() {
  link::LinkSettings settings;
  settings.velocities = {VelocityModes::Line::Millimetres, true};
  return settings;
}

class JogCell {
 public:
  explicit JogCell(bool licence, const simulator::Settings& settings = {}, Duration planning = {},
                   const link::LinkSettings& link = velocitiesPermitted())
      : cell("tm5-900", withVelocities(licence, settings), link, planning) {
    cell.connect();
  }

  /// Kept alive as often, until `done` or for so long; then nothing comes any more.
  void hold(Duration time, Duration period = 10ms, const std::function<bool()>& done = {}) {
    const Instant until = cell.now() + time;
    while (cell.now() < until && !(done && done())) {
      cell.keepJogging();
      last_kept = cell.now();
      cell.pass(period);
    }
  }
  blocks::Outcome holdUntilItEnds(const blocks::JogGoal& goal, Duration most = 120s) {
    const blocks::GoalId id = cell.submit(goal);
    hold(most, 10ms, [&] { return cell.outcome(id) != nullptr; });
    EXPECT_NE(cell.outcome(id), nullptr) << "it goes on";
    return cell.endOf(id);
  }
  [[nodiscard]] bool stands() const { return cell.robot().velocities.isZero(1e-9); }
  /// Since the last keep-alive.
  Duration timeToStandstill() {
    while (!stands() && cell.now() - last_kept < 5s) cell.pass(1ms);
    return cell.now() - last_kept;
  }
  [[nodiscard]] double jointDeg(Eigen::Index joint) const { return radToDeg(cell.robot().joints[joint]); }
  [[nodiscard]] arm::Pose tcp() const { return cell.robot().flange * cell.robot().tcp; }
  void moveTo(const std::array<double, 6>& joints_deg) {
    blocks::MoveAbsoluteGoal goal;
    goal.movement_command = static_cast<int>(blocks::Movement::Ptp);
    goal.data_format = 0;
    goal.target = joints_deg;
    goal.speed = 100;
    goal.accel_time = 200;
    goal.buffer_mode = static_cast<int>(blocks::BufferMode::Buffered);
    const auto& outcome = cell.endOf(cell.submit(goal));
    ASSERT_EQ(outcome.ending, blocks::Ending::Done) << outcome.error_description;
    cell.pass(200ms);
  }

  CoreAndRobot cell;
  Instant last_kept{};
};

inline blocks::JogReport reportOf(const blocks::Outcome& outcome) {
  EXPECT_EQ(outcome.ending, blocks::Ending::Done) << outcome.error_id << " " << outcome.error_description;
  return outcome.detail.as<blocks::JogReport>();
}

}  // namespace cobot_command::testing
