#include <limits>

#include "motion_support.h"

namespace cobot_command::motion {
namespace {

using Reason = Refusal::Reason;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

Reason reasonFor(const Command& command, const Setting& setting = {},
                 const arm::JointVector& start = workingPosture()) {
  auto result = plan(model(), start, command, setting);
  if (result) {
    ADD_FAILURE() << "planned";
    return Reason::Unreachable;
  }
  EXPECT_FALSE(result.error().message.empty());
  return result.error().reason;
}

arm::Pose nearby() {
  return moved(arm::forwardKinematics(model(), workingPosture()), 0.0, 0.05, 0.0);
}

Ptp ptp(double ratio = 0.5, Duration ramp = milliseconds(200)) {
  return {degrees(0, 0, 90, 0, 90, 0), ratio, ramp};
}
Line line(PathSpeed speed = SpeedRatio{0.1}, Duration ramp = milliseconds(200)) {
  return {nearby(), speed, ramp};
}
Circle circle(std::optional<double> angle = std::nullopt) {
  return {moved(nearby(), 0.05, 0, 0), nearby(), angle, SpeedRatio{0.1}, milliseconds(200)};
}

TEST(Input, acceptsTheRequestsThatTheOtherTestsSpoil) {
  for (const Command& command : {Command(ptp()), Command(line()), Command(circle()), Command(circle(1.0))}) {
    planned(plan(model(), workingPosture(), command, Setting{}));
  }
}

TEST(Input, refusesWhateverIsNotFinite) {
  for (const double bad : {kNan, kInf, -kInf}) {
    arm::Pose pose = nearby();
    pose(1, 3) = bad;
    arm::JointVector joints = workingPosture();
    joints[3] = bad;
    Line bad_line = line();
    bad_line.target = pose;
    Circle bad_via = circle();
    bad_via.via = pose;
    Circle bad_end = circle();
    bad_end.end = pose;
    EXPECT_EQ(reasonFor(Ptp{joints, 0.5, milliseconds(200)}), Reason::NotFinite);
    EXPECT_EQ(reasonFor(Ptp{PoseTarget{pose, {}}, 0.5, milliseconds(200)}), Reason::NotFinite);
    EXPECT_EQ(reasonFor(ptp(bad)), Reason::NotFinite);
    EXPECT_EQ(reasonFor(bad_line), Reason::NotFinite);
    EXPECT_EQ(reasonFor(line(SpeedRatio{bad})), Reason::NotFinite);
    EXPECT_EQ(reasonFor(line(TcpSpeed{bad})), Reason::NotFinite);
    EXPECT_EQ(reasonFor(bad_via), Reason::NotFinite);
    EXPECT_EQ(reasonFor(bad_end), Reason::NotFinite);
    EXPECT_EQ(reasonFor(circle(bad)), Reason::NotFinite);
    EXPECT_EQ(reasonFor(line(), {}, joints), Reason::NotFinite);
    EXPECT_EQ(reasonFor(line(), {pose, arm::Pose::Identity(), 1.0}), Reason::NotFinite);
    EXPECT_EQ(reasonFor(line(), {arm::Pose::Identity(), pose, 1.0}), Reason::NotFinite);
    EXPECT_EQ(reasonFor(line(), {arm::Pose::Identity(), arm::Pose::Identity(), bad}), Reason::NotFinite);
  }
}

TEST(Input, refusesASpeedOutsideItsRange) {
  for (const double bad : {0.0, -0.5, 1.0001, 1e308}) {
    EXPECT_EQ(reasonFor(ptp(bad)), Reason::BadParameter) << bad;
    EXPECT_EQ(reasonFor(line(SpeedRatio{bad})), Reason::BadParameter) << bad;
    EXPECT_EQ(reasonFor(line(), {arm::Pose::Identity(), arm::Pose::Identity(), bad}), Reason::BadParameter);
  }
  for (const double bad : {0.0, -0.1, 4.51, 1e308}) {
    EXPECT_EQ(reasonFor(line(TcpSpeed{bad})), Reason::BadParameter) << bad;
  }
}

TEST(Input, refusesATimeToTopSpeedThatIsNegative) {
  for (const Duration bad : {-Duration(1), -milliseconds(1), Duration::min()}) {
    EXPECT_EQ(reasonFor(ptp(0.5, bad)), Reason::BadParameter);
    EXPECT_EQ(reasonFor(line(SpeedRatio{0.1}, bad)), Reason::BadParameter);
  }
}

TEST(Input, refusesAnArcAngleOfZeroOrMoreThanATurn) {
  for (const double bad : {0.0, 2.0 * kPi + 1e-6, -2.0 * kPi - 1e-6, 1e300}) {
    EXPECT_EQ(reasonFor(circle(bad)), Reason::BadParameter) << bad;
  }
}

TEST(Input, refusesAnOrientationThatIsNotARotation) {
  arm::Pose scaled = nearby();
  scaled.linear() *= 1.001;
  arm::Pose mirrored = nearby();
  mirrored.linear().col(0) *= -1.0;
  arm::Pose zero = nearby();
  zero.linear().setZero();
  for (const arm::Pose& bad : {scaled, mirrored, zero}) {
    EXPECT_EQ(reasonFor(Line{bad, SpeedRatio{0.1}, milliseconds(200)}), Reason::BadParameter);
    EXPECT_EQ(reasonFor(line(), {arm::Pose::Identity(), bad, 1.0}), Reason::BadParameter);
  }
}

TEST(Input, refusesAMotionThatWouldTakeHours) {
  EXPECT_EQ(reasonFor(line(TcpSpeed{1e-9})), Reason::BadParameter);
  EXPECT_EQ(reasonFor(line(TcpSpeed{5e-324})), Reason::BadParameter);
  EXPECT_EQ(reasonFor(ptp(5e-324)), Reason::BadParameter);
  EXPECT_EQ(reasonFor(ptp(0.5, Duration::max())), Reason::BadParameter);
  EXPECT_EQ(reasonFor(ptp(1e-200), {arm::Pose::Identity(), arm::Pose::Identity(), 1e-200}),
            Reason::BadParameter);
}

TEST(Input, refusesFinitePosesBeyondAllReach) {
  arm::Pose far = nearby();
  far(0, 3) = 1e308;
  EXPECT_EQ(reasonFor(Ptp{PoseTarget{far, {}}, 0.5, milliseconds(200)}), Reason::Unreachable);
  EXPECT_EQ(reasonFor(Line{far, SpeedRatio{0.1}, milliseconds(200)}), Reason::BadParameter)
      << "takes too long";
}

}  // namespace
}  // namespace cobot_command::motion
