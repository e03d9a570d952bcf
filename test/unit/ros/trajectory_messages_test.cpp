// The messages of follow_joint_trajectory, which are control_msgs'; no master is needed.

#include <control_msgs/FollowJointTrajectoryAction.h>
#include <gmock/gmock.h>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/ros/command/action_bridge.h"

namespace cobot_command::ros_adapter {

blocks::FollowJointTrajectoryGoal readGoal(const control_msgs::FollowJointTrajectoryGoal& message,
                                           const Lookups& lookups, const JointNames& names);
void fill(control_msgs::FollowJointTrajectoryResult& message, const blocks::Outcome& outcome,
          const FillSite& site);
void fill(control_msgs::FollowJointTrajectoryFeedback& message, const blocks::Progress& progress,
          const FillSite& site);

namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Result = control_msgs::FollowJointTrajectoryResult;

class TrajectoryMessages : public ::testing::Test {
 protected:
  TrajectoryMessages() {
    ros::Time::init();
    for (const std::size_t joint : {3U, 1U, 6U, 2U, 5U, 4U}) {
      message.trajectory.joint_names.push_back(names.at(joint - 1));
    }
    trajectory_msgs::JointTrajectoryPoint point;
    point.positions = {3, 1, 6, 2, 5, 4};
    point.time_from_start = ros::Duration(1.5);
    message.trajectory.points.push_back(point);
  }
  [[nodiscard]] blocks::FollowJointTrajectoryGoal goal() const { return readGoal(message, Lookups(), names); }
  [[nodiscard]] Result resultOf(blocks::Ending ending, int error_id) const {
    blocks::Outcome outcome;
    outcome.ending = ending;
    outcome.error_id = error_id;
    outcome.error_description = "What: found";
    outcome.remedy = "Do this";
    Result result;
    fill(result, outcome, {names, {}});
    return result;
  }

