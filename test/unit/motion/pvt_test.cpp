#include "cobot_command/motion/pvt.h"

#include <cmath>
#include <vector>

#include "motion_support.h"

namespace cobot_command::motion {
namespace {

arm::JointVector offset(double j1) {
  return workingPosture() + degrees(j1, 0, 0, 0, 0, 0);
}

Result<TrajectoryPtr, Refusal> planJoints(std::vector<PvtJointPoint> points, const Setting& setting = {}) {
  return plan(model(), workingPosture(), Pvt{std::move(points)}, setting);
}

TEST(PvtOfJoints, isACubicFromRestToRest) {
  // x(s) = 3 s^2 - 2 s^3: in the middle half of the way at 1.5 times the mean speed.
  const auto motion = planned(planJoints({{offset(20), degrees(0, 0, 0, 0, 0, 0), 2.0}}));
  EXPECT_EQ(motion->duration(), milliseconds(2000));
  for (const double s : {0.0, 0.1, 0.25, 0.5, 0.9}) {
    const JointState state = motion->at(fromSeconds(2.0 * s));
    EXPECT_NEAR(state.position[0], offset(20.0 * s * s * (3.0 - 2.0 * s))[0], 1e-12);
    EXPECT_NEAR(state.velocity[0], degToRad(10.0 * 6.0 * s * (1.0 - s)), 1e-12);
  }
  EXPECT_EQ(motion->end().position, offset(20));
  EXPECT_EQ(motion->end().velocity, arm::JointVector::Zero());
}

TEST(PvtOfJoints, hasPositionAndVelocityOfEachPointAtItsTime) {
  const std::vector<PvtJointPoint> points{{offset(5), degrees(10, 0, 1, 0, 0, 0), 0.5},
                                          {offset(10), degrees(-3, 0, 0, 2, 0, 0), 1.0},
                                          {offset(8), degrees(0, 0, 0, 0, 0, 0), 0.7}};
  const auto motion = planned(planJoints(points));
  EXPECT_NEAR(toSeconds(motion->duration()), 2.2, 2e-9);
  double time = 0.0;
  for (const PvtJointPoint& point : points) {
    time += point.duration;
    for (const Duration around : {Duration(-2), Duration(2)}) {
      const JointState state = motion->at(fromSeconds(time) + around);
      EXPECT_TRUE(state.position.isApprox(point.position, 1e-7)) << time;
      EXPECT_LT((state.velocity - point.velocity).norm(), 1e-7) << time;
    }
  }
}

TEST(PvtOfJoints, takesLongerAtALowerProjectSpeed) {
  Setting slow;
  slow.speed_override = 0.25;
  const auto motion = planned(planJoints(
      {{offset(5), degrees(10, 0, 0, 0, 0, 0), 0.5}, {offset(10), {0, 0, 0, 0, 0, 0}, 0.5}}, slow));
  EXPECT_EQ(motion->duration(), milliseconds(4000));
  EXPECT_NEAR(motion->at(milliseconds(2000)).velocity[0], degToRad(2.5), 1e-9);
}

TEST(PvtOfJoints, isRefusedWhereAJointIsFasterThanRatedBetweenThePoints) {
  // J1 of a TM5-900: 180 deg/s. 1.5 * 130 / 1 between the ends, which are at rest.
  const auto result =
      planJoints({{offset(-30), {0, 0, 0, 0, 0, 0}, 1.0}, {offset(100), {0, 0, 0, 0, 0, 0}, 1.0}});
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().reason, Refusal::Reason::JointSpeed);
  EXPECT_EQ(result.error().joint, 0);
  EXPECT_NEAR(result.error().at, 0.75, 1e-9);
  EXPECT_NE(result.error().message.find("195.0 deg/s, rated 180.0"), std::string::npos)
      << result.error().message;
}

TEST(PvtOfJoints, isRefusedWhereAJointLeavesItsRangeBetweenThePoints) {
  // J3 from 80 to 150 at 120 deg/s and back: it turns round beyond its 155 deg.
  const arm::JointVector out = workingPosture() + degrees(0, 0, 70, 0, 0, 0);
  const auto result =
      planJoints({{out, degrees(0, 0, 120, 0, 0, 0), 1.0}, {workingPosture(), {0, 0, 0, 0, 0, 0}, 2.0}});
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().reason, Refusal::Reason::JointLimit);
  EXPECT_EQ(result.error().joint, 2);
  EXPECT_GT(result.error().at, 1.0 / 3.0);
}

