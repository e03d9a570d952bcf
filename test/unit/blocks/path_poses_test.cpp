// Path loading with poses in place of points: a template becomes a point for each of them.

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "block_goals.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using path::PathPoint;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pointwise;
using ::testing::SizeIs;

/// A line that says all but where.
PathPoint lineTemplate() {
  PathPoint point = pathLine({});
  point.move_id = 100;
  return point;
}

/// Its frame stands 0.5 m above the robot base.
FramedPose poseAt(double x, double y, double z) {
  FramedPose pose;
  pose.frame = "table";
  pose.position = {x, y, z};
  pose.quaternion = {1, 0, 0, 0};
  pose.frame_in_robot_base = arm::Pose::Identity();
  pose.frame_in_robot_base->translation().z() = 0.5;
  return pose;
}

std::vector<FramedPose> threePoses() {
  return {poseAt(0.3, 0, 0), poseAt(0.4, 0, 0), poseAt(0.4, 0.1, 0)};
}

/// All of them, with that template.
LoadPathGoal goalAt(const std::vector<FramedPose>& poses, const PathPoint& model = lineTemplate()) {
  LoadPathGoal goal;
  goal.path = {model};
  goal.number_of_moves = static_cast<int>(poses.size());
  placeAtPoses(goal, poses.size(), [&](std::size_t index) { return poses[index]; });
  return goal;
}

Outcome refusalOf(const LoadPathGoal& goal) {
  const auto failures = check(goal);
  return failures.empty() ? Outcome() : toRejection(kBlock<LoadPathGoal>, failures);
}

/// With the template changed.
template <class Change>
Outcome refusalWith(const Change& change) {
  PathPoint model = lineTemplate();
  change(model);
  return refusalOf(goalAt(threePoses(), model));
}

/// With the pose in the middle changed.
template <class Change>
Outcome refusalOfPose(const Change& change) {
  auto poses = threePoses();
  change(poses[1]);
  return refusalOf(goalAt(poses));
}

TEST(PathPoses, makeAPointEach) {
  PathPoint model = lineTemplate();
  model.pose_type = static_cast<int>(path::MovedFrame::Tool);
  model.pose_id = 3;
  model.termination_type = static_cast<int>(path::Termination::Blend);
  model.command_tolerance = 4;
  const LoadPathGoal goal = goalAt(threePoses(), model);
  EXPECT_EQ(refusalOf(goal).error_id, 0) << refusalOf(goal).error_description;
  ASSERT_THAT(goal.path, SizeIs(3));
  EXPECT_THAT(goal.path[2].pose, Pointwise(DoubleNear(1e-9), std::vector<double>{400, 100, 500, 180, 0, 0}));
  for (const PathPoint& point : goal.path) {
    EXPECT_TRUE(is(point.move_type, path::MoveType::Absolute));
    EXPECT_TRUE(is(point.target_type, path::TargetType::Cartesian));
    EXPECT_TRUE(is(point.ref_frame_type, path::Reference::Robot));
    EXPECT_EQ(point.pose_id, 3);
    EXPECT_EQ(point.command_tolerance, 4);
    EXPECT_EQ(point.speed, model.speed);
  }
}

TEST(PathPoses, needNoKindOfTargetInTheirTemplate) {
  PathPoint model = lineTemplate();
  model.target_type = static_cast<int>(path::TargetType::Joint);
  model.ref_frame_type = static_cast<int>(path::Reference::World);
  const LoadPathGoal goal = goalAt(threePoses(), model);
  EXPECT_TRUE(is(goal.path[1].target_type, path::TargetType::Cartesian));
  EXPECT_TRUE(is(goal.path[1].ref_frame_type, path::Reference::Robot));
  EXPECT_EQ(refusalOf(goal).error_id, 0);
}

