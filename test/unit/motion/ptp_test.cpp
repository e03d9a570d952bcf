#include <array>
#include <cmath>

#include "motion_support.h"

#include "cobot_command/arm/inverse_kinematics.h"

namespace cobot_command::motion {
namespace {

Ptp to(const arm::JointVector& target, double speed_ratio = 1.0, int ramp_ms = 200) {
  return {target, speed_ratio, milliseconds(ramp_ms)};
}

TEST(Ptp, takesTheTimeOfTheSlowestJointAtItsShareOfTheRatedSpeed) {
  // J1: 90 deg at half of 180 deg/s takes 1 s; J4: 45 deg at half of 225 deg/s takes 0.4 s.
  const auto motion =
      planned(plan(model(), degrees(0, 0, 90, 0, 90, 0), to(degrees(90, 0, 90, 45, 90, 0), 0.5), Setting{}));
  EXPECT_NEAR(toSeconds(motion->duration()), 1.0 + 0.2, 2e-9);
}

TEST(Ptp, slowsDownWithTheProjectSpeed) {
  Setting setting;
  setting.speed_override = 0.25;
  const auto motion =
      planned(plan(model(), degrees(0, 0, 90, 0, 90, 0), to(degrees(90, 0, 90, 0, 90, 0)), setting));
  EXPECT_NEAR(toSeconds(motion->duration()), 2.0 + 0.2, 2e-9);
}

TEST(Ptp, keepsTheAccelerationWhenItIsTooShortForTheTopSpeed) {
  // 9 deg at 90 deg/s is 0.1 s; 2 sqrt(0.1 * 0.2) s.
  const auto motion = planned(
      plan(model(), degrees(0, 0, 90, 0, 90, 0), to(degrees(0, 0, 90, 0, 90, 11.25), 0.5), Setting{}));
  EXPECT_NEAR(toSeconds(motion->duration()), 2.0 * std::sqrt(0.1 * 0.2), 2e-9);
}

TEST(Ptp, movesAllJointsOnAStraightLineInJointSpace) {
  const arm::JointVector start = degrees(-100, 30, 60, -20, 70, 250);
  const arm::JointVector end = degrees(80, -40, 100, 60, -30, -200);
  const auto motion = planned(plan(model(), start, to(end, 0.7), Setting{}));
  for (int ms = 0; ms <= 2000; ms += 7) {
    const JointState state = motion->at(milliseconds(ms));
    const double share = (state.position[5] - start[5]) / (end[5] - start[5]);
    EXPECT_LT((state.position - start - share * (end - start)).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(Ptp, keepsEveryJointWithinItsShareOfRatedSpeedAndAcceleration) {
  const arm::ArmModel arm = model("tm14");
  constexpr double kRatio = 0.6;
  constexpr double kRamp = 0.15;
  const auto motion = planned(plan(arm, degrees(-100, 30, 60, -20, 70, 100),
                                   to(degrees(80, -40, 100, 60, -90, -170), kRatio, 150), Setting{}));
  JointState previous = motion->at(Duration::zero());
  double fastest = 0.0;
  for (Duration time{}; time <= motion->duration(); time += milliseconds(1)) {
    const JointState state = motion->at(time);
    for (std::size_t i = 0; i < arm::kJointCount; ++i) {
      const auto joint = static_cast<Eigen::Index>(i);
      const double top = kRatio * arm.limits()[i].max_velocity;
      EXPECT_LE(std::abs(state.velocity[joint]), top * (1 + 1e-12));
      EXPECT_LE(std::abs(state.velocity[joint] - previous.velocity[joint]), top / kRamp * 1e-3 * (1 + 1e-9));
      fastest = std::max(fastest, std::abs(state.velocity[joint]) / top);
    }
    previous = state;
  }
  EXPECT_NEAR(fastest, 1.0, 1e-12) << "the ruling joint uses its whole share";
}

TEST(Ptp, startsAndEndsExactlyAtRestAndStaysThere) {
  const arm::JointVector start = degrees(-12.3, 30, 60, -20, 70, 100);
  const arm::JointVector end = degrees(80.7, -40, 100, 60, -90, -170);
  const auto motion = planned(plan(model(), start, to(end), Setting{}));
  for (const Duration time : {-milliseconds(5), Duration::zero()}) {
    EXPECT_EQ(motion->at(time).position, start);
    EXPECT_EQ(motion->at(time).velocity, arm::JointVector::Zero());
  }
  for (const Duration time : {motion->duration(), motion->duration() + milliseconds(5)}) {
    EXPECT_EQ(motion->at(time).position, end);
    EXPECT_EQ(motion->at(time).velocity, arm::JointVector::Zero());
  }
  EXPECT_EQ(motion->end().position, end);
}

TEST(Ptp, takesNoTimeToWhereItAlreadyIs) {
  const auto motion = planned(plan(model(), workingPosture(), to(workingPosture()), Setting{}));
  EXPECT_EQ(motion->duration(), Duration::zero());
  EXPECT_EQ(motion->at(Duration::zero()).position, workingPosture());
}

TEST(Ptp, reachesAPoseThroughBaseAndTcpWithTheBitsOfTheStart) {
  const arm::ArmModel arm = model("tm12");
  const Setting setting = displacedSetting();
  const arm::JointVector start = degrees(150, -20, -100, 10, -80, 30);
  const arm::Pose target = moved(tcpAt(arm, start, setting), 0.1, -0.05, 0.08, 0.3, {1, 0, 1});
  const auto motion = planned(plan(arm, start, Ptp{PoseTarget{target, {}}, 0.5, milliseconds(200)}, setting));
  const arm::JointVector end = motion->end().position;
  EXPECT_LT(distance(tcpAt(arm, end, setting), target), 1e-9);
  EXPECT_LT(turnError(tcpAt(arm, end, setting), target), 1e-9);
  EXPECT_EQ(arm::poseBitsOf(arm, end), arm::poseBitsOf(arm, start));
}

TEST(Ptp, reachesAPoseWithTheBitsThatAreAskedFor) {
  const arm::ArmModel arm = model();
  const arm::PoseBits wanted{arm::Shoulder::Righty, arm::Elbow::Above, arm::Wrist::Flip};
  const arm::Pose target = arm::forwardKinematics(arm, workingPosture());
  const auto motion = planned(
      plan(arm, workingPosture(), Ptp{PoseTarget{target, wanted}, 0.5, milliseconds(200)}, Setting{}));
  EXPECT_EQ(arm::poseBitsOf(arm, motion->end().position), wanted);
  EXPECT_LT(distance(arm::forwardKinematics(arm, motion->end().position), target), 1e-9);
}

TEST(Ptp, turnsTheShortWayAcrossHalfATurnWhereTheLimitsAllow) {
  const arm::ArmModel arm = model();
  const arm::JointVector start = degrees(170, 15, 80, -5, 85, 175);
  const arm::JointVector beyond = degrees(190, 15, 80, -5, 85, 185);  // the same pose as -170, .., -175
  const arm::Pose target = arm::forwardKinematics(arm, beyond);
  const auto motion =
      planned(plan(arm, start, Ptp{PoseTarget{target, {}}, 0.5, milliseconds(200)}, Setting{}));
  EXPECT_LT((motion->end().position - beyond).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(Ptp, bringsAJointBackThatStandsOutsideItsLimits) {
  const auto motion =
      planned(plan(model(), degrees(0, 0, 156, 0, 90, 0), to(degrees(0, 0, 150, 0, 90, 0)), Setting{}));
  EXPECT_EQ(motion->end().position, degrees(0, 0, 150, 0, 90, 0));
}

}  // namespace
}  // namespace cobot_command::motion
