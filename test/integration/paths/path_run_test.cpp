// A planned path, sent as PVTs or as a script: what the simulated arm makes of it, against its plan.
#include <algorithm>
#include <cmath>
#include <random>

#include "simulated_robot.h"
#include <gtest/gtest.h>

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/common/units.h"
#include "cobot_command/path/deviation_watch.h"
#include "cobot_command/path/path_pieces.h"
#include "cobot_command/path/path_planner.h"
#include "cobot_command/path/path_script.h"
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
      ASSERT_LT(mToMm(off), 0.015) << toSeconds(time);
    }
  }

  void send(const path::PathPiece& piece) {
    if (piece.block.points.empty()) return;
    const std::size_t last = piece.block.last;
    robot.script(client, "1", script::toText(path::scriptOf(piece.block, {{last, 1 + sent_++ % 15}})));
    ASSERT_EQ(robot.heard(client), ok("1"));
    expectFollowed(piece.plan, Duration::zero(), piece.plan.duration());
    robot.waitUntilIdle();
    static_cast<void>(robot.heard(client));
  }

  void expectKept(const PathPoint& point) {
    scene.start = robot.state().joints;
    path::PathSection section;
    section.points = {point};
    section.number_of_moves = 1;
    const path::PathPlan plan = planned(section);
    const arm::JointVector way = plan.at(plan.duration()).position - scene.start;
    const arm::JointVector shares = way.cwiseAbs() / way.cwiseAbs().maxCoeff();
    robot.script(client, "1", script::toText(path::scriptOf(path::sampleBlock(plan, 0, 0), {})));
    ASSERT_EQ(robot.heard(client), ok("1"));
    const Instant began = robot.now();
    arm::JointVector two_before = scene.start;
    arm::JointVector before = scene.start;
    for (Duration time = 1ms; time <= plan.duration(); time += 1ms) {
      robot.waitUntil(began + time);
      const arm::JointVector now = robot.state().joints;
      const arm::JointVector acceleration = (now - 2 * before + two_before) * 1e6;
      for (Eigen::Index i = 0; time > 1ms && i < 6; ++i) {
        constexpr double kDecimals = 0.1;  // of what is sent [deg/s^2]
        ASSERT_LE(radToDeg(std::abs(acceleration[i])), 1.01 * point.acceleration * shares[i] + kDecimals)
            << "J" << i + 1 << " at " << toSeconds(time) << " s, profile " << point.profile_type;
      }
      two_before = before;
      before = now;
    }
    robot.waitUntilIdle();
    static_cast<void>(robot.heard(client));
  }

  /// Sends the whole, and looks at the arm as often as a status stream does. `late`: how much longer it
  /// takes.
  [[nodiscard]] path::Deviation deviationOf(const path::PathPlan& plan, Duration late) {
    const std::size_t last = plan.points().size() - 1;
    robot.script(client, "1", script::toText(path::scriptOf(path::sampleBlock(plan, 0, last), {})));
    EXPECT_EQ(robot.heard(client), ok("1"));
    path::DeviationWatch watch(scene.arm, plan);
    const Instant began = robot.now();
    for (Duration time{}; time <= plan.duration() + late; time += 15ms) {
      robot.waitUntil(began + time);
      watch.add(time, robot.state().joints);
    }
    return watch.deviation();
  }

  SimulatedRobot robot;
  ClientId client = robot.connect();
  path::PathScene scene{*arm::ArmModel::named("tm5-700"), robot.state().joints};

 private:
  int sent_ = 0;
};

TEST_F(PathRun, isAsPlannedToAboutAHundredthOfAMillimetre) {
  const path::PathPlan plan = planned(meander(4, 8, 10));
  const auto pieces = path::piecesOf(plan, scene);
  ASSERT_TRUE(pieces) << pieces.error().found;
  EXPECT_EQ(pieces->size(), 2U) << "all of it blends, but for the first point, where the arm is";
  for (const path::PathPiece& piece : *pieces) send(piece);
}

/// The arm, as it moves: the places of each millisecond.
TEST_F(PathRun, isNowhereSteeperThanAskedWhateverTheLawAndTheJerk) {
  std::mt19937 engine(20261127);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  for (int run = 0; run < 40; ++run) {
    PathPoint point;
    point.joints = {uniform(-90, 90), uniform(-30, 30), uniform(60, 120), 0, 90, 0};
    point.profile_type = run % 4;
    point.acceleration_jerk = point.deceleration_jerk = uniform(5, 50);
    point.speed = uniform(20, 120);
    point.acceleration = point.deceleration = uniform(100, 1500);
    expectKept(point);
  }
}

