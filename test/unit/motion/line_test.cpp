#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "motion_support.h"
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/path_line.hpp>
#include <kdl/rotational_interpolation_sa.hpp>

#include "cobot_command/arm/pose_bits.h"

namespace cobot_command::motion {
namespace {

KDL::Frame toKdl(const arm::Pose& pose) {
  const Eigen::Matrix3d r = pose.linear();
  return {KDL::Rotation(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)),
          KDL::Vector(pose(0, 3), pose(1, 3), pose(2, 3))};
}

class LineInDisplacedFrames : public ::testing::Test {
 protected:
  LineInDisplacedFrames()
      : from_(tcpAt(arm_, start_, setting_)),
        to_(moved(from_, 0.05, 0.2, -0.1, 0.5, {0.3, 1, -0.2})),
        motion_(planned(plan(arm_, start_, Line{to_, SpeedRatio{0.25}, milliseconds(200)}, setting_))) {}

  arm::ArmModel arm_ = model();
  Setting setting_ = displacedSetting();
  arm::JointVector start_ = workingPosture();
  arm::Pose from_;
  arm::Pose to_;
  TrajectoryPtr motion_;
};

TEST_F(LineInDisplacedFrames, keepsTheTcpOnTheLineAndItsOrientationOnTheGeodesic) {
  const Eigen::AngleAxisd turn(to_.linear() * from_.linear().transpose());
  const Eigen::Vector3d way = to_.translation() - from_.translation();
  for (Duration time{}; time <= motion_->duration(); time += milliseconds(1)) {
    const arm::Pose tcp = tcpAt(arm_, motion_->at(time).position, setting_);
    const Eigen::Vector3d gone = tcp.translation() - from_.translation();
    const double share = gone.dot(way) / way.squaredNorm();
    ASSERT_LT((gone - share * way).norm(), 1e-9) << toSeconds(time);
    const Eigen::Matrix3d turned =
        Eigen::AngleAxisd(share * turn.angle(), turn.axis()).toRotationMatrix() * from_.linear();
    ASSERT_LT((tcp.linear() - turned).cwiseAbs().maxCoeff(), 1e-9) << toSeconds(time);
  }
}

TEST_F(LineInDisplacedFrames, agreesWithKdlsLineAndForwardKinematics) {
  const KDL::Path_Line line(toKdl(setting_.base * from_), toKdl(setting_.base * to_),
                            new KDL::RotationalInterpolation_SingleAxis(), 1e-9, true);
  KDL::ChainFkSolverPos_recursive forward(arm_.chain());
  const double duration = toSeconds(motion_->duration());
  const double ramp = 0.2;
  for (Duration time = milliseconds(200); toSeconds(time) < duration - ramp; time += milliseconds(3)) {
    KDL::JntArray joints(6);
    joints.data = motion_->at(time).position;
    KDL::Frame flange;
    ASSERT_GE(forward.JntToCart(joints, flange), 0);
    const double share = (toSeconds(time) - ramp / 2) / (duration - ramp);
    const KDL::Frame expected =
        const_cast<KDL::Path_Line&>(line).Pos(share * const_cast<KDL::Path_Line&>(line).PathLength());
    EXPECT_TRUE(KDL::Equal(flange * toKdl(setting_.tcp), expected, 1e-8)) << toSeconds(time);
  }
}

TEST_F(LineInDisplacedFrames, startsExactlyAtTheStartAndEndsAtTheTarget) {
  EXPECT_EQ(motion_->at(Duration::zero()).position, start_);
  EXPECT_LT((motion_->at(Duration(1)).position - start_).cwiseAbs().maxCoeff(), 1e-9);
  const JointState end = motion_->end();
  EXPECT_LT(distance(tcpAt(arm_, end.position, setting_), to_), 1e-9);
  EXPECT_LT(turnError(tcpAt(arm_, end.position, setting_), to_), 1e-9);
  EXPECT_EQ(end.velocity, arm::JointVector::Zero());
  EXPECT_EQ(arm::poseBitsOf(arm_, end.position), arm::poseBitsOf(arm_, start_));
}

TEST_F(LineInDisplacedFrames, reportsTheSlopeOfThePositionAsTheVelocity) {
  const Duration step = std::chrono::microseconds(10);
  for (Duration time = milliseconds(5); time < motion_->duration() - milliseconds(5);
       time += milliseconds(11)) {
    const arm::JointVector slope =
        (motion_->at(time + step).position - motion_->at(time - step).position) / (2.0 * toSeconds(step));
    EXPECT_LT((motion_->at(time).velocity - slope).cwiseAbs().maxCoeff(), 1e-4) << toSeconds(time);
  }
}

TEST_F(LineInDisplacedFrames, answersTheSameTimeBitIdenticallyInAnyOrder) {
  std::vector<Duration> times;
  for (Duration time{}; time <= motion_->duration(); time += std::chrono::microseconds(777)) {
    times.push_back(time);
  }
  std::vector<JointState> in_order;
  for (const Duration time : times) {
    in_order.push_back(motion_->at(time));
  }
  std::vector<std::size_t> shuffled(times.size());
  for (std::size_t i = 0; i < shuffled.size(); ++i) {
    shuffled[i] = i;
  }
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(7));
  const auto again = planned(plan(arm_, start_, Line{to_, SpeedRatio{0.25}, milliseconds(200)}, setting_));
  for (const std::size_t i : shuffled) {
    EXPECT_EQ(again->at(times[i]).position, in_order[i].position);
    EXPECT_EQ(again->at(times[i]).velocity, in_order[i].velocity);
  }
}

