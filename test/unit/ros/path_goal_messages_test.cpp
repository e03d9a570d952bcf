// What of a goal of load_path arrives in the core.
#include <string>
#include <vector>

#include "block_messages.h"
#include "files/path_file.h"
#include "no_lookups.h"
#include "source_tree.h"
#include <gmock/gmock.h>

#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::ros_adapter {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const Lookups onlyPaths{noFrame, noSteps, readPathFile};

/// Each field another value.
cobot_command::PathPoint pathPoint() {
  cobot_command::PathPoint point;
  point.move_id = 101;
  point.move_type = 102;
  point.target_point_type = 103;
  point.interpolation_type = 104;
  point.pose = toTransformation({105, 106, 107, 108, 109, 110});
  point.pose_type = 106;
  point.pose_id = 107;
  point.ref_frame_type = 108;
  point.ref_frame_id = 109;
  for (std::size_t i = 0; i < point.joints.size(); ++i) point.joints[i] = 110 + static_cast<double>(i);
  point.via_pose = toTransformation({120, 121, 122, 123, 124, 125});
  point.termination_type = 130;
  point.command_tolerance = 131;
  point.robot_configuration = 132;
  point.profile_type = 133;
  point.speed = 134;
  point.acceleration = 135;
  point.deceleration = 136;
  point.acceleration_jerk = 137;
  point.deceleration_jerk = 138;
  point.orientation_speed = 139;
  point.orientation_acceleration = 140;
  point.orientation_deceleration = 141;
  point.tracking_axis_position = 142;
  return point;
}

TEST(PathGoalMessages, theWorldIsLookedUpForPosesThatAreInIt) {
  cobot_command::LoadPathGoal message;
  message.path.resize(2);
  message.path[0].target_point_type = cobot_command::PathPoint::CARTESIAN;
  message.path[0].ref_frame_type = cobot_command::PathPoint::ROBOT;
  message.path[1].target_point_type = cobot_command::PathPoint::JOINT;
  EXPECT_FALSE(toGoal(message, onlyPaths).world) << "none is in it";
  std::string asked;
  Lookups lookups = onlyPaths;
  lookups.world_frame = "cell";
  lookups.frames = [&](const std_msgs::Header& header) {
    asked = header.frame_id;
    return FramePlace{std::nullopt, "nobody publishes it"};
  };
  message.path[0].ref_frame_type = cobot_command::PathPoint::WORLD;
  EXPECT_EQ(toGoal(message, lookups).world_fault, "nobody publishes it");
  EXPECT_EQ(asked, "cell");
  arm::Pose place = arm::Pose::Identity();
  place.translation().z() = 0.5;
  lookups.frames = [&](const std_msgs::Header&) { return FramePlace{place, ""}; };
  EXPECT_EQ(toGoal(message, lookups).world->translation().z(), 0.5);
}

TEST(PathGoalMessages, everyFieldOfAPathPointArrives) {
  cobot_command::LoadPathGoal message;
  message.path.push_back(pathPoint());
  const auto goal = toGoal(message, onlyPaths);
  ASSERT_EQ(goal.path.size(), 1U);
  const path::PathPoint& point = goal.path.front();
  EXPECT_EQ(point.move_id, 101);
  EXPECT_EQ(point.move_type, 102);
  EXPECT_EQ(point.target_type, 103);
  EXPECT_EQ(point.interpolation, 104);
  EXPECT_THAT(point.pose, ElementsAre(105, 106, 107, 108, 109, 110));
  EXPECT_EQ(point.pose_type, 106);
  EXPECT_EQ(point.pose_id, 107);
  EXPECT_EQ(point.ref_frame_type, 108);
  EXPECT_EQ(point.ref_frame_id, 109);
  EXPECT_THAT(point.joints, ElementsAre(110, 111, 112, 113, 114, 115, 116, 117, 118));
  EXPECT_THAT(point.via_pose, ElementsAre(120, 121, 122, 123, 124, 125));
  EXPECT_EQ(point.termination_type, 130);
  EXPECT_EQ(point.command_tolerance, 131);
  EXPECT_EQ(point.robot_configuration, 132);
  EXPECT_EQ(point.profile_type, 133);
  EXPECT_EQ(point.speed, 134);
  EXPECT_EQ(point.acceleration, 135);
  EXPECT_EQ(point.deceleration, 136);
  EXPECT_EQ(point.acceleration_jerk, 137);
  EXPECT_EQ(point.deceleration_jerk, 138);
  EXPECT_EQ(point.orientation_speed, 139);
  EXPECT_EQ(point.orientation_acceleration, 140);
  EXPECT_EQ(point.orientation_deceleration, 141);
  EXPECT_EQ(point.tracking_axis_position, 142);
}

TEST(PathGoalMessages, everyFieldOfLoadPathArrives) {
  cobot_command::LoadPathGoal message;
  message.start_index = 3;
  message.number_of_moves = 4;
  message.enable_tracking_0 = true;
  message.execution = cobot_command::LoadPathGoal::PVT;
  message.allow_approximation = true;
  message.buffer_mode = 2;
  message.max_deviation = 1.5;
  message.check_only = true;
  const auto goal = toGoal(message, onlyPaths);
  EXPECT_EQ(goal.start_index, 3);
  EXPECT_EQ(goal.number_of_moves, 4);
  EXPECT_TRUE(goal.enable_tracking[0] && !goal.enable_tracking[1]);
  EXPECT_EQ(goal.execution, 2);
  EXPECT_TRUE(goal.allow_approximation);
  EXPECT_EQ(goal.buffer_mode, 2);
  EXPECT_EQ(goal.max_deviation, 1.5);
  EXPECT_TRUE(goal.check_only);
  EXPECT_EQ(goal.path_fault, "");
  message.enable_tracking_0 = false;
  message.enable_tracking_1 = true;
  EXPECT_TRUE(toGoal(message, onlyPaths).enable_tracking[1]);
}

