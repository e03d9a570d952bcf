// How a path goes, as a message.
#include "paths/path_messages.h"

#include <gtest/gtest.h>

namespace cobot_command::ros_adapter {
namespace {

using Message = cobot_command::PathStatus;

TEST(PathMessages, sayAllOfHowAPathGoes) {
  blocks::PathStatus status;
  status.path_planner_active = true;
  status.active_move_id = 20;
  status.active_interpolation = 1;
  status.active_type = 3;
  status.active_type_id = 7;
  status.active_ref_frame_type = 4;
  status.active_ref_frame_id = 9;
  status.active_move_percent = 90.5;
  status.blending_move_id = 21;
  status.blending_move_percent = 4.5;
  status.linear_velocity = 150;
  status.linear_acceleration = 600;
  status.angular_velocity = 60;
  status.angular_acceleration = 240;
  status.feedrate = 80;
  status.feedrate_effective = 50;
  status.gate_waits = true;
  status.source = blocks::ProgressSource::Stream;
  const Message message = toMessage(status, ros::Time(12));
  EXPECT_EQ(message.header.stamp, ros::Time(12));
  EXPECT_TRUE(message.path_planner_active);
  EXPECT_EQ(message.active_move_id, 20);
  EXPECT_EQ(message.active_interpolation, 1);
  EXPECT_EQ(message.active_type, 3);
  EXPECT_EQ(message.active_type_id, 7);
  EXPECT_EQ(message.active_ref_frame_type, 4);
  EXPECT_EQ(message.active_ref_frame_id, 9);
  EXPECT_EQ(message.active_move_percent, 90.5);
  EXPECT_EQ(message.blending_move_id, 21);
  EXPECT_EQ(message.blending_move_percent, 4.5);
  EXPECT_EQ(message.linear_velocity, 150);
  EXPECT_EQ(message.linear_acceleration, 600);
  EXPECT_EQ(message.angular_velocity, 60);
  EXPECT_EQ(message.angular_acceleration, 240);
  EXPECT_EQ(message.feedrate, 80);
  EXPECT_EQ(message.feedrate_effective, 50);
  EXPECT_TRUE(message.gate_waits);
  EXPECT_EQ(message.progress_source, Message::STREAM);
}

TEST(PathMessages, withoutAPathAreOfNoneAtTheFullFeedrate) {
  const Message message = toMessage(blocks::PathStatus(), ros::Time(12));
  EXPECT_FALSE(message.path_planner_active);
  EXPECT_EQ(message.active_move_id, 0);
  EXPECT_EQ(message.feedrate, 100);
  EXPECT_EQ(message.progress_source, Message::PLAN);
}

}  // namespace
}  // namespace cobot_command::ros_adapter
