// A time to top speed of 0, as off-line programming tools send it: the shortest ramp that the arm's rated
// acceleration allows.
#include <cmath>

#include "motion_support.h"
#include "profiles/ramp_time.h"

namespace cobot_command::motion {
namespace {

Ptp aside(double speed_ratio, Duration ramp) {
  return {degrees(100, 15, 80, -5, 85, 20), speed_ratio, ramp};
}

/// How long each takes with a time of zero, and with one that is given.
void expectTheSame(const Command& zero, const Command& given, const Setting& setting = {}) {
  const auto a = planned(plan(model(), workingPosture(), zero, setting));
  const auto b = planned(plan(model(), workingPosture(), given, setting));
  ASSERT_TRUE(a && b);
  EXPECT_NEAR(toSeconds(a->duration()), toSeconds(b->duration()), 1e-8);
  EXPECT_NEAR(toSeconds(a->timeUp()), toSeconds(b->timeUp()), 1e-8);
  const Duration middle = a->duration() / 3;
  EXPECT_LT((a->at(middle).position - b->at(middle).position).cwiseAbs().maxCoeff(), 1e-7);
}

TEST(ZeroRamp, takesAPtpToFullSpeedWithTheRatedAcceleration) {
  expectTheSame(aside(1.0, Duration::zero()), aside(1.0, milliseconds(150)));
}

TEST(ZeroRamp, isShorterTheLowerTheSpeedIs) {
  expectTheSame(aside(0.1, Duration::zero()), aside(0.1, milliseconds(15)));
}

TEST(ZeroRamp, staysAsItIsWhenTheProjectIsSlower) {
  Setting slow;
  slow.speed_override = 0.25;
  expectTheSame(aside(0.2, Duration::zero()), aside(0.2, milliseconds(30)), slow);
}

TEST(ZeroRamp, neverAsksAJointForMoreThanItsRatedAcceleration) {
  const arm::ArmModel arm = model();
  const double rated = arm.limits()[0].max_velocity / kRatedRamp;
  for (const double ratio : {1.0, 0.35}) {
    const auto motion = planned(plan(arm, workingPosture(), aside(ratio, Duration::zero()), Setting{}));
    ASSERT_TRUE(motion);
    JointState previous = motion->at(Duration::zero());
    double highest = 0.0;
    for (Duration time = milliseconds(1); time <= motion->duration(); time += milliseconds(1)) {
      const JointState state = motion->at(time);
      const double acceleration = std::abs(state.velocity[0] - previous.velocity[0]) / 1e-3;
      highest = std::max(highest, acceleration / rated);
      previous = state;
    }
    EXPECT_NEAR(highest, 1.0, 1e-6) << ratio;
  }
}

TEST(ZeroRamp, ofALineAndACircleIsThatOfTheTcp) {
  const arm::ArmModel arm = model();
  const arm::Pose from = arm::forwardKinematics(arm, workingPosture());
  const arm::Pose to = moved(from, 0.0, 0.08, 0.0);
  const arm::Pose via = moved(from, 0.02, 0.04, 0.0);
  const double full = arm.ratings().max_tcp_speed;
  const auto ramp = [](double share) { return fromSeconds(share * kRatedRamp); };
  expectTheSame(Line{to, SpeedRatio{0.2}, {}}, Line{to, SpeedRatio{0.2}, ramp(0.2)});
  expectTheSame(Line{to, TcpSpeed{0.1}, {}}, Line{to, TcpSpeed{0.1}, ramp(0.1 / full)});
  expectTheSame(PLine{to, TcpSpeed{0.1}, {}}, PLine{to, TcpSpeed{0.1}, ramp(0.1 / full)});
  expectTheSame(Circle{via, to, {}, SpeedRatio{0.1}, {}}, Circle{via, to, {}, SpeedRatio{0.1}, ramp(0.1)});
}

TEST(ZeroRamp, ofATurnIsThatOfTheTurn) {
  const arm::Pose from = arm::forwardKinematics(model(), workingPosture());
  const arm::Pose to = moved(from, 0.0, 0.001, 0.0, 0.5);
  expectTheSame(Line{to, SpeedRatio{0.3}, {}}, Line{to, SpeedRatio{0.3}, fromSeconds(0.3 * kRatedRamp)});
  // The speed in mm/s does not rule, the turn at full speed does.
  Setting slow;
  slow.speed_override = 0.25;
  expectTheSame(Line{to, TcpSpeed{1.0}, {}}, Line{to, TcpSpeed{1.0}, fromSeconds(kRatedRamp)}, slow);
}

TEST(ZeroRamp, ofRelativeMotionsIsTheSame) {
  const arm::JointVector by = degrees(20, 0, 0, 0, 0, 0);
  expectTheSame(MovePtp{by, 0.5, {}}, MovePtp{by, 0.5, milliseconds(75)});
  PoseOffset offset{arm::Pose::Identity(), PoseOffset::Axes::Base};
  offset.by.translation().y() = 0.05;
  expectTheSame(MoveLine{offset, SpeedRatio{0.1}, {}}, MoveLine{offset, SpeedRatio{0.1}, milliseconds(15)});
}

TEST(ZeroRamp, ofNoWayIsNoMotion) {
  const Ptp nowhere{workingPosture(), 0.5, {}};
  EXPECT_EQ(planned(plan(model(), workingPosture(), nowhere, Setting{}))->duration(), Duration::zero());
  const Line here{arm::forwardKinematics(model(), workingPosture()), SpeedRatio{0.5}, {}};
  EXPECT_EQ(planned(plan(model(), workingPosture(), here, Setting{}))->duration(), Duration::zero());
}

}  // namespace
}  // namespace cobot_command::motion
