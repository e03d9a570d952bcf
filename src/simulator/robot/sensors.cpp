#include "robot/sensors.h"

#include <cmath>
#include <cstdint>
#include <utility>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/arm/gravity.h"
#include "cobot_command/common/units.h"

namespace cobot_command::simulator {

namespace {

/// Each has a noise of its own.
enum class Sensor : std::uint64_t { Joint, Speed, Torque, Force };

/// Any change of any bit changes about half of the result (SplitMix64).
std::uint64_t scatter(std::uint64_t bits) {
  bits += 0x9E3779B97F4A7C15U;
  bits = (bits ^ (bits >> 30U)) * 0xBF58476D1CE4E5B9U;
  bits = (bits ^ (bits >> 27U)) * 0x94D049BB133111EBU;
  return bits ^ (bits >> 31U);
}

/// Above 0, up to 1.
double share(std::uint64_t bits) {
  constexpr double kSteps = 9007199254740992.0;  // 2^53
  return (static_cast<double>(bits >> 11U) + 1.0) / kSteps;
}

/// Normally distributed, with the deviation 1 (Box and Muller).
double normal(std::uint64_t bits) {
  return std::sqrt(-2.0 * std::log(share(scatter(bits)))) * std::cos(2.0 * kPi * share(scatter(~bits)));
}

template <int Count>
Eigen::Matrix<double, Count, 1> noise(Sensor sensor, double deviation, int seed, Instant time) {
  Eigen::Matrix<double, Count, 1> all = Eigen::Matrix<double, Count, 1>::Zero();
  if (deviation == 0.0) return all;
  const auto moment = static_cast<std::uint64_t>(time.time_since_epoch().count());
  const std::uint64_t start = scatter(scatter(moment) ^ static_cast<std::uint64_t>(seed));
  for (int i = 0; i < Count; ++i) {
    const std::uint64_t which = 8U * static_cast<std::uint64_t>(sensor) + static_cast<std::uint64_t>(i);
    all[i] = deviation * normal(scatter(start + which));
  }
  return all;
}

/// In the flange.
arm::PointMass carriedBy(const RobotState& robot) {
  const arm::Pose centre = robot.tcp * arm::toPose(robot.tcp_inertia.mass_center);
  return arm::PointMass{robot.tcp_mass, centre.translation()} +
         arm::PointMass{robot.load, robot.tcp.translation()};
}

}  // namespace

RobotState measured(RobotState truth, const arm::ArmModel& arm, const Settings& settings) {
  RobotState robot = std::move(truth);
  if (settings.joint_noise != 0.0) {
    robot.joints += noise<6>(Sensor::Joint, settings.joint_noise, settings.noise_seed, robot.time);
    robot.flange = arm::forwardKinematics(arm, robot.joints);
  }
  robot.velocities += noise<6>(Sensor::Speed, settings.speed_noise, settings.noise_seed, robot.time);
  robot.tcp_force += noise<3>(Sensor::Force, settings.force_noise, settings.noise_seed, robot.time);
  return robot;
}

arm::JointVector jointTorques(const RobotState& robot, const arm::ArmModel& arm, const Settings& settings,
                              Duration before) {
  const arm::JointVector joints = robot.joints - toSeconds(before) * robot.velocities;
  return arm::holdingTorques(arm, joints, carriedBy(robot)) +
         noise<6>(Sensor::Torque, settings.torque_noise, settings.noise_seed, robot.time - before);
}

TorqueWindow torqueWindow(const RobotState& robot, const arm::ArmModel& arm, const Settings& settings) {
  constexpr Duration kStep = std::chrono::milliseconds(20);
  const arm::JointVector now = jointTorques(robot, arm, settings);
  const arm::JointVector then = jointTorques(robot, arm, settings, kStep);
  const arm::JointVector first = jointTorques(robot, arm, settings, 2 * kStep);
  return {(now + then + first) / 3.0, now.cwiseMin(then).cwiseMin(first), now.cwiseMax(then).cwiseMax(first)};
}

arm::JointVector jointCurrents(const RobotState& robot, const arm::ArmModel& arm, const Settings& settings) {
  constexpr double kTorquePerAmpere = 10.0;  // [Nm/A] behind the gear; ours
  return jointTorques(robot, arm, settings) / kTorquePerAmpere;
}

}  // namespace cobot_command::simulator
