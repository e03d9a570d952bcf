// How much of a way a blend leaves out.
#include "path_support.h"

namespace cobot_command::path {
namespace {

class PathCorners : public Paths {
 protected:
  [[nodiscard]] double leftOut(const PathPlan& plan) const {
    const PlannedPoint& first = plan.points()[0];
    const arm::JointVector leaves = first.motion->at(first.motion->duration() - first.overlap).position;
    return (place(leaves) - place(first.motion->end().position)).norm();
  }
  [[nodiscard]] Eigen::Vector3d place(const arm::JointVector& joints) const {
    return arm::forwardKinematics(scene.arm, joints).translation();
  }
  /// The pose of the start, moved [mm].
  [[nodiscard]] arm::ControllerPose from(double x, double y, double z) const {
    arm::ControllerPose pose = flangeAt(scene.start);
    pose[0] += x;
    pose[1] += y;
    pose[2] += z;
    return pose;
  }
};

TEST_F(PathCorners, ofTwoLinesLeaveOutNoMoreThanTheTolerance) {
  const PathPlan plan = planned({blending(toPose(from(0, 100, 0)), 5), toPose(from(0, 100, 100))});
  EXPECT_NEAR(toSeconds(plan.points()[0].overlap), 0.1414, 1e-3);
  EXPECT_NEAR(toSeconds(plan.duration()), 2.2586, 2 * kGrid);
  EXPECT_LE(mToMm(leftOut(plan)), 5.0);
  EXPECT_GT(mToMm(leftOut(plan)), 4.9);
}

TEST_F(PathCorners, ofALineIntoAPtpLeaveOutNoMoreThanTheTolerance) {
  PathPoint ptp = toJoints({40, 0, 90, 0, 90, 0});
  ptp.speed = 20;
  ptp.acceleration = ptp.deceleration = 40;
  const PathPlan plan = planned({blending(toPose(from(0, 100, 0)), 8), ptp});
  const Eigen::Vector3d corner = place(plan.points()[0].motion->end().position);
  const Eigen::Vector3d joins = place(plan.points()[1].motion->at(plan.points()[0].overlap).position);
  EXPECT_GT(plan.points()[0].overlap, Duration::zero());
  EXPECT_LE(mToMm(leftOut(plan)), 8.0);
  EXPECT_LE(mToMm((joins - corner).norm()), 8.0);
}

TEST_F(PathCorners, ofAPtpLeaveOutNoMoreThanTheirShareOfTheWay) {
  const auto ptp = [](std::array<double, 6> joints) {
    PathPoint point = toJoints(joints);
    point.speed = 60;
    point.acceleration = point.deceleration = 120;
    return point;
  };
  const auto total = [&](double tolerance) {
    return planned({blending(ptp({60, 0, 90, 0, 90, 0}), tolerance), ptp({60, 0, 90, 0, 90, 60})});
  };
  EXPECT_NEAR(toSeconds(total(10).points()[0].overlap), 0.3162, 1e-3);
  EXPECT_NEAR(toSeconds(total(10).duration()), 2.6838, 2 * kGrid);
  EXPECT_NEAR(toSeconds(total(25).duration()), 2.5, 2 * kGrid);
  EXPECT_NEAR(toSeconds(total(100).duration()), 2.5, 2 * kGrid);
  const PathPlan stops = total(0);
  EXPECT_NEAR(toSeconds(stops.duration()), 3.0, 2 * kGrid);
  EXPECT_EQ(stops.at(stops.points()[0].end()).position[0], degToRad(60));
}

TEST_F(PathCorners, ofATurnOnTheSpotKeepTheToolWithinTheTolerance) {
  tables::Entries entries;
  entries.tools[1] = tables::Tool{"", arm::toPose({0, 0, 300, 0, 0, 0}), 0};
  scene.tables = *tables::DataTables::of(entries, {});
  const Eigen::Vector3d tool(0, 0, 0.3);
  arm::ControllerPose pose = flangeAt(scene.start);
  pose[2] -= 300;
  const auto turned = [&](double rx, double ry) {
    PathPoint point = toPose(pose);
    point.pose[3] += rx;
    point.pose[4] += ry;
    point.pose_type = number(MovedFrame::Tool);
    point.pose_id = 1;
    return point;
  };
  for (const double tolerance : {0.01, 0.2, 5.0}) {
    const PathPlan plan = planned({blending(turned(20, 0), tolerance), turned(20, 20)});
    for (Duration time{}; time <= plan.duration(); time += std::chrono::milliseconds(1)) {
      const arm::Pose flange = arm::forwardKinematics(scene.arm, plan.at(time).position);
      const double off =
          (flange * tool - Eigen::Vector3d(0.001 * pose[0], 0.001 * pose[1], 0.001 * pose[2])).norm();
      ASSERT_LE(mToMm(off), tolerance + 1e-6) << toSeconds(time);
    }
  }
}

TEST_F(PathCorners, ofPointsThatStopAreNone) {
  PathPoint point = toPose(from(0, 100, 0));
  point.command_tolerance = 50;
  const PathPlan plan = planned({point, toPose(from(0, 100, 100))});
  EXPECT_EQ(plan.points()[0].overlap, Duration::zero());
  EXPECT_FALSE(plan.points()[0].losesBlend());
}

}  // namespace
}  // namespace cobot_command::path