TEST_F(PathRun, isAChainOfGoalsOfWhichWhatRestsIsSent) {
  path::PathSection section = meander(4, 8, 10);
  for (const std::size_t stop : {5U, 17U, 18U}) section.points[stop].termination_type = 0;
  path::PathPlanner planner(scene);
  section.number_of_moves = 4;
  std::size_t sent = 0;
  for (; section.start_index < 32; section.start_index += 4) {
    ASSERT_FALSE(planner.append(section));
    if (section.start_index == 28) planner.closeEnd();
    const auto pieces = path::piecesOf(planner.takeRested(), scene);
    ASSERT_TRUE(pieces) << pieces.error().found;
    for (const path::PathPiece& piece : *pieces) {
      send(piece);
      sent += piece.plan.points().size();
    }
  }
  EXPECT_EQ(sent, 32U);
}

TEST_F(PathRun, bringsBackAnArmThatStandsOutsideItsLimits) {
  Settings settings;
  settings.start_posture[2] = degToRad(-158);
  robot = SimulatedRobot(settings);
  client = robot.connect();
  scene.start = robot.state().joints;
  PathPoint back;
  back.joints = {10, 0, -90, 0, 90, 0};
  back.speed = 60;
  back.acceleration = back.deceleration = 200;
  path::PathSection section;
  section.points = {back};
  section.number_of_moves = 1;
  const auto pieces = path::piecesOf(planned(section), scene);
  ASSERT_TRUE(pieces) << pieces.error().found;
  send(pieces->front());
}

TEST_F(PathRun, tellsItsPointsByTheirTags) {
  const path::PathPlan plan = planned(meander(1, 15, 10));
  const std::size_t last = plan.points().size() - 1;
  std::map<std::size_t, int> tags;
  for (const std::size_t point : path::taggedPoints(0, last, 7)) {
    tags.emplace(point, 1 + static_cast<int>(tags.size()));
  }
  robot.script(client, "1", script::toText(path::scriptOf(path::sampleBlock(plan, 0, last), tags)));
  ASSERT_EQ(robot.heard(client), ok("1"));
  const Instant began = robot.now();
  for (const auto& [point, number] : tags) {
    robot.waitUntil(began + plan.points()[point].end() - 30ms);
    EXPECT_EQ(robot.heard(client), "") << point;
    robot.waitUntil(began + plan.points()[point].end() + 30ms);
    EXPECT_EQ(robot.heard(client), tag("0" + std::to_string(number) + ",true")) << point;
  }
}

TEST_F(PathRun, hasNoDeviationWhereTheArmMakesCubics) {
  const path::Deviation found = deviationOf(planned(meander(2, 8, 10)), {});
  EXPECT_LT(mToMm(found.path), 0.01);
  EXPECT_LT(radToDeg(found.joint), 0.003);
  EXPECT_LT(found.lag, 0.001);
}

TEST_F(PathRun, isTooFarOffWhereTheArmGoesStraightBetweenThePoints) {
  ASSERT_TRUE(robot.operate(SetFault{"pvt_linear", true, 0, 0, ""}).done);
  const path::Deviation found = deviationOf(planned(meander(2, 8, 10)), {});
  EXPECT_GT(radToDeg(found.joint), 0.001);
  EXPECT_GT(mToMm(found.path), 1e-4);
}

class PathRunOfALateArm : public PathRun {
 protected:
  PathRunOfALateArm() {
    Settings settings;
    settings.pvt_lag = 50ms;
    robot = SimulatedRobot(settings);
    client = robot.connect();
  }
};

TEST_F(PathRunOfALateArm, isLateAndOnThePath) {
  const path::Deviation found = deviationOf(planned(meander(2, 8, 10)), 100ms);
  EXPECT_NEAR(found.lag, 0.05, 0.016);
  EXPECT_LT(mToMm(found.path), 0.05);
}

TEST_F(PathRun, asAScriptEndsInTheSamePlaceInAboutTheSameTime) {
  path::PathSection section = meander(3, 4, 30);
  for (PathPoint& point : section.points) point.acceleration_jerk = point.deceleration_jerk = 0;
  const path::PathPlan plan = planned(section);
  const auto scripts = path::scriptOf(plan, 0, scene, {arm::Pose::Identity(), arm::Pose::Identity()});
  ASSERT_TRUE(scripts);
  std::vector<script::ScriptCommand> lines;
  for (const path::PointScript& point : *scripts) {
    EXPECT_TRUE(point.approximations.empty()) << point.approximations.front();
    lines.insert(lines.end(), point.lines.begin(), point.lines.end());
  }
  robot.script(client, "1", script::toText(lines));
  ASSERT_EQ(robot.heard(client), ok("1"));
  const Instant began = robot.now();
  robot.waitUntilIdle();
  EXPECT_NEAR(toSeconds(robot.now() - began), toSeconds(plan.duration()), 0.05 * toSeconds(plan.duration()));
  EXPECT_LT((robot.state().joints - plan.at(plan.duration()).position).cwiseAbs().maxCoeff(), 1e-6);
}

}  // namespace
}  // namespace cobot_command::simulator::test
