// A planned path, sent as PVTs: the simulated arm makes it as it was planned.
#include <algorithm>
#include <cmath>

#include "simulated_robot.h"
#include <gtest/gtest.h>

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/common/units.h"
#include "cobot_command/path/path_planner.h"
#include "cobot_command/path/pvt_block.h"

namespace cobot_command::simulator::test {
namespace {

using path::PathPoint;

class PathRun : public ::testing::Test {
 protected:
  /// Rows of points that are `step` apart [mm], one above the other, from where the robot stands.
  [[nodiscard]] path::PathSection meander(int rows, int columns, double step) const {
    path::PathSection section;
    const arm::ControllerPose from = arm::toControllerPose(flange());
    for (int row = 0; row < rows; ++row) {
      for (int i = 0; i < columns; ++i) {
        PathPoint point;
        point.target_type = static_cast<int>(path::TargetType::Cartesian);
        point.interpolation = static_cast<int>(path::Interpolation::Linear);
        point.pose = from;
        point.pose[1] += step * (row % 2 == 0 ? i : columns - 1 - i);
        point.pose[2] += step * row;
        point.termination_type = static_cast<int>(path::Termination::Blend);
        point.command_tolerance = step / 5;
        point.profile_type = row % 4;
        point.acceleration_jerk = point.deceleration_jerk = 80;
        point.speed = 100;
        point.acceleration = point.deceleration = 500;
        point.orientation_speed = 90;
        point.orientation_acceleration = point.orientation_deceleration = 360;
        section.points.push_back(point);
      }
    }
    section.number_of_moves = static_cast<int>(section.points.size());
    return section;
  }
  [[nodiscard]] arm::Pose flange() const { return arm::forwardKinematics(scene.arm, scene.start); }
  [[nodiscard]] path::PathPlan planned(const path::PathSection& section) const {
    path::PathPlanner planner(scene);
    const auto refusal = planner.append(section);
    EXPECT_FALSE(refusal) << refusal->error_id << " in point " << refusal->index << ": " << refusal->found;
    return planner.plan();
  }
  /// The arm goes along the plan from now on.
  void expectFollowed(const path::PathPlan& plan, Duration from, Duration to) {
    const Instant began = robot.now() - from;
    for (Duration time = from; time <= to; time += 7ms) {
      robot.waitUntil(began + time);
      const arm::Pose there = arm::forwardKinematics(scene.arm, plan.at(time).position);
      const double off = (robot.state().flange.translation() - there.translation()).norm();
      ASSERT_LT(mToMm(off), 0.01) << toSeconds(time);
    }
  }

  SimulatedRobot robot;
  ClientId client = robot.connect();
  path::PathScene scene{*arm::ArmModel::named("tm5-700"), robot.state().joints};
};

TEST_F(PathRun, isAsPlannedToAHundredthOfAMillimetre) {
  const path::PathPlan plan = planned(meander(4, 8, 10));
  std::size_t first = 0;
  int blocks = 0;
  while (first < plan.points().size()) {
    const std::size_t last = path::endOfBlock(plan, first);
    const auto block = path::sampleBlock(plan, first, last, scene.segment);
    first = last + 1;
    if (block.points.empty()) continue;
    robot.script(client, "1", script::toText(path::scriptOf(block, {{last, 1 + blocks++ % 15}})));
    ASSERT_EQ(robot.heard(client), ok("1"));
    expectFollowed(plan, block.start, plan.points()[last].end());
    robot.waitUntilIdle();
  }
  EXPECT_EQ(blocks, 1) << "all of it blends";
}

TEST_F(PathRun, tellsItsPointsByTheirTags) {
  const path::PathPlan plan = planned(meander(1, 15, 10));
  const std::size_t last = plan.points().size() - 1;
  std::map<std::size_t, int> tags;
  for (const std::size_t point : path::taggedPoints(0, last, 7)) {
    tags.emplace(point, 1 + static_cast<int>(tags.size()));
  }
  robot.script(client, "1",
               script::toText(path::scriptOf(path::sampleBlock(plan, 0, last, scene.segment), tags)));
  ASSERT_EQ(robot.heard(client), ok("1"));
  const Instant began = robot.now();
  for (const auto& [point, number] : tags) {
    robot.waitUntil(began + plan.points()[point].end() - 30ms);
    EXPECT_EQ(robot.heard(client), "") << point;
    robot.waitUntil(began + plan.points()[point].end() + 30ms);
    EXPECT_EQ(robot.heard(client), tag("0" + std::to_string(number) + ",true")) << point;
  }
}

}  // namespace
}  // namespace cobot_command::simulator::test
