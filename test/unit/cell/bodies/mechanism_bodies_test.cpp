#include "cobot_command/cell/bodies/mechanism_bodies.h"

#include <gmock/gmock.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/units.h"

namespace cobot_command::cell {
namespace {

const std::vector<Shape> kBall = {{SphereShape{0.05}, arm::toPose({300, 0, 0, 0, 0, 0})}};

MechanismBodies bodiesOf(const MotionAxis& axis, const std::vector<Shape>& shapes) {
  return *MechanismBodies::of(axis, shapes);
}

TEST(APrismaticMechanism, movesAlongItsAxisInTheFrameThatStandsInTheWorld) {
  // Turned by 90 degrees about z, so that its y is the world's -x.
  const MechanismBodies pallet =
      bodiesOf({false, arm::toPose({0, 0, 100, 0, 0, 90}), Eigen::Vector3d::UnitY()}, kBall);
  EXPECT_TRUE(pallet.at(0.0)[0].from.isApprox(Eigen::Vector3d(0.0, 0.3, 0.1)));
  EXPECT_TRUE(pallet.at(0.5)[0].from.isApprox(Eigen::Vector3d(-0.5, 0.3, 0.1)));
  EXPECT_EQ(pallet.displacementBound(0, 0.01), 0.01) << "the same for every point";
}

TEST(ARevoluteMechanism, turnsAboutTheLineThroughItsFrame) {
  const MechanismBodies table =
      bodiesOf({true, arm::toPose({1000, 0, 0, 0, 0, 0}), Eigen::Vector3d::UnitZ()}, kBall);
  EXPECT_TRUE(table.at(degToRad(90.0))[0].from.isApprox(Eigen::Vector3d(1.0, 0.3, 0.0)));
  EXPECT_NEAR(table.displacementBound(0, 0.1), 0.035, 1e-12) << "of its farthest point";
}

TEST(TheBodiesOfAMechanism, moveNoFartherThanTheirBound) {
  const std::vector<Shape> shapes = {{BoxShape{{0.4, 0.3, 0.2}}, arm::toPose({120, -40, 90, 10, 20, 30})},
                                     {CapsuleShape{{0, 0, 0}, {0.5, 0.1, 0.2}, 0.04}, arm::Pose::Identity()}};
  for (const bool turns : {false, true}) {
    const MechanismBodies bodies = bodiesOf(
        {turns, arm::toPose({100, 200, 300, 40, 50, 60}), Eigen::Vector3d(1, -2, 0.5).normalized()}, shapes);
    for (const double half : {0.001, 0.1, 0.7}) {
      const Capsules middle = bodies.at(0.4);
      for (const double value : {0.4 - half, 0.4 + half, 0.4 + 0.3 * half}) {
        const Capsules there = bodies.at(value);
        for (std::size_t body = 0; body < bodies.size(); ++body) {
          const double bound = bodies.displacementBound(body, half) + 1e-12;
          EXPECT_LE((there[body].from - middle[body].from).norm(), bound);
          EXPECT_LE((there[body].to - middle[body].to).norm(), bound);
          EXPECT_LE(bound, bodies.largestDisplacement(half) + 1e-12);
        }
      }
    }
  }
}

TEST(TheBodiesOfAMechanism, areRefusedWhereAShapeIsNone) {
  const auto bodies = MechanismBodies::of({}, {{SphereShape{0.0}, arm::Pose::Identity()}});
  ASSERT_FALSE(bodies);
  EXPECT_THAT(bodies.error().message, testing::HasSubstr("radii must be finite and above 0"));
}

}  // namespace
}  // namespace cobot_command::cell
