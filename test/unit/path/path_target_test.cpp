// Where the targets of points are: frames, configurations, increments, hybrids.
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