TEST(PathPoses, areToldApartByTheirMoveId) {
  const LoadPathGoal goal = goalAt(threePoses());
  EXPECT_EQ(goal.path[0].move_id, 100);
  EXPECT_EQ(goal.path[2].move_id, 102);
  PathPoint model = lineTemplate();
  model.move_id = 0;
  EXPECT_EQ(goalAt(threePoses(), model).path[2].move_id, 0) << "the number of the goal";
  for (const int id : {std::numeric_limits<int>::min(), -3, std::numeric_limits<int>::max() - 2}) {
    EXPECT_EQ(refusalWith([=](PathPoint& p) { p.move_id = id; }).error_id, 0) << id;
  }
  for (const int id : {-1, -2, std::numeric_limits<int>::max() - 1, std::numeric_limits<int>::max()}) {
    const Outcome refused = refusalWith([=](PathPoint& p) { p.move_id = id; });
    EXPECT_EQ(refused.error_id, own_error::kPoseTemplate) << id;
    EXPECT_THAT(refused.error_description, HasSubstr("move_id is " + std::to_string(id)));
  }
}

TEST(PathPoses, areOnlyLookedAtWhereTheyAreLoaded) {
  auto poses = threePoses();
  poses[0].frame_in_robot_base.reset();
  poses[2].quaternion = {};
  LoadPathGoal goal;
  goal.path = {lineTemplate()};
  goal.start_index = 1;
  goal.number_of_moves = 1;
  std::vector<std::size_t> asked;
  placeAtPoses(goal, poses.size(), [&](std::size_t index) {
    asked.push_back(index);
    return poses[index];
  });
  EXPECT_THAT(asked, ElementsAre(1));
  EXPECT_EQ(refusalOf(goal).error_id, 0);
  EXPECT_EQ(goal.path[1].move_id, 101) << "counted from the first pose, loaded or not";
}

TEST(PathPoses, countAsPointsDo) {
  const auto refused = [](int start, int count) {
    LoadPathGoal goal;
    goal.path = {lineTemplate()};
    goal.start_index = start;
    goal.number_of_moves = count;
    placeAtPoses(goal, 3, [](std::size_t) { return poseAt(0.3, 0, 0); });
    return refusalOf(goal).error_id;
  };
  const int most = std::numeric_limits<int>::max();
  EXPECT_EQ(refused(0, 3), 0);
  EXPECT_EQ(refused(0, 0), 1010);
  EXPECT_EQ(refused(0, -1), 1010);
  EXPECT_EQ(refused(1, 3), 1010);
  EXPECT_EQ(refused(1, most), 1010);
  EXPECT_EQ(refused(3, 1), 1012);
  EXPECT_EQ(refused(-1, 1), 1012);
  EXPECT_EQ(refused(-most - 1, 1), 1012);
}

TEST(PathPoses, areAThousandAtMost) {
  EXPECT_EQ(refusalOf(goalAt(std::vector<FramedPose>(1000, poseAt(0.3, 0, 0)))).error_id, 0);
  LoadPathGoal goal;
  goal.path = {lineTemplate()};
  goal.number_of_moves = 1;
  placeAtPoses(goal, 1001, [](std::size_t) {
    ADD_FAILURE() << "they are refused by their number";
    return FramedPose();
  });
  EXPECT_EQ(refusalOf(goal).error_id, 1010);
  EXPECT_THAT(refusalOf(goal).error_description, HasSubstr("poses has 1001, allowed: 1 to 1000"));
  EXPECT_THAT(goal.path, IsEmpty());
}

TEST(PathPoses, haveExactlyOneTemplate) {
  for (const std::size_t count : {0U, 2U}) {
    LoadPathGoal goal;
    goal.path.assign(count, lineTemplate());
    goal.number_of_moves = 3;
    placeAtPoses(goal, 3, [](std::size_t) {
      ADD_FAILURE() << "nothing is to be looked up";
      return FramedPose();
    });
    EXPECT_EQ(refusalOf(goal).error_id, own_error::kPoseTemplate);
    EXPECT_THAT(refusalOf(goal).error_description,
                HasSubstr("poses has 3, and path " + std::to_string(count) + " points"));
    EXPECT_EQ(refusalOf(goal).detail.as<PathReport>().error_index, -1);
  }
}