TEST(PvtOfJoints, bringsAJointBackThatIsOutsideItsLimits) {
  // J3 of a TM5-900: 155 deg.
  const arm::JointVector start = degrees(0, 0, 158, 0, 90, 0);
  const auto to = [](double j3, double speed) {
    return PvtJointPoint{degrees(0, 0, j3, 0, 90, 0), degrees(0, 0, speed, 0, 0, 0), 0.5};
  };
  const auto back = plan(model(), start, Pvt{std::vector{to(157, -4), to(150, 0)}}, {});
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_NEAR(radToDeg((*back)->end().position[2]), 150.0, 1e-9);
  // It may stop half-way, as a PTP may, but go no further out, nor out again.
  EXPECT_TRUE(plan(model(), start, Pvt{std::vector{to(157, 0)}}, {}));
  EXPECT_FALSE(plan(model(), start, Pvt{std::vector{to(159, 0), to(150, 0)}}, {}));
  EXPECT_FALSE(plan(model(), start, Pvt{std::vector{to(157, 0), to(157.5, 0)}}, {}));
  const auto out = plan(model(), start, Pvt{std::vector{to(150, 0), to(156, 0)}}, {});
  ASSERT_FALSE(out);
  EXPECT_EQ(out.error().reason, Refusal::Reason::JointLimit);
}

TEST(PvtOfJoints, areCheckedSegmentBySegmentAsTheWhole) {
  const JointState from{workingPosture(), arm::JointVector::Zero()};
  const PvtJointPoint fast{offset(130), degrees(0, 0, 0, 0, 0, 0), 1.0};
  const auto offence = checkPvtSegment(model(), from, fast);
  ASSERT_TRUE(offence);
  EXPECT_EQ(offence->reason, Refusal::Reason::JointSpeed);
  EXPECT_EQ(offence->joint, 0);
  EXPECT_NEAR(offence->time, 0.5, 1e-9);
  EXPECT_NEAR(radToDeg(offence->found), 195.0, 1e-9);
  EXPECT_FALSE(checkPvtSegment(model(), from, fast, {1e-6, 0.1}));
}

TEST(PvtOfJoints, isRefusedWithoutPointsOrTimeOrRestAtItsEnd) {
  const arm::JointVector rest = arm::JointVector::Zero();
  const std::vector<std::vector<PvtJointPoint>> cases{
      {}, {{offset(5), rest, 0.0}}, {{offset(5), rest, -1.0}}, {{offset(5), degrees(1, 0, 0, 0, 0, 0), 1.0}}};
  for (const auto& points : cases) {
    const auto result = planJoints(points);
    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().reason, Refusal::Reason::BadParameter) << result.error().message;
  }
  for (const PvtJointPoint& point : {PvtJointPoint{degrees(NAN, 0, 0, 0, 0, 0), rest, 1.0},
                                     PvtJointPoint{offset(5), degrees(0, INFINITY, 0, 0, 0, 0), 1.0},
                                     PvtJointPoint{offset(5), rest, NAN}}) {
    const auto result = planJoints({point});
    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().reason, Refusal::Reason::NotFinite) << result.error().message;
  }
}

class PvtOfPoses : public ::testing::Test {
 protected:
  [[nodiscard]] Result<TrajectoryPtr, Refusal> planPoses(std::vector<PvtPosePoint> points) const {
    return plan(arm, workingPosture(), Pvt{std::move(points)}, setting);
  }
  /// Seen in the base, by differences.
  [[nodiscard]] TcpVelocity velocityAt(const Trajectory& motion, Duration time) const {
    const Duration step = std::chrono::microseconds(20);
    const arm::Pose before = tcpAt(arm, motion.at(time - step).position, setting);
    const arm::Pose behind = tcpAt(arm, motion.at(time + step).position, setting);
    const Eigen::AngleAxisd turn(behind.linear() * before.linear().transpose());
    const double elapsed = toSeconds(2 * step);
    return {(behind.translation() - before.translation()) / elapsed, turn.angle() / elapsed * turn.axis()};
  }

  arm::ArmModel arm = model();
  Setting setting = displacedSetting();
  arm::Pose start = tcpAt(arm, workingPosture(), setting);
};