double lineSeconds(const PathSpeed& speed, double distance, double turn, const Setting& setting = {}) {
  const arm::ArmModel arm = model();
  const arm::Pose to = moved(tcpAt(arm, workingPosture(), setting), 0, distance, 0, turn);
  return toSeconds(
      planned(plan(arm, workingPosture(), Line{to, speed, milliseconds(100)}, setting))->duration());
}

TEST(Line, takesItsLengthAtTheSpeedPlusOneRamp) {
  EXPECT_NEAR(lineSeconds(TcpSpeed{0.1}, 0.2, 0.0), 2.1, 1e-6);
}

TEST(Line, takesPercentOfTheTypicalTcpSpeedOfTheModel) {
  EXPECT_NEAR(lineSeconds(SpeedRatio{0.1}, 0.14, 0.0), 0.14 / (0.1 * 1.4) + 0.1, 1e-6);
}

TEST(Line, slowsDownWithTheProjectSpeed) {
  Setting setting;
  setting.speed_override = 0.5;
  EXPECT_NEAR(lineSeconds(TcpSpeed{0.1}, 0.2, 0.0, setting), 4.1, 1e-6);
  EXPECT_NEAR(lineSeconds(SpeedRatio{0.1}, 0.0, 0.2, setting), 0.2 / (0.05 * kPi) + 0.1, 1e-6);
}

TEST(Line, inPercentTurnsAtThatShareOfHalfATurnPerSecondWhenTheTurnTakesLonger) {
  EXPECT_NEAR(lineSeconds(SpeedRatio{0.1}, 0.0, 0.2), 0.2 / (0.1 * kPi) + 0.1, 1e-6);
  EXPECT_NEAR(lineSeconds(SpeedRatio{0.1}, 0.14, 0.2), 0.14 / 0.14 + 0.1, 1e-6) << "the way takes longer";
}

TEST(Line, hasTheSpeedItIsGivenUnlessTheTurnTakesLongerAtHalfATurnPerSecond) {
  EXPECT_NEAR(lineSeconds(TcpSpeed{0.05}, 0.1, 0.6), 0.1 / 0.05 + 0.1, 1e-6);
  EXPECT_NEAR(lineSeconds(TcpSpeed{0.05}, 0.001, 0.6), 0.6 / kPi + 0.1, 1e-6);
  Setting setting;
  setting.speed_override = 0.2;
  EXPECT_NEAR(lineSeconds(TcpSpeed{3.0}, 0.0, 0.2, setting), 0.2 / (0.2 * kPi) + 0.1, 1e-6);
}

TEST(Line, turnsAsFastAsTheArmIsSetTo) {
  const arm::ArmModel arm = model().turning(0.5);
  const arm::Pose to = moved(arm::forwardKinematics(arm, workingPosture()), 0, 0.001, 0, 0.6);
  const auto seconds = [&](const PathSpeed& speed) {
    return toSeconds(
        planned(plan(arm, workingPosture(), Line{to, speed, milliseconds(100)}, Setting{}))->duration());
  };
  EXPECT_NEAR(seconds(TcpSpeed{0.2}), 0.6 / 0.5 + 0.1, 1e-6);
  EXPECT_NEAR(seconds(SpeedRatio{0.4}), 0.6 / (0.4 * 0.5) + 0.1, 1e-6);
}

TEST(Line, keepsItsSpeedWhereItTurnsOnTheWay) {
  // It was found: 229 mm with 75 degrees at 200 mm/s took 3.14 s.
  const arm::ArmModel arm = model();
  const arm::JointVector start = degrees(-15, 0, 90, 0, 90, 0);
  const arm::Pose from = arm::forwardKinematics(arm, start);
  const arm::Pose to = moved(from, 0, 0.229, 0, degToRad(75.0));
  const auto motion = planned(plan(arm, start, Line{to, TcpSpeed{0.2}, milliseconds(200)}, Setting{}));
  EXPECT_NEAR(toSeconds(motion->duration()), 0.229 / 0.2 + 0.2, 1e-6);
}

TEST(Line, takesNoTimeToWhereItAlreadyIsEvenOnASingularity) {
  const arm::ArmModel arm = model();
  const arm::JointVector upright = arm::JointVector::Zero();
  const Line line{arm::forwardKinematics(arm, upright), SpeedRatio{0.1}, milliseconds(100)};
  const auto motion = planned(plan(arm, upright, line, Setting{}));
  EXPECT_EQ(motion->duration(), Duration::zero());
  EXPECT_EQ(motion->at(Duration::zero()).position, upright);
  EXPECT_EQ(motion->end().position, upright);
}

TEST(Line, carriesAJointOnThroughHalfATurn) {
  const arm::ArmModel arm = model();
  const arm::JointVector start = degrees(10, 15, 80, -5, 85, 170);
  const Eigen::Vector3d flange_axis = arm::forwardKinematics(arm, start).linear().col(2);
  const arm::Pose to = moved(arm::forwardKinematics(arm, start), 0, 0, 0, degToRad(30.0), flange_axis);
  const auto motion = planned(plan(arm, start, Line{to, SpeedRatio{0.05}, milliseconds(100)}, Setting{}));
  EXPECT_NEAR(motion->end().position[5], degToRad(200.0), 1e-9);
  arm::JointVector previous = start;
  for (Duration time{}; time <= motion->duration(); time += milliseconds(1)) {
    const arm::JointVector joints = motion->at(time).position;
    ASSERT_LT((joints - previous).cwiseAbs().maxCoeff(), 0.01);
    previous = joints;
  }
}

}  // namespace
}  // namespace cobot_command::motion
