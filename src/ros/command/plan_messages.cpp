#include "command/plan_messages.h"

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::ros_adapter {

trajectory_msgs::JointTrajectory toMessage(const std::vector<blocks::JointPathPoint>& path,
                                           const JointNames& names) {
  trajectory_msgs::JointTrajectory message;
  if (path.empty()) return message;
  message.joint_names.assign(names.begin(), names.end());
  message.points.reserve(path.size());
  for (const blocks::JointPathPoint& point : path) {
    trajectory_msgs::JointTrajectoryPoint& added = message.points.emplace_back();
    added.positions.assign(point.joints.begin(), point.joints.end());
    added.velocities.assign(point.velocities.begin(), point.velocities.end());
    added.time_from_start = toRos(point.time);
  }
  return message;
}

cobot_command::StepReport toMessage(const blocks::StepReport& report, const JointNames& names) {
  cobot_command::StepReport message;
  message.error_id = report.error_id;
  message.error_description = forPeople(report.error_description);
  message.start = toRos(report.start);
  message.duration = toRos(report.duration);
  message.done = toRos(report.done);
  message.offending_point_valid = report.offending_point.has_value();
  if (report.offending_point) message.offending_point = toTransformation(*report.offending_point);
  message.joint_path = toMessage(report.joint_path, names);
  return message;
}

}  // namespace cobot_command::ros_adapter
