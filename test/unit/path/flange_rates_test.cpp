// How fast the flange goes along a planned path.
#include "cobot_command/path/flange_rates.h"

#include "path_support.h"

namespace cobot_command::path {
namespace {

using std::chrono::milliseconds;

class Rates : public Paths {
 protected:
  [[nodiscard]] FlangeRates at(const PathPlan& plan, Duration time) const {
    return flangeRatesAt(plan, time, scene.arm);
  }
  /// 100 mm at 100 mm/s and 500 mm/s^2: 0.2 s, 0.8 s, 0.2 s.
  [[nodiscard]] PathPlan line() const {
    arm::ControllerPose pose = flangeAt(scene.start);
    pose[1] += 100;
    return planned({toPose(pose)});
  }
};

TEST_F(Rates, ofALineAreThoseOfItsRampsAndOfWhatIsBetweenThem) {
  const PathPlan plan = line();
  const FlangeRates up = at(plan, milliseconds(100));
  EXPECT_NEAR(up.linear_velocity, 0.05, 1e-3);
  EXPECT_NEAR(up.linear_acceleration, 0.5, 0.01);
  const FlangeRates middle = at(plan, plan.duration() / 2);
  EXPECT_NEAR(middle.linear_velocity, 0.1, 1e-4);
  EXPECT_NEAR(middle.linear_acceleration, 0, 0.01);
  EXPECT_NEAR(middle.angular_velocity, 0, 1e-3);
  EXPECT_NEAR(middle.angular_acceleration, 0, 0.05);
}

TEST_F(Rates, ofATurnOfTheBaseAreThoseOfACircleAroundIt) {
  PathPoint turn = toJoints({90, 0, 90, 0, 90, 0});
  turn.speed = 60;
  turn.acceleration = turn.deceleration = 120;
  const PathPlan plan = planned({turn});
  const FlangeRates middle = at(plan, plan.duration() / 2);
  const double omega = degToRad(60);
  const double radius = arm::forwardKinematics(scene.arm, scene.start).translation().head<2>().norm();
  EXPECT_NEAR(middle.angular_velocity, omega, 1e-6);
  EXPECT_NEAR(middle.angular_acceleration, 0, 1e-3);
  EXPECT_NEAR(middle.linear_velocity, omega * radius, 1e-6);
  EXPECT_NEAR(middle.linear_acceleration, omega * omega * radius, 1e-3) << "across its way";
  EXPECT_NEAR(at(plan, milliseconds(250)).angular_acceleration, degToRad(120), 1e-3);
}

TEST_F(Rates, areNoneBeforeThePathAndBehindIt) {
  const PathPlan plan = line();
  for (const Duration time : {Duration(milliseconds(-1)), plan.duration() + milliseconds(1)}) {
    EXPECT_EQ(at(plan, time).linear_velocity, 0);
    EXPECT_EQ(at(plan, time).linear_acceleration, 0);
  }
  EXPECT_NEAR(at(plan, plan.duration()).linear_velocity, 0, 1e-6);
}

}  // namespace
}  // namespace cobot_command::path
