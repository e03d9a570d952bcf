#include "cell_watch/joint_reading.h"

#include <cstddef>

#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::ros_adapter {
namespace {

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Nothing: none, or several.
std::optional<std::size_t> onlyOneNamed(const sensor_msgs::JointState& message, const std::string& end) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < message.name.size(); ++i) {
    if (!endsWith(message.name[i], end)) continue;
    if (found) return std::nullopt;
    found = i;
  }
  return found;
}

}  // namespace

std::optional<JointReading> readJoints(const sensor_msgs::JointState& message) {
  const std::size_t count = message.name.size();
  if (message.position.size() != count) return std::nullopt;
  static const JointNames names = jointNames("");
  JointReading reading;
  if (message.velocity.size() == count) reading.velocities.emplace();
  for (std::size_t joint = 0; joint < names.size(); ++joint) {
    const auto place = onlyOneNamed(message, names[joint]);
    if (!place) return std::nullopt;
    const std::string& name = message.name[*place];
    const std::string prefix = name.substr(0, name.size() - names[joint].size());
    if (joint == 0) reading.prefix = prefix;
    if (prefix != reading.prefix) return std::nullopt;
    const auto index = static_cast<Eigen::Index>(joint);
    reading.joints[index] = message.position[*place];
    if (reading.velocities) (*reading.velocities)[index] = message.velocity[*place];
  }
  return reading;
}

}  // namespace cobot_command::ros_adapter