TEST_F(PvtOfPoses, areOnTheCubicOfPositionAndTurn) {
  const arm::Pose target = moved(start, 0.05, -0.03, 0.02, 0.4, {1, -1, 2});
  const auto motion = planned(planPoses({{target, {}, 2.0}}));
  ASSERT_TRUE(motion);
  EXPECT_EQ(motion->duration(), milliseconds(2000));
  for (const double s : {0.1, 0.25, 0.5, 0.9, 1.0}) {
    const double share = s * s * (3.0 - 2.0 * s);
    const arm::Pose expected =
        moved(start, 0.05 * share, -0.03 * share, 0.02 * share, 0.4 * share, {1, -1, 2});
    EXPECT_TRUE(tcpAt(arm, motion->at(fromSeconds(2.0 * s)).position, setting).isApprox(expected, 1e-8)) << s;
  }
}

TEST_F(PvtOfPoses, haveTheVelocityOfEachPointAtItsTime) {
  const TcpVelocity first{{0.04, 0.02, -0.01}, {0.1, -0.2, 0.3}};
  const TcpVelocity second{{-0.02, 0.03, 0.0}, {-0.2, 0.0, 0.1}};
  const arm::Pose a = moved(start, 0.03, 0.01, 0.0, 0.3, {1, 1, -1});
  const arm::Pose b = moved(a, 0.01, 0.02, -0.02, -0.2, {0, 2, 1});
  const auto motion = planned(planPoses({{a, first, 1.0}, {b, second, 1.5}, {start, {}, 2.0}}));
  ASSERT_TRUE(motion);
  for (const auto& [time, point, velocity] : {std::tuple(1000, a, first), std::tuple(2500, b, second)}) {
    EXPECT_TRUE(tcpAt(arm, motion->at(milliseconds(time)).position, setting).isApprox(point, 1e-8));
    const TcpVelocity seen = velocityAt(*motion, milliseconds(time));
    EXPECT_LT((seen.linear - velocity.linear).norm(), 1e-4) << seen.linear.transpose();
    EXPECT_LT((seen.angular - velocity.angular).norm(), 1e-3) << seen.angular.transpose();
  }
  EXPECT_TRUE(tcpAt(arm, motion->end().position, setting).isApprox(start, 1e-9));
}

TEST_F(PvtOfPoses, haveJointVelocitiesThatAreTheSlopesOfTheJoints) {
  const auto motion =
      planned(planPoses({{moved(start, 0.03, 0.01, 0.0, 0.4, {1, 1, -1}), {{0.02, 0, 0}, {0, 0.3, 0}}, 1.0},
                         {start, {}, 1.5}}));
  ASSERT_TRUE(motion);
  const Duration step = std::chrono::microseconds(50);
  for (Duration time = milliseconds(20); time < motion->duration(); time += milliseconds(55)) {
    const arm::JointVector slope =
        (motion->at(time + step).position - motion->at(time - step).position) / toSeconds(2 * step);
    EXPECT_LT((slope - motion->at(time).velocity).cwiseAbs().maxCoeff(), 1e-4) << toSeconds(time);
  }
}

TEST_F(PvtOfPoses, areRefusedAsAnyPath) {
  const auto far = planPoses({{moved(start, 2, 0, 0), {}, 10.0}});
  ASSERT_FALSE(far.has_value());
  EXPECT_EQ(far.error().reason, Refusal::Reason::PoseBits);
  const auto fast = planPoses({{moved(start, 0.1, 0, 0), {}, 0.02}});
  ASSERT_FALSE(fast.has_value());
  EXPECT_EQ(fast.error().reason, Refusal::Reason::JointSpeed);
  EXPECT_NE(fast.error().message.find("times the time is sufficient"), std::string::npos)
      << fast.error().message;
  const auto moving = planPoses({{start, {{0.002, 0, 0}, {0, 0, 0}}, 1.0}});
  ASSERT_FALSE(moving.has_value());
  EXPECT_EQ(moving.error().reason, Refusal::Reason::BadParameter);
}

TEST(PvtOfPosesAtASingularity, areRefused) {
  const arm::JointVector straight = degrees(0, 0, 90, 0, 0.1, 0);
  const arm::Pose beyond = moved(tcpAt(model(), straight, {}), 0, 0, 0.05);
  const auto result = plan(model(), straight, Pvt{std::vector<PvtPosePoint>{{beyond, {}, 20.0}}}, Setting{});
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().reason, Refusal::Reason::Singular) << result.error().message;
}

}  // namespace
}  // namespace cobot_command::motion
