// What the tests of paths share: points in mm and degrees, and a planner that has to take them.
#pragma once

#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/arm/pose_bits.h"
#include "cobot_command/common/units.h"
#include "cobot_command/path/path_planner.h"

namespace cobot_command::path {

inline constexpr double kGrid = 3e-3;  ///< [s] a move is at most so much longer than its closed form

inline arm::JointVector degrees(double j1, double j2, double j3, double j4, double j5, double j6) {
  return arm::toJointVector({j1, j2, j3, j4, j5, j6});
}

template <class Enum>
int number(Enum value) {
  return static_cast<int>(value);
}

/// Dynamics that every kind can have.
inline PathPoint withDynamics(PathPoint point) {
  point.speed = 100;
  point.acceleration = point.deceleration = 500;
  point.orientation_speed = 90;
  point.orientation_acceleration = point.orientation_deceleration = 360;
  return point;
}

inline PathPoint toJoints(const std::array<double, 6>& joints,
                          Interpolation interpolation = Interpolation::Ptp) {
  PathPoint point;
  point.interpolation = number(interpolation);
  std::copy(joints.begin(), joints.end(), point.joints.begin());
  return withDynamics(point);
}

/// The flange, in the robot base.
inline PathPoint toPose(const arm::ControllerPose& pose, Interpolation interpolation = Interpolation::Linear,
                        int configuration = 0) {
  PathPoint point;
  point.target_type = number(TargetType::Cartesian);
  point.interpolation = number(interpolation);
  point.pose = pose;
  point.robot_configuration = configuration;
  return withDynamics(point);
}

inline PathPoint toHybrid(const std::array<double, 3>& place, const std::array<double, 3>& wrist,
                          Interpolation interpolation = Interpolation::Wrist) {
  PathPoint point;
  point.target_type = number(TargetType::Hybrid);
  point.interpolation = number(interpolation);
  std::copy(place.begin(), place.end(), point.pose.begin());
  std::copy(wrist.begin(), wrist.end(), point.joints.begin() + 3);
  return withDynamics(point);
}

inline PathPoint incremental(PathPoint point) {
  point.move_type = number(MoveType::Incremental);
  return point;
}

inline PathPoint blending(PathPoint point, double tolerance) {
  point.termination_type = number(Termination::Blend);
  point.command_tolerance = tolerance;
  return point;
}

inline PathSection sectionOf(std::vector<PathPoint> points) {
  PathSection section;
  section.number_of_moves = static_cast<int>(points.size());
  section.points = std::move(points);
  return section;
}

/// Paths of a TM5-900 that stands above a table, or of any other.
class Paths : public ::testing::Test {
 protected:
  explicit Paths(const char* name = "tm5-900")
      : scene{*arm::ArmModel::named(name), degrees(0, 0, 90, 0, 90, 0)} {}

  [[nodiscard]] PathPlan planned(const std::vector<PathPoint>& points) const {
    PathPlanner planner(scene);
    const auto refusal = planner.append(sectionOf(points));
    EXPECT_FALSE(refusal) << refusal->error_id << " in point " << refusal->index << ": " << refusal->found;
    return planner.plan();
  }
  [[nodiscard]] PathRefusal refused(const PathSection& section) const {
    PathPlanner planner(scene);
    auto refusal = planner.append(section);
    EXPECT_TRUE(refusal) << "it was planned";
    EXPECT_TRUE(planner.plan().points().empty());
    return refusal.value_or(PathRefusal{});
  }
  [[nodiscard]] PathRefusal refused(const std::vector<PathPoint>& points) const {
    return refused(sectionOf(points));
  }
  [[nodiscard]] arm::ControllerPose flangeAt(const arm::JointVector& joints) const {
    return arm::toControllerPose(arm::forwardKinematics(scene.arm, joints));
  }
  static void expectJoints(const arm::JointVector& found, const std::array<double, 6>& expected,
                           double tolerance = 2e-4) {
    const arm::ControllerJoints joints = arm::toControllerJoints(found);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(joints[i], expected[i], tolerance) << "J" << i + 1;
    }
  }
  [[nodiscard]] static arm::JointVector endOf(const PathPlan& plan) {
    return plan.at(plan.duration()).position;
  }

  PathScene scene;
};

}  // namespace cobot_command::path
