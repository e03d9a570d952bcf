#include "command/status_messages.h"

#include <chrono>

#include "shared/robot_status_message.h"
#include <gmock/gmock.h>

namespace cobot_command::ros_adapter {
namespace {

arm::Pose at(double x, double y, double z) {
  arm::Pose pose = arm::Pose::Identity();
  pose.translation() = Eigen::Vector3d(x, y, z);
  return pose;
}

TEST(StatusMessages, aPoseSurvivesTheWayThroughAMessage) {
  arm::Pose pose = at(0.1, -0.2, 0.3);
  pose.rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  EXPECT_TRUE(toPose(toTransform(pose)).isApprox(pose, 1e-12));
}

TEST(StatusMessages, theCoresTimeBecomesRosTime) {
  const ClockPair clocks{ros::Time(1000), Instant(std::chrono::seconds(50))};
  EXPECT_EQ(clocks.toRos(Instant(std::chrono::seconds(48))), ros::Time(998));
  EXPECT_EQ(clocks.toRos(Instant(std::chrono::seconds(-2000))), ros::Time(0)) << "never before the epoch";
}

TEST(StatusMessages, activeFramesThatAreKnownAreTold) {
  robot::ActiveFrames frames;
  frames.base = at(0.5, 0, 0);
  frames.base_name = "pallet";
  frames.tcp = at(0, 0, 0.12);
  frames.tcp_name = "gripper";
  frames.tool_mass = 1.5;
  const auto message = toMessage(frames, "left_base", ros::Time(12));
  EXPECT_EQ(message.header.frame_id, "left_base");
  EXPECT_EQ(message.header.stamp, ros::Time(12));
  EXPECT_TRUE(message.base_known);
  EXPECT_EQ(message.base.position.x, 0.5);
  EXPECT_EQ(message.base_name, "pallet");
  EXPECT_TRUE(message.tcp_known);
  EXPECT_EQ(message.tcp.position.z, 0.12);
  EXPECT_EQ(message.tcp_name, "gripper");
  EXPECT_EQ(message.tool_mass, 1.5);
}

TEST(StatusMessages, activeFramesThatAreUnknownAreSaidToBeAndStillArePoses) {
  const auto message = toMessage(robot::ActiveFrames{}, "base", ros::Time(12));
  EXPECT_FALSE(message.base_known);
  EXPECT_FALSE(message.tcp_known);
  EXPECT_EQ(message.base.orientation.w, 1);
  EXPECT_EQ(message.tcp.orientation.w, 1);
  EXPECT_EQ(message.tool_mass, -1);
}

TEST(StatusMessages, digitalLevelsAreToldByTheirNumbers) {
  link::DigitalLevels inputs;
  inputs.control_box[15] = true;
  inputs.end_module[0] = false;
  link::DigitalLevels outputs;
  outputs.control_box[0] = false;
  outputs.end_module[3] = true;
  const auto message = toMessage(inputs, outputs, ros::Time(12));
  EXPECT_EQ(message.header.stamp, ros::Time(12));
  EXPECT_EQ(message.control_box_inputs[15], cobot_command::DigitalIo::ON);
  EXPECT_EQ(message.end_module_inputs[0], cobot_command::DigitalIo::OFF);
  EXPECT_EQ(message.control_box_outputs[0], cobot_command::DigitalIo::OFF);
  EXPECT_EQ(message.end_module_outputs[3], cobot_command::DigitalIo::ON);
}

TEST(StatusMessages, digitalLevelsThatAreNotStreamedAreUnknown) {
  const auto message = toMessage(link::DigitalLevels{}, link::DigitalLevels{}, ros::Time(12));
  EXPECT_THAT(message.control_box_inputs, ::testing::Each(cobot_command::DigitalIo::UNKNOWN));
  EXPECT_THAT(message.control_box_outputs, ::testing::Each(cobot_command::DigitalIo::UNKNOWN));
  EXPECT_THAT(message.end_module_inputs, ::testing::Each(cobot_command::DigitalIo::UNKNOWN));
  EXPECT_THAT(message.end_module_outputs, ::testing::Each(cobot_command::DigitalIo::UNKNOWN));
}

TEST(StatusMessages, theStatusSaysWhyThereIsNoStatusStream) {
  command::CommandStatus status;
  status.status_diagnosis = "the status stream has stopped";
  const auto message = toMessage(status, ClockPair{ros::Time(1), Instant{}});
  EXPECT_FALSE(message.status_stream);
  EXPECT_EQ(message.status_diagnosis, "the status stream has stopped");
}

TEST(StatusMessages, whatWasSentAndWhatWaitsAreCountedApart) {
  command::CommandStatus status;
  status.queue_depth = 4;
  status.commands_under_way = 1;
  status.commands_waiting = 3;
  status.waiting_return = true;
  const auto message = toMessage(status, {ros::Time(1000), Instant{}});
  EXPECT_EQ(message.queue_depth, 4);
  EXPECT_EQ(message.commands_under_way, 1);
  EXPECT_EQ(message.commands_waiting, 3);
  EXPECT_TRUE(message.waiting_return);
}

}  // namespace
}  // namespace cobot_command::ros_adapter
