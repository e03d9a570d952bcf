// A TM5-900 that stands at J = 0 0 90 0 90 0, and moves of its first joint.
#pragma once

#include "core_and_robot.h"
#include "motion_goals.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/common/units.h"

namespace cobot_command::testing {

using namespace std::chrono_literals;

class DynamicsCell : public ::testing::Test {
 protected:
  explicit DynamicsCell(const simulator::Settings& settings = {}) : cell("tm5-900", settings) {
    cell.connect();
  }
  /// At 50 % of 180 deg/s, with 0.2 s to that: as many degrees / 90 + 0.2 s.
  [[nodiscard]] static blocks::MoveAbsoluteGoal turnTo(double j1, double speed_percent = 50) {
    blocks::MoveAbsoluteGoal goal = moveJoints({j1, 0, 90, 0, 90, 0}, speed_percent);
    goal.buffer_mode = static_cast<int>(blocks::BufferMode::Buffered);
    return goal;
  }
  [[nodiscard]] double joint1() const { return radToDeg(cell.robot().joints[0]); }
  void expectDone(blocks::GoalId id) {
    const blocks::Outcome& outcome = cell.endOf(id);
    EXPECT_EQ(outcome.ending, blocks::Ending::Done)
        << "goal " << id << ": " << outcome.error_id << " " << outcome.error_description;
  }
  [[nodiscard]] double planned(blocks::GoalId id) { return toSeconds(cell.endOf(id).planned.value_or(0ms)); }
  /// Until it has ended [deg/s].
  [[nodiscard]] double topSpeedUntilEndOf(blocks::GoalId id) {
    double fastest = 0;
    double before = joint1();
    while (cell.outcome(id) == nullptr) {
      cell.pass(20ms);
      fastest = std::max(fastest, std::abs(joint1() - before) / 0.02);
      before = joint1();
    }
    return fastest;
  }
  [[nodiscard]] const blocks::Progress& last(blocks::GoalId id) { return cell.progress(id).back(); }

  CoreAndRobot cell;
};

}  // namespace cobot_command::testing
