// Good goals of the function blocks, and what the checks say of changed ones.
#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/common/units.h"

namespace cobot_command::testing {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInf = std::numeric_limits<double>::infinity();

/// What a goal of each block looks like that may be sent.
template <class Goal>
[[nodiscard]] Goal good();

template <>
inline blocks::MoveAbsoluteGoal good() {
  blocks::MoveAbsoluteGoal goal;
  goal.target = {417.5, -122.3, 343.9, 180, 0, 90};
  goal.speed = 10;
  goal.accel_time = 200;
  return goal;
}
template <>
inline blocks::ExchangeConfigurationGoal good() {
  blocks::ExchangeConfigurationGoal goal;
  goal.settings.log_level = 5;
  goal.settings.life_sign_time_out = 300;
  return goal;
}
template <>
inline blocks::MoveRelativeGoal good() {
  blocks::MoveRelativeGoal goal;
  goal.target = {0, 0, 10, 45, 0, 0};
  goal.speed = 10;
  goal.accel_time = 200;
  return goal;
}
template <>
inline blocks::MoveCircleGoal good() {
  blocks::MoveCircleGoal goal;
  goal.arc_point = {417.5, -122.3, 343.9, 180, 0, 90};
  goal.end_point = {381.7, 208.74, 343.9, 180, 0, 135};
  goal.speed = 10;
  goal.accel_time = 200;
  return goal;
}
template <>
inline blocks::ChangeBaseGoal good() {
  blocks::ChangeBaseGoal goal;
  goal.transformation = {20, 30, 10, 0, 0, 90};
  return goal;
}
template <>
inline blocks::ChangeTcpGoal good() {
  blocks::ChangeTcpGoal goal;
  goal.tcp_offset = {0, 0, 150, 0, 0, 90};
  goal.weight = 2;
  goal.moment_of_inertia = {2, 0.5, 0.5};
  goal.mass_center = {0, 0, -80, 0, 0, 0};
  return goal;
}
template <>
inline blocks::ProgramControlGoal good() {
  return {};
}
template <>
inline blocks::ExitListenNodeGoal good() {
  return {};
}
template <>
inline blocks::RunScriptGoal good() {
  blocks::RunScriptGoal goal;
  goal.script = "PTP(\"JPP\",0,0,90,0,90,0,35,200,0,false)";
  return goal;
}

template <>
inline blocks::ChangeLoadGoal good() {
  return {1.5, 0};
}
template <>
inline blocks::SetOutputGoal good() {
  return {0, "EndModule", 2, 1};
}
template <>
inline blocks::WaitForInputGoal good() {
  return {"ControlBox", 3, true, 10};
}
template <>
inline blocks::WaitTimeGoal good() {
  return {10};
}

template <>
inline blocks::PickAndPlaceGoal good() {
  blocks::PickAndPlaceGoal goal;
  goal.steps.push_back(
      {good<blocks::MoveAbsoluteGoal>(), blocks::SetOutputGoal{0, "EndModule", 0, 1}, std::nullopt, 2});
  return goal;
}

/// A PTP to joints at the speeds of its kind.
[[nodiscard]] inline path::PathPoint pathPoint(const std::array<double, 9>& joints_deg) {
  path::PathPoint point;
  point.joints = joints_deg;
  point.speed = 60;
  point.acceleration = point.deceleration = 120;
  return point;
}
/// A straight way to that pose of the flange.
[[nodiscard]] inline path::PathPoint pathLine(const arm::ControllerPose& pose) {
  path::PathPoint point;
  point.target_type = static_cast<int>(path::TargetType::Cartesian);
  point.interpolation = static_cast<int>(path::Interpolation::Linear);
  point.pose = pose;
  point.speed = 100;
  point.acceleration = point.deceleration = 500;
  point.orientation_speed = 60;
  point.orientation_acceleration = point.orientation_deceleration = 120;
  return point;
}

/// Three points at which the robot stops, from joints 0, 0, 90, 0, 90, 0 on.
template <>
inline blocks::LoadPathGoal good() {
  blocks::LoadPathGoal goal;
  goal.path = {pathPoint({10, 0, 90, 0, 90, 0}), pathPoint({10, 0, 100, 0, 80, 0}),
               pathPoint({0, 0, 90, 0, 90, 0})};
  goal.number_of_moves = 3;
  return goal;
}

/// A turn of joint 1 from joints 0, 0, 90, 0, 90, 0 [deg] on, to rest at 10 degrees.
template <>
inline blocks::FollowJointTrajectoryGoal good() {
  blocks::FollowJointTrajectoryGoal goal;
  for (const double time : {0.0, 1.0, 2.0}) {
    goal.points.push_back({time, {degToRad(5.0 * time), 0, kPi / 2, 0, kPi / 2, 0}, {}});
  }
  goal.buffer_mode = static_cast<int>(blocks::BufferMode::Refuse);
  return goal;
}

/// A turn of joint 1 by 10 degrees, which nobody has to hold.
template <>
inline blocks::JogGoal good() {
  blocks::JogGoal goal;
  goal.mode = static_cast<int>(blocks::JogMode::Axes);
  goal.directions[0] = 1;
  goal.increment_deg = 10;
  return goal;
}

/// Of the TM5-900 at 0, 0, 90, 0, 90, 0: joint 1 was 10 degrees further when it was interrupted.
template <>
inline blocks::ReturnToPrimaryGoal good() {
  blocks::ReturnToPrimaryGoal goal;
  goal.trajectory_mode = static_cast<int>(blocks::ReturnTrajectory::Ptp);
  const arm::Pose there = arm::toPose({530.9, -30.6, 461.05, 180, 0, 100});
  goal.place = blocks::ReturnPlace{
      {arm::toJointVector({10, 0, 90, 0, 90, 0}), there, 92.7}, std::nullopt, std::nullopt};
  return goal;
}

template <>
inline blocks::RunProgramGoal good() {
  return {};
}

/// To where the path was begun, as fast as that was.
template <>
inline blocks::RetraceGoal good() {
  blocks::RetraceGoal goal;
  goal.speed = 100;
  return goal;
}

template <class Goal, class Change>
[[nodiscard]] Goal with(const Change& change) {
  Goal goal = good<Goal>();
  change(goal);
  return goal;
}

template <class Goal>
[[nodiscard]] std::vector<int> idsOf(const Goal& goal) {
  std::vector<int> ids;
  for (const blocks::Failure& failure : check(goal)) ids.push_back(failure.error_id);
  return ids;
}

/// The id that decides; 0: the goal may be sent.
template <class Goal>
[[nodiscard]] int errorOf(const Goal& goal) {
  const auto ids = idsOf(goal);
  return ids.empty() ? 0 : ids.front();
}
template <class Goal, class Change>
[[nodiscard]] int errorWith(const Change& change) {
  return errorOf(with<Goal>(change));
}

/// What a goal means that is one command, and may be sent.
template <class Goal>
[[nodiscard]] script::ScriptCommand commandOf(const Goal& goal,
                                              const arm::Pose& base = arm::Pose::Identity()) {
  return orderOf(goal, base).commands->front();
}

/// The script text of a goal that may be sent.
template <class Goal>
[[nodiscard]] std::string scriptOf(const Goal& goal, const arm::Pose& base = arm::Pose::Identity()) {
  return script::toText(commandOf(goal, base));
}

/// A pose in a frame that stands 1 m in front of the robot base, turned by 90 degrees about Z.
[[nodiscard]] inline blocks::FramedPose framedPose() {
  blocks::FramedPose pose;
  pose.frame = "table";
  pose.position = {0.1, 0.2, 0.3};
  pose.quaternion = {0, 0, 0, 1};
  pose.frame_in_robot_base = arm::Pose::Identity();
  pose.frame_in_robot_base->translation() << 1, 0, 0;
  pose.frame_in_robot_base->rotate(Eigen::AngleAxisd(kPi / 2, Eigen::Vector3d::UnitZ()));
  return pose;
}

}  // namespace cobot_command::testing
