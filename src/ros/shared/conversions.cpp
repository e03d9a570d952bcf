#include "cobot_command/ros/shared/conversions.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace cobot_command::ros_adapter {

ros::Time ClockPair::toRos(Instant instant) const {
  const std::int64_t since = (instant - core_now).count();
  const std::int64_t nanoseconds = static_cast<std::int64_t>(ros_now.toNSec()) + since;
  return ros::Time().fromNSec(static_cast<std::uint64_t>(std::max<std::int64_t>(nanoseconds, 0)));
}

ros::Duration toRos(Duration duration) {
  return ros::Duration().fromNSec(duration.count());
}

ros::Duration toRos(const std::optional<Duration>& duration) {
  return duration ? toRos(*duration) : ros::Duration();
}

std::array<double, 6> toSix(const cobot_command::Transformation& message) {
  return {message.x, message.y, message.z, message.rx, message.ry, message.rz};
}

cobot_command::Transformation toTransformation(const std::array<double, 6>& six) {
  cobot_command::Transformation message;
  message.x = six[0];
  message.y = six[1];
  message.z = six[2];
  message.rx = six[3];
  message.ry = six[4];
  message.rz = six[5];
  return message;
}

geometry_msgs::Transform toTransform(const arm::Pose& pose) {
  const Eigen::Quaterniond rotation(pose.rotation());
  geometry_msgs::Transform message;
  message.translation.x = pose.translation().x();
  message.translation.y = pose.translation().y();
  message.translation.z = pose.translation().z();
  message.rotation.x = rotation.x();
  message.rotation.y = rotation.y();
  message.rotation.z = rotation.z();
  message.rotation.w = rotation.w();
  return message;
}

geometry_msgs::Pose toPoseMessage(const arm::Pose& pose) {
  const geometry_msgs::Transform transform = toTransform(pose);
  geometry_msgs::Pose message;
  message.position.x = transform.translation.x;
  message.position.y = transform.translation.y;
  message.position.z = transform.translation.z;
  message.orientation = transform.rotation;
  return message;
}

arm::Pose toPose(const geometry_msgs::Transform& message) {
  const Eigen::Quaterniond rotation(message.rotation.w, message.rotation.x, message.rotation.y,
                                    message.rotation.z);
  arm::Pose pose(rotation.normalized());
  pose.translation() = Eigen::Vector3d(message.translation.x, message.translation.y, message.translation.z);
  return pose;
}

arm::Pose toPose(const geometry_msgs::Pose& message) {
  geometry_msgs::Transform transform;
  transform.translation.x = message.position.x;
  transform.translation.y = message.position.y;
  transform.translation.z = message.position.z;
  transform.rotation = message.orientation;
  const auto& q = message.orientation;
  if (q.x == 0 && q.y == 0 && q.z == 0 && q.w == 0) transform.rotation.w = 1;
  return toPose(transform);
}

JointNames jointNames(const std::string& prefix) {
  return {prefix + "shoulder_1_joint", prefix + "shoulder_2_joint", prefix + "elbow_joint",
          prefix + "wrist_1_joint",    prefix + "wrist_2_joint",    prefix + "wrist_3_joint"};
}

sensor_msgs::JointState jointState(const JointNames& names, const arm::JointVector& positions,
                                   const arm::JointVector* velocities, const arm::JointVector* torques,
                                   const ros::Time& stamp) {
  const auto to_vector = [](const arm::JointVector& v) {
    return std::vector<double>(v.data(), v.data() + v.size());
  };
  sensor_msgs::JointState message;
  message.header.stamp = stamp;
  message.name.assign(names.begin(), names.end());
  message.position = to_vector(positions);
  if (velocities != nullptr) message.velocity = to_vector(*velocities);
  if (torques != nullptr) message.effort = to_vector(*torques);
  return message;
}

}  // namespace cobot_command::ros_adapter
