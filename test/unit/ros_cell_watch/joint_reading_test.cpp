// Joint states as the monitor reads them: by their names, and not at all where it cannot be sure.
#include "cell_watch/joint_reading.h"

#include <algorithm>

#include <gmock/gmock.h>

#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::ros_adapter {
namespace {

const arm::JointVector kJoints = (arm::JointVector() << 0.1, 0.2, 0.3, 0.4, 0.5, 0.6).finished();
const arm::JointVector kVelocities = 2 * kJoints;

sensor_msgs::JointState stateOf(const std::string& prefix) {
  return jointState(jointNames(prefix), kJoints, &kVelocities, nullptr, ros::Time(3));
}

TEST(JointReading, isWhatTheCommandNodeHasWritten) {
  const auto reading = readJoints(stateOf("RA_"));
  ASSERT_TRUE(reading);
  EXPECT_EQ(reading->joints, kJoints);
  ASSERT_TRUE(reading->velocities);
  EXPECT_EQ(*reading->velocities, kVelocities);
  EXPECT_EQ(reading->prefix, "RA_");
  EXPECT_EQ(readJoints(stateOf(""))->prefix, "");
}

TEST(JointReading, goesByNamesAndNotByTheirOrder) {
  sensor_msgs::JointState state = stateOf("RA_");
  state.name.push_back("gripper");
  state.position.push_back(9);
  state.velocity.push_back(9);
  for (auto* list : {&state.position, &state.velocity}) std::reverse(list->begin(), list->end());
  std::reverse(state.name.begin(), state.name.end());
  const auto reading = readJoints(state);
  ASSERT_TRUE(reading);
  EXPECT_EQ(reading->joints, kJoints);
  EXPECT_EQ(*reading->velocities, kVelocities);
}

TEST(JointReading, doesWithoutVelocities) {
  sensor_msgs::JointState state = stateOf("");
  state.velocity.clear();
  ASSERT_TRUE(readJoints(state));
  EXPECT_FALSE(readJoints(state)->velocities);
}

TEST(JointReading, isNothingWhereAJointIsMissingOrThereTwice) {
  sensor_msgs::JointState missing = stateOf("RA_");
  missing.name[2] = "elbow";
  EXPECT_FALSE(readJoints(missing));
  sensor_msgs::JointState two_robots = stateOf("RA_");
  const sensor_msgs::JointState other = stateOf("RB_");
  two_robots.name.insert(two_robots.name.end(), other.name.begin(), other.name.end());
  two_robots.position.insert(two_robots.position.end(), other.position.begin(), other.position.end());
  EXPECT_FALSE(readJoints(two_robots));
  sensor_msgs::JointState mixed = stateOf("RA_");
  mixed.name[5] = other.name[5];
  EXPECT_FALSE(readJoints(mixed));
}

TEST(JointReading, isNothingWhereNumbersAreMissing) {
  sensor_msgs::JointState state = stateOf("RA_");
  state.position.pop_back();
  EXPECT_FALSE(readJoints(state));
  EXPECT_FALSE(readJoints(sensor_msgs::JointState()));
}

}  // namespace
}  // namespace cobot_command::ros_adapter
