// Where the targets of points are: frames, configurations, increments, hybrids.
#include <algorithm>
#include <cmath>
#include <functional>

#include "path_support.h"
#include <gmock/gmock.h>

namespace cobot_command::path {
namespace {

using ::testing::HasSubstr;

class PathTargets : public Paths {
 protected:
  void configure(const std::function<void(tables::Entries&)>& fill) {
    tables::Entries entries;
    fill(entries);
    scene.tables = *tables::DataTables::of(std::move(entries), {});
  }
};

class PathTargetsOfASmallArm : public Paths {
 protected:
  PathTargetsOfASmallArm() : Paths("tm5-700") {}
};

TEST_F(PathTargetsOfASmallArm, haveThePostureOfTheirConfigurationValue) {
  const arm::ControllerPose pose{417.5, -122.3, 361.05, 180, 0, 90};
  const auto reached = [&](int value) { return endOf(planned({toPose(pose, Interpolation::Ptp, value)})); };
  expectJoints(reached(5), {0, 0, 90, 0, 90, 0});
  expectJoints(reached(13), {0, 43.1401, 30.2710, -163.4111, -90, 180});
  expectJoints(reached(1), {0, 86.8699, -90, 93.1301, 90, 0});
  expectJoints(reached(7), {147.3458, 0, -90, 0, -90, -32.6542});
}

TEST_F(PathTargets, areInTheFrameAndOfTheToolThatThePointNames) {
  configure([](tables::Entries& entries) {
    entries.tools[1] = tables::Tool{"", arm::toPose({0, 0, 150, 0, 0, 0}), 0};
    entries.frames[4] = tables::Frame{"", arm::toPose({400, 0, 100, 0, 0, 90}), 0};
  });
  PathPoint point = toPose({100, 50, 200, 180, 0, 0}, Interpolation::Ptp, 5);
  point.pose_type = number(MovedFrame::Tool);
  point.pose_id = 1;
  point.ref_frame_type = number(Reference::User);
  point.ref_frame_id = 4;
  const arm::JointVector reached = endOf(planned({point}));
  expectJoints(reached, {35.5778, -23.9062, 110.3180, 3.5882, 90, 35.5778});
  EXPECT_NEAR(flangeAt(reached)[2], 450.0, 1e-6);
}

TEST_F(PathTargets, mayBeInTheWorldWhereTfKnowsIt) {
  PathPoint point = toPose({517.5, -122.3, 461.05, 180, 0, 90}, Interpolation::Ptp, 5);
  point.ref_frame_type = number(Reference::World);
  EXPECT_EQ(refused({point}).error_id, path_error::kWorldUnknown);
  scene.world = arm::toPose({0, 0, 100, 0, 0, 0});
  EXPECT_NEAR(flangeAt(endOf(planned({point})))[2], 561.05, 1e-6);
}

TEST_F(PathTargets, keepThePostureOfTheTargetBeforeWithoutAConfiguration) {
  const arm::ControllerPose pose = flangeAt(degrees(10, 20, 80, -10, 80, 5));
  const auto bits = arm::poseBitsOf(scene.arm, scene.start);
  EXPECT_EQ(arm::poseBitsOf(scene.arm, endOf(planned({toPose(pose, Interpolation::Ptp)}))), bits);
}

TEST_F(PathTargets, ofAWristMoveMayChangeTheFlip) {
  scene.start = degrees(0, 0, 90, 0, 30, 0);
  const arm::ControllerPose from = flangeAt(scene.start);
  const PathPlan plan = planned({toHybrid({from[0], from[1] + 200, from[2]}, {0, -30, 0})});
  expectJoints(endOf(plan), {22.9278, -6.5706, 108.7367, 0, -30, 0});
  const arm::JointVector middle = plan.at(plan.duration() / 2).position;
  expectJoints(middle, {13.2200, -5.1230, 101.2085, 0, 0, 0});
  EXPECT_NEAR(flangeAt(middle)[1], -120.291, 1e-3);
}

TEST_F(PathTargets, ofALineMayNot) {
  scene.start = degrees(0, 0, 90, 0, 30, 0);
  const arm::ControllerPose from = flangeAt(scene.start);
  const PathPoint line = toHybrid({from[0], from[1] + 200, from[2]}, {0, -30, 0}, Interpolation::Linear);
  EXPECT_EQ(refused({line}).error_id, path_error::kOtherConfiguration);
}

TEST_F(PathTargets, ofAWristMoveMayTurnAWholeTurn) {
  scene.start = degrees(0, 0, 90, 0, 90, -180);
  const arm::ControllerPose from = flangeAt(scene.start);
  const PathPlan plan = planned({toHybrid({from[0], from[1], from[2] + 100}, {0, 90, 180})});
  expectJoints(endOf(plan), {0, -1.6118, 80.6824, 0, 90, 180});
  expectJoints(plan.at(plan.duration() / 2).position, {0, -1.1297, 85.6338, 0, 90, 0});
}

TEST_F(PathTargets, ofHybridsGoByPtpToTheAskedShoulderAndElbow) {
  scene.start = degrees(0, 0, 90, 0, 30, 0);
  const arm::ControllerPose from = flangeAt(scene.start);
  PathPoint point = toHybrid({from[0], from[1] + 200, from[2]}, {0, -30, 0}, Interpolation::Ptp);
  point.robot_configuration = 0b1001;  // righty, below, flip
  expectJoints(endOf(planned({point})), {22.9278, 109.6312, -96.2587, 0, -30, 0});
  point.robot_configuration = 0b0001;  // noflip does not go with J5 < 0 of a right arm
  EXPECT_EQ(refused({point}).error_id, path_error::kConfiguration);
}

TEST_F(PathTargets, areIncrementsOfTheTargetBeforeEvenIfThatIsBlendedPast) {
  const PathPoint first = toJoints({10, 20, 30, 0, 90, 0});
  const PathPoint step = incremental(toJoints({5, 0, 0, 0, 0, 0}));
  expectJoints(endOf(planned({first, step})), {15, 20, 30, 0, 90, 0}, 1e-9);
  expectJoints(endOf(planned({blending(first, 50), step})), {15, 20, 30, 0, 90, 0}, 1e-9);
}

TEST_F(PathTargets, addIncrementsToTheNumbersOneByOne) {
  const PathPoint first = toPose({517.5, -122.3, 461.05, 180, 0, 90}, Interpolation::Ptp, 5);
  const auto after = [&](const arm::ControllerPose& by) {
    return flangeAt(endOf(planned({first, incremental(toPose(by, Interpolation::Ptp))})));
  };
  const arm::ControllerPose turned = after({10, 0, 0, 0, 0, 10});
  EXPECT_NEAR(turned[0], 527.5, 1e-6);
  EXPECT_NEAR(turned[5], 100.0, 1e-6);
  EXPECT_NEAR(after({0, 0, 0, 10, 0, 0})[3], -170.0, 1e-6);
}

TEST_F(PathTargets, areIncrementsOfWhereTheRobotStandsAtFirst) {
  const arm::ControllerPose from = flangeAt(scene.start);
  const arm::ControllerPose reached = flangeAt(endOf(planned({incremental(toPose({0, 50, 0, 0, 0, 0}))})));
  EXPECT_NEAR(reached[1], from[1] + 50, 1e-6);
}

TEST_F(PathTargets, areNoIncrementsInAUserFrameOrOfATool) {
  configure([](tables::Entries& entries) {
    entries.frames[4] = tables::Frame{"", arm::toPose({400, 0, 100, 0, 0, 90}), 0};
  });
  PathPoint point = incremental(toPose({10, 0, 0, 0, 0, 0}));
  point.ref_frame_type = number(Reference::User);
  point.ref_frame_id = 4;
  const PathRefusal refusal = refused({point});
  EXPECT_EQ(refusal.error_id, path_error::kIncrementInFrame);
  EXPECT_THAT(refusal.found, HasSubstr("user frame"));
}

TEST_F(PathTargets, ofHybridsWithoutAConfigurationKeepShoulderAndElbowByPtp) {
  int kept = 0;
  for (int i = 0; i < 200; ++i) {
    scene.start = degrees(i % 40 - 20, i % 37 - 18, 60 + i % 50, i % 90 - 45, 40 + i % 60, 0);
    const arm::ControllerPose from = flangeAt(scene.start);
    const auto bits = arm::poseBitsOf(scene.arm, scene.start);
    PathPlanner planner(scene);
    const PathPoint point = toHybrid({from[0] + 40, from[1] - 60, from[2] + 30},
                                     {10.0 + i % 50, 20.0 + i % 80, 30}, Interpolation::Ptp);
    if (planner.append(sectionOf({point}))) continue;
    const auto reached = arm::poseBitsOf(scene.arm, endOf(planner.plan()));
    EXPECT_EQ(reached.shoulder, bits.shoulder) << i;
    EXPECT_EQ(reached.elbow, bits.elbow) << i;
    ++kept;
  }
  EXPECT_GT(kept, 100);
}

TEST_F(PathTargets, ofWristMovesAreTheSameWithTheConfigurationOfTheirEnd) {
  for (int i = 0; i < 200; ++i) {
    scene.start = degrees(0, i % 41 - 20, 50 + i % 60, i % 70 - 35, 30 + i % 70, 0);
    const arm::ControllerPose from = flangeAt(scene.start);
    PathPoint point =
        toHybrid({from[0] - 30, from[1] + 50, from[2] + 20}, {20.0 + i % 30, 30.0 + i % 60, -20});
    PathPlanner planner(scene);
    if (planner.append(sectionOf({point}))) continue;
    const auto bits = arm::poseBitsOf(scene.arm, endOf(planner.plan())).numbers();
    point.robot_configuration = 1 + 2 * bits[0] + 4 * (3 - bits[1]) + 8 * (bits[2] - 4);
    PathPlanner again(scene);
    const auto refusal = again.append(sectionOf({point}));
    const bool has_other_flip = refusal && refusal->error_id == path_error::kConfiguration;
    if (has_other_flip) continue;
    ASSERT_FALSE(refusal) << i << ": " << refusal->found;
    EXPECT_EQ(endOf(again.plan()), endOf(planner.plan())) << i;
  }
}

TEST_F(PathTargets, areIncrementsOfNumbersInTheSameFramesHoweverTheyAreNamed) {
  PathPoint first = toPose({517.5, -122.3, 461.05, 180, 0, 90}, Interpolation::Ptp, 5);
  first.pose_id = 3;  // of a tool, which the flange has not
  first.ref_frame_id = 7;
  PathPoint step = incremental(toPose({0, 0, 0, 10, 0, 0}, Interpolation::Ptp));
  EXPECT_NEAR(flangeAt(endOf(planned({first, step})))[3], -170.0, 1e-6);
  step.ref_frame_type = number(Reference::User);
  step.ref_frame_id = 0;
  EXPECT_EQ(refused({first, step}).error_id, path_error::kIncrementInFrame);
}

TEST_F(PathTargets, ofAnArcToJointsHaveTheirViaPointInTheReference) {
  configure([](tables::Entries& entries) {
    entries.frames[4] = tables::Frame{"", arm::toPose({400, 0, 0, 0, 0, 0}), 0};
  });
  PathPoint arc = toJoints({15, 0, 90, 0, 90, 0}, Interpolation::Circular);
  arc.ref_frame_type = number(Reference::User);
  arc.ref_frame_id = 4;
  const arm::ControllerPose middle = flangeAt(degrees(8, 0, 90, 0, 90, 0));
  arc.via_pose = {middle[0] + 5 - 400, middle[1], middle[2], 0, 0, 0};
  const PathPlan plan = planned({arc});
  double nearest = 1e3;
  for (Duration time{}; time <= plan.duration(); time += std::chrono::milliseconds(1)) {
    const arm::ControllerPose at = flangeAt(plan.at(time).position);
    nearest = std::min(nearest, std::hypot(at[0] - middle[0] - 5, at[1] - middle[1], at[2] - middle[2]));
  }
  EXPECT_LT(nearest, 0.5);
  arc.ref_frame_id = 99;
  EXPECT_EQ(refused({arc}).error_id, path_error::kFrameIndex);
}

TEST_F(PathTargets, ofAnArcByIncrementsHaveTheirViaPointByIncrementsToo) {
  const PathPoint arc = [] {
    PathPoint made = incremental(toPose({0, 100, 0, 0, 0, 0}, Interpolation::Circular));
    made.via_pose = {-50, 50, 0, 0, 0, 0};
    return made;
  }();
  const arm::ControllerPose from = flangeAt(scene.start);
  const PathPlan plan = planned({arc});
  const arm::ControllerPose middle = flangeAt(plan.at(plan.duration() / 2).position);
  EXPECT_NEAR(middle[0], from[0] - 50, 0.01);
}

TEST_F(PathTargets, ofAnArcPassTheViaPoint) {
  const arm::ControllerPose pose = flangeAt(scene.start);
  PathPoint arc = toPose(pose, Interpolation::Circular);
  arc.pose[1] += 100;
  arc.via_pose = pose;
  arc.via_pose[0] -= 50;
  arc.via_pose[1] += 50;
  const PathPlan plan = planned({arc});
  const arm::ControllerPose middle = flangeAt(plan.at(plan.duration() / 2).position);
  EXPECT_NEAR(middle[0], arc.via_pose[0], 0.01);
  EXPECT_NEAR(middle[1], arc.via_pose[1], 0.2);
}

}  // namespace
}  // namespace cobot_command::path
