#include "cobot_command/ros/conversions.h"

#include <algorithm>

#include "cobot_command/protocol/frame.h"

namespace cobot_command::ros_adapter {
namespace {

std::array<double, 6> toSix(const cobot_command::Transformation& message) {
  return {message.x, message.y, message.z, message.rx, message.ry, message.rz};
}

ros::Duration toRos(Duration duration) {
  return ros::Duration().fromNSec(duration.count());
}

ros::Duration toRos(const std::optional<Duration>& duration) {
  return duration ? toRos(*duration) : ros::Duration();
}

std::int8_t triState(const std::optional<bool>& value) {
  using Message = cobot_command::RobotStatus;
  if (!value) return Message::UNKNOWN;
  return *value ? Message::TRUE : Message::FALSE;
}

template <class Result>
void fillError(Result& message, const blocks::Outcome& outcome) {
  message.error_id = outcome.error_id;
  message.error_description = outcome.error_description;
  message.remedy = outcome.remedy;
}

cobot_command::BlockStatus toMessage(const blocks::BlockOutputs& outputs) {
  cobot_command::BlockStatus message;
  message.block = blocks::toString(outputs.block);
  message.busy = outputs.busy;
  message.active = outputs.active;
  message.done = outputs.done;
  message.error = outputs.error;
  message.command_aborted = outputs.command_aborted;
  message.error_id = outputs.error_id;
  message.error_description = outputs.error_description;
  message.command_id_ack = outputs.command_id_ack;
  return message;
}

std::uint8_t toMessage(blocks::CommandStatus::LinkState state) {
  using State = blocks::CommandStatus::LinkState;
  using Message = cobot_command::CommandStatus;
  switch (state) {
    case State::Disconnected:
      return Message::DISCONNECTED;
    case State::Connecting:
      return Message::CONNECTING;
    case State::Probing:
      return Message::PROBING;
    case State::NotListening:
      return Message::NOT_LISTENING;
    case State::Ready:
      return Message::READY;
  }
  return Message::DISCONNECTED;
}

std::uint8_t connectPhase(blocks::Phase phase) {
  using Message = cobot_command::ConnectFeedback;
  if (phase == blocks::Phase::Connected) return Message::CONNECTED;
  return phase == blocks::Phase::Probing ? Message::PROBING : Message::CONNECTING;
}

std::uint8_t movePhase(blocks::Phase phase) {
  using Message = cobot_command::MoveAbsoluteFeedback;
  switch (phase) {
    case blocks::Phase::Queued:
      return Message::QUEUED;
    case blocks::Phase::Active:
      return Message::ACTIVE;
    case blocks::Phase::Stopping:
      return Message::STOPPING;
    default:
      return Message::SENT;
  }
}

// Below this a joint counts as standing still: encoders and float32 items leave some noise.
constexpr double kStandstillVelocity = 1e-3;  // [rad/s]

std::optional<bool> inMotion(const link::RobotStatus& status) {
  if (!status.joint_velocities) return std::nullopt;
  return status.joint_velocities->cwiseAbs().maxCoeff() > kStandstillVelocity;
}

}  // namespace

blocks::Goal toGoal(const cobot_command::ConnectGoal& message) {
  blocks::ConnectGoal goal;
  goal.host = message.host;
  goal.port = message.port;
  goal.timeout = message.timeout;
  if (message.status_port != 0) goal.status_port = message.status_port;
  return goal;
}

blocks::Goal toGoal(const cobot_command::MoveAbsoluteGoal& message) {
  blocks::MoveAbsoluteGoal goal;
  goal.command_id = message.command_id;
  goal.movement_command = message.movement_command;
  goal.data_format = message.data_format;
  goal.target = toSix(message.target_position);
  goal.speed = message.speed;
  goal.accel_time = message.accel_time;
  goal.blending_enable = message.blending_enable != 0;
  goal.blending_value = message.blending_value;
  goal.precise_positioning = message.precise_positioning != 0;
  goal.robot_pose_enable = message.robot_pose_enable != 0;
  goal.robot_pose = {message.robot_pose.config1, message.robot_pose.config2, message.robot_pose.config3};
  goal.exit_node = message.exit_node != 0;
  return goal;
}

void fill(cobot_command::ConnectResult& message, const blocks::Outcome& outcome) {
  fillError(message, outcome);
}

void fill(cobot_command::MoveAbsoluteResult& message, const blocks::Outcome& outcome) {
  fillError(message, outcome);
  message.command_id_ack = outcome.command_id_ack;
  message.planned_duration = toRos(outcome.planned);
  message.actual_duration = toRos(outcome.actual);
  if (outcome.final_joints_deg) {
    message.final_joints.assign(outcome.final_joints_deg->begin(), outcome.final_joints_deg->end());
  }
  if (outcome.final_pose_mm_deg) {
    const auto& pose = *outcome.final_pose_mm_deg;
    message.final_pose.x = pose[0];
    message.final_pose.y = pose[1];
    message.final_pose.z = pose[2];
    message.final_pose.rx = pose[3];
    message.final_pose.ry = pose[4];
    message.final_pose.rz = pose[5];
  }
}

void fill(cobot_command::ConnectFeedback& message, const blocks::Progress& progress) {
  message.phase = connectPhase(progress.phase);
  message.connected = progress.phase == blocks::Phase::Connected;
  message.text = progress.text;
}

void fill(cobot_command::MoveAbsoluteFeedback& message, const blocks::Progress& progress) {
  message.phase = movePhase(progress.phase);
  message.command_id_ack = progress.command_id_ack;
  message.planned_duration = toRos(progress.planned);
  message.text = progress.text;
}

ros::Time ClockPair::toRos(Instant instant) const {
  const std::int64_t since = (instant - core_now).count();
  const std::int64_t nanoseconds = static_cast<std::int64_t>(ros_now.toNSec()) + since;
  return ros::Time().fromNSec(static_cast<std::uint64_t>(std::max<std::int64_t>(nanoseconds, 0)));
}

cobot_command::CommandStatus toMessage(const blocks::CommandStatus& status, const ClockPair& clocks) {
  cobot_command::CommandStatus message;
  message.header.stamp = clocks.ros_now;
  message.link_state = toMessage(status.link);
  message.diagnosis = status.diagnosis;
  message.host = status.host;
  message.port = status.port;
  message.listen_node = status.listen_node;
  message.status_stream = status.status_stream;
  if (status.last_connected) message.last_connected = clocks.toRos(*status.last_connected);
  if (status.last_lost) message.last_lost = clocks.toRos(*status.last_lost);
  message.queue_depth = status.queue_depth;
  message.open_tags.assign(status.open_tags.begin(), status.open_tags.end());
  message.late_replies = status.late_replies;
  message.decode_faults = status.decode_faults;
  for (const blocks::BlockOutputs& outputs : status.blocks) message.blocks.push_back(toMessage(outputs));
  return message;
}

cobot_command::FrameTrace toMessage(const blocks::FrameTraced& trace, const ClockPair& clocks) {
  using Message = cobot_command::FrameTrace;
  Message message;
  message.header.stamp = clocks.toRos(trace.time);
  message.channel = trace.channel == link::Channel::Script ? Message::SCRIPT : Message::STATUS;
  message.sent = trace.sent;
  message.bytes.assign(trace.bytes.begin(), trace.bytes.end());
  message.text = protocol::printable(trace.bytes);
  message.meaning = trace.meaning;
  return message;
}

cobot_command::RobotStatus toMessage(const link::RobotStatus& status, const ros::Time& stamp) {
  using Message = cobot_command::RobotStatus;
  Message message;
  message.header.stamp = stamp;
  const int mode = status.operating_mode.value_or(0);
  message.mode = mode == 1   ? Message::MODE_AUTOMATIC
                 : mode == 2 ? Message::MODE_MANUAL
                             : Message::MODE_UNKNOWN;
  message.e_stopped = triState(status.emergency_stop);
  message.safeguard = triState(status.safeguard);
  message.in_motion = triState(inMotion(status));
  message.in_error = triState(status.error);
  message.error_code = status.error_code.value_or(0);
  message.error_text = status.error_text.value_or("");
  message.project_running = triState(status.project_running);
  message.project_paused = triState(status.project_paused);
  message.project_speed = status.project_speed_percent.value_or(-1);
  message.base_name = status.base_name.value_or("");
  message.tcp_name = status.tcp_name.value_or("");
  return message;
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

}  // namespace cobot_command::ros_adapter