TEST(PathPoses, refuseATemplateThatSaysWhere) {
  using path::Interpolation;
  const auto words = [](const auto& change) {
    const Outcome refused = refusalWith(change);
    EXPECT_EQ(refused.error_id, own_error::kPoseTemplate);
    return refused.error_description;
  };
  EXPECT_THAT(words([](PathPoint& p) { p.pose[3] = 180; }), HasSubstr("target of its own"));
  EXPECT_THAT(words([](PathPoint& p) { p.joints[2] = std::nan(""); }), HasSubstr("target of its own"));
  EXPECT_THAT(words([](PathPoint& p) { p.move_type = 1; }), HasSubstr("INCREMENTAL"));
  EXPECT_THAT(words([](PathPoint& p) { p.target_type = 2; }), HasSubstr("HYBRID"));
  EXPECT_THAT(words([](PathPoint& p) { p.ref_frame_type = 4; }), HasSubstr("USER"));
  EXPECT_THAT(words([](PathPoint& p) { p.interpolation = static_cast<int>(Interpolation::Circular); }),
              HasSubstr("CP_CIRCULAR"));
}

/// A number that is none of its enumeration is refused as that of a point.
TEST(PathPoses, leaveTheRestOfTheTemplateToTheChecksOfPoints) {
  EXPECT_EQ(refusalWith([](PathPoint& p) { p.move_type = 2; }).error_id, 1017);
  EXPECT_EQ(refusalWith([](PathPoint& p) { p.target_type = 3; }).error_id, 1018);
  EXPECT_EQ(refusalWith([](PathPoint& p) { p.interpolation = 4; }).error_id, 1020);
  EXPECT_EQ(refusalWith([](PathPoint& p) { p.pose_type = 0; }).error_id, 1027);
  EXPECT_EQ(refusalWith([](PathPoint& p) { p.ref_frame_type = 3; }).error_id, 1028);
}

TEST(PathPoses, blameThePoseWhoseFrameIsNotKnown) {
  const Outcome refused = refusalOfPose([](FramedPose& p) {
    p.frame_in_robot_base.reset();
    p.frame = "tabel";
    p.fault = "\"tabel\" does not exist";
  });
  EXPECT_EQ(refused.error_id, 1040);
  EXPECT_THAT(refused.error_description, HasSubstr("point 1: its pose is in \"tabel\": \"tabel\" does not"));
  EXPECT_THAT(refused.error_description, HasSubstr("publish it"));
  const auto& report = refused.detail.as<PathReport>();
  EXPECT_EQ(report.error_index, 1);
  ASSERT_THAT(report.points, SizeIs(2));
  EXPECT_EQ(report.points[1].error_id, 1040);
  EXPECT_EQ(refusalOfPose([](FramedPose& p) { p.frame_in_robot_base->linear()(0, 0) = kNan; }).error_id,
            1040);
}

TEST(PathPoses, blameThePoseThatIsNone) {
  for (const double number : {kNan, kInf, -kInf}) {
    EXPECT_EQ(refusalOfPose([=](FramedPose& p) { p.position[2] = number; }).error_id, 1037);
    EXPECT_EQ(refusalOfPose([=](FramedPose& p) { p.quaternion[1] = number; }).error_id, 1037);
  }
  for (const double length : {0.0, 0.9989, 1.0011, 1e300}) {
    const Outcome refused = refusalOfPose([=](FramedPose& p) { p.quaternion = {0, 0, 0, length}; });
    EXPECT_EQ(refused.error_id, 1037) << length;
    EXPECT_THAT(refused.error_description, HasSubstr("allowed: 1, within 0.001: normalise it"));
    EXPECT_EQ(refused.detail.as<PathReport>().error_index, 1);
  }
  for (const double length : {0.9991, 1.0009}) {
    EXPECT_EQ(refusalOfPose([=](FramedPose& p) { p.quaternion = {0, 0, 0, length}; }).error_id, 0) << length;
  }
  const Outcome far = refusalOfPose([](FramedPose& p) { p.position[0] = -417.5; });
  EXPECT_EQ(far.error_id, 1037);
  EXPECT_THAT(far.error_description, HasSubstr("417.5 m from the robot base, allowed: up to 100 m"));
}

TEST(PathPoses, comeBehindWhatTheirPointsSayByThemselves) {
  auto poses = threePoses();
  poses[0].quaternion = {};
  PathPoint model = lineTemplate();
  model.profile_type = 4;
  EXPECT_EQ(refusalOf(goalAt(poses, model)).error_id, 1025);
}

}  // namespace
}  // namespace cobot_command::testing