TEST(PathGoalMessages, thePointsOfAPathMayStandInAFile) {
  cobot_command::LoadPathGoal message;
  message.path_file = test_support::inSourceTree("config/path.yaml");
  EXPECT_EQ(toGoal(message, onlyPaths).path_fault, "");
  EXPECT_EQ(toGoal(message, onlyPaths).path.size(), 7U);
  message.path.resize(1);
  EXPECT_THAT(toGoal(message, onlyPaths).path_fault, HasSubstr("give one"));
  message.path.clear();
  message.path_file = "/no/such/file.yaml";
  EXPECT_THAT(toGoal(message, onlyPaths).path_fault, HasSubstr("/no/such/file.yaml"));
}

geometry_msgs::PoseStamped poseIn(const std::string& frame) {
  geometry_msgs::PoseStamped pose;
  pose.header.frame_id = frame;
  pose.pose.position.x = 0.25;
  pose.pose.orientation.x = 1;
  return pose;
}

cobot_command::LoadPathGoal pathOfPoses(const std::vector<geometry_msgs::PoseStamped>& poses) {
  cobot_command::LoadPathGoal message;
  message.path.resize(1);
  message.path[0].interpolation_type = cobot_command::PathPoint::CP_LINEAR;
  message.path[0].move_id = 10;
  message.poses = poses;
  message.number_of_moves = static_cast<int>(poses.size());
  return message;
}

TEST(PathGoalMessages, posesBecomePointsOfTheirTemplate) {
  auto message = pathOfPoses({poseIn("table"), poseIn(""), poseIn("table"), poseIn("table")});
  message.poses[3].header.stamp = ros::Time(7);
  std::vector<std_msgs::Header> asked;
  arm::Pose place = arm::Pose::Identity();
  place.translation().z() = 0.5;
  Lookups lookups = onlyPaths;
  lookups.frames = [&](const std_msgs::Header& header) {
    asked.push_back(header);
    return FramePlace{place, ""};
  };
  const auto goal = toGoal(message, lookups);
  ASSERT_FALSE(goal.poses_fault) << goal.poses_fault->found;
  ASSERT_EQ(goal.path.size(), 4U);
  EXPECT_THAT(goal.path[0].pose, ElementsAre(250, 0, 500, 180, 0, 0));
  EXPECT_THAT(goal.path[1].pose, ElementsAre(250, 0, 0, 180, 0, 0)) << "in the robot base";
  EXPECT_EQ(goal.path[2].interpolation, cobot_command::PathPoint::CP_LINEAR);
  EXPECT_EQ(goal.path[2].move_id, 12);
  ASSERT_EQ(asked.size(), 2U) << "each frame once at each stamp: it may be moving";
  EXPECT_EQ(asked[0].frame_id, "table");
  EXPECT_TRUE(asked[0].stamp.isZero());
  EXPECT_EQ(asked[1].stamp, ros::Time(7));
}

TEST(PathGoalMessages, posesAreLookedUpUntilTheFirstUnknownFrame) {
  std::vector<std::string> asked;
  Lookups lookups = onlyPaths;
  lookups.frames = [&](const std_msgs::Header& header) {
    asked.push_back(header.frame_id);
    return header.frame_id == "table" ? FramePlace{arm::Pose(arm::Pose::Identity()), ""}
                                      : FramePlace{std::nullopt, "nobody publishes it"};
  };
  const auto goal = toGoal(pathOfPoses({poseIn("table"), poseIn("tabel"), poseIn("shelf")}), lookups);
  ASSERT_TRUE(goal.poses_fault);
  EXPECT_EQ(goal.poses_fault->error_id, 1040);
  EXPECT_EQ(goal.poses_fault->index, 1);
  EXPECT_THAT(goal.poses_fault->found, HasSubstr("\"tabel\": nobody publishes it"));
  EXPECT_THAT(asked, ElementsAre("table", "tabel"));
}

TEST(PathGoalMessages, posesAreNotLookedUpForATemplateThatIsNone) {
  auto message = pathOfPoses({poseIn("table")});
  message.path.resize(2);
  EXPECT_EQ(toGoal(message, onlyPaths).poses_fault->error_id, 0x27A);
  message = pathOfPoses(std::vector<geometry_msgs::PoseStamped>(1001, poseIn("table")));
  EXPECT_EQ(toGoal(message, onlyPaths).poses_fault->error_id, 1010);
  message = pathOfPoses({poseIn("table")});
  message.path_file = "/no/such/file.yaml";
  EXPECT_THAT(toGoal(message, onlyPaths).path_fault, HasSubstr("give the template of the poses in path"));
}

TEST(PathGoalMessages, tooManyPointsAreOnlyCounted) {
  cobot_command::LoadPathGoal message;
  message.path.assign(1001, pathPoint());
  const auto goal = toGoal(message, onlyPaths);
  EXPECT_EQ(goal.path.size(), 1001U);
  EXPECT_EQ(goal.path.front().move_id, 0);
}

}  // namespace
}  // namespace cobot_command::ros_adapter