  JointNames names = jointNames("arm_");
  control_msgs::FollowJointTrajectoryGoal message;
};

TEST_F(TrajectoryMessages, nameTheJointsInAnyOrder) {
  message.trajectory.points[0].velocities = {0.3, 0.1, 0.6, 0.2, 0.5, 0.4};
  EXPECT_EQ(goal().names_fault, "");
  EXPECT_THAT(goal().points.at(0).positions, ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_THAT(goal().points.at(0).velocities, ElementsAre(0.1, 0.2, 0.3, 0.4, 0.5, 0.6));
  EXPECT_EQ(goal().points.at(0).time, 1.5);
}

TEST_F(TrajectoryMessages, leaveWrongSizesToTheCore) {
  message.trajectory.points[0].positions.pop_back();
  EXPECT_EQ(goal().points.at(0).positions.size(), 5U);
  EXPECT_THAT(goal().points.at(0).velocities, IsEmpty());
}

TEST_F(TrajectoryMessages, sayWhichJointIsWrong) {
  auto& given = message.trajectory.joint_names;
  given[0] = "joint_3";
  EXPECT_THAT(goal().names_fault,
              HasSubstr("joint_3 is not a joint of this robot; allowed: each of arm_shoulder_1_joint, "));
  given[0] = given[1];
  EXPECT_THAT(goal().names_fault, HasSubstr("arm_shoulder_1_joint is listed twice"));
  given.erase(given.begin());
  EXPECT_THAT(goal().names_fault, HasSubstr("arm_elbow_joint is missing"));
  given.clear();
  EXPECT_THAT(goal().names_fault, HasSubstr("arm_shoulder_1_joint is missing"));
  message.trajectory.points.clear();
  EXPECT_EQ(goal().names_fault, "") << "without points and names it stops what is under way";
}

TEST_F(TrajectoryMessages, giveTolerancesByName) {
  control_msgs::JointTolerance tolerance;
  tolerance.name = "arm_wrist_2_joint";
  tolerance.position = 0.25;
  message.path_tolerance.push_back(tolerance);
  tolerance.position = -1;
  message.goal_tolerance.push_back(tolerance);
  message.goal_time_tolerance = ros::Duration(2.5);
  EXPECT_THAT(goal().path_tolerance, ElementsAre(0, 0, 0, 0, 0.25, 0));
  EXPECT_THAT(goal().goal_tolerance, ElementsAre(0, 0, 0, 0, -1, 0));
  EXPECT_EQ(goal().goal_time_tolerance, 2.5);
  message.goal_tolerance[0].name = "finger";
  EXPECT_THAT(goal().names_fault, HasSubstr("a tolerance is given for finger"));
}

TEST_F(TrajectoryMessages, beginAtTheirStamp) {
  EXPECT_EQ(goal().starts_in, 0);
  message.trajectory.header.stamp = ros::Time::now() + ros::Duration(100);
  EXPECT_NEAR(goal().starts_in, 100, 10);
  message.trajectory.header.stamp = ros::Time::now() - ros::Duration(100);
  EXPECT_NEAR(goal().starts_in, -100, 10);
}

TEST_F(TrajectoryMessages, haveCodesForSomeErrors) {
  using namespace blocks::own_error;
  using blocks::Ending;
  EXPECT_EQ(resultOf(Ending::Done, 0).error_code, Result::SUCCESSFUL);
  EXPECT_EQ(resultOf(Ending::CommandAborted, 0).error_code, Result::SUCCESSFUL);
  EXPECT_EQ(resultOf(Ending::CommandAborted, 0).error_string, "What: found");
  EXPECT_EQ(resultOf(Ending::Rejected, kJointNames).error_code, Result::INVALID_JOINTS);
  EXPECT_EQ(resultOf(Ending::Rejected, kStampOld).error_code, Result::OLD_HEADER_TIMESTAMP);
  EXPECT_EQ(resultOf(Ending::Rejected, kNotAtStart).error_code, Result::INVALID_GOAL);
  EXPECT_EQ(resultOf(Ending::Rejected, kJointSpeed).error_code, Result::INVALID_GOAL);
  EXPECT_EQ(resultOf(Ending::Aborted, kPathTolerance).error_code, Result::PATH_TOLERANCE_VIOLATED);
  EXPECT_EQ(resultOf(Ending::Aborted, kGoalTolerance).error_code, Result::GOAL_TOLERANCE_VIOLATED);
  EXPECT_EQ(resultOf(Ending::Aborted, 0x99).error_code, 0x99) << "there is none for it";
  EXPECT_EQ(resultOf(Ending::Aborted, 0x99).error_string, "16#99 What: found; Do this");
}

TEST_F(TrajectoryMessages, tellWhereTheJointsShouldBeAndAre) {
  blocks::TrajectoryPlace place;
  place.time = std::chrono::milliseconds(500);
  place.desired = {1, 2, 3, 4, 5, 6};
  place.desired_velocities = {6, 5, 4, 3, 2, 1};
  place.actual = blocks::SixValues{1, 2, 3, 4, 5, 5.5};
  blocks::Progress progress;
  control_msgs::FollowJointTrajectoryFeedback before;
  fill(before, progress, {names, {}});
  EXPECT_EQ(before.joint_names.size(), 6U);
  EXPECT_THAT(before.desired.positions, IsEmpty());
  progress.detail = blocks::Detail(place);
  control_msgs::FollowJointTrajectoryFeedback feedback;
  fill(feedback, progress, {names, {ros::Time(7), {}}});
  EXPECT_EQ(feedback.header.stamp, ros::Time(7));
  EXPECT_THAT(feedback.desired.positions, ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_THAT(feedback.desired.velocities, ElementsAre(6, 5, 4, 3, 2, 1));
  EXPECT_EQ(feedback.desired.time_from_start, ros::Duration(0.5));
  EXPECT_THAT(feedback.actual.positions, ElementsAre(1, 2, 3, 4, 5, 5.5));
  EXPECT_THAT(feedback.error.positions, ElementsAre(0, 0, 0, 0, 0, 0.5));
}

}  // namespace
}  // namespace cobot_command::ros_adapter
