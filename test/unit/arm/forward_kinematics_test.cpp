#include "cobot_command/arm/forward_kinematics.h"

#include "arm_test_support.h"
#include <Eigen/LU>
#include <gtest/gtest.h>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainjnttojacsolver.hpp>

namespace cobot_command::arm {
namespace {

constexpr int kPostures = 2000;

class ForwardKinematics : public ::testing::TestWithParam<std::string> {
 protected:
  const ArmModel arm = model(GetParam());
  RandomPostures postures{arm};
};
INSTANTIATE_TEST_SUITE_P(EveryModel, ForwardKinematics, ::testing::ValuesIn(ArmModel::knownNames()),
                         modelNameForTest);

KDL::JntArray toKdl(const JointVector& joints) {
  KDL::JntArray result(6);
  result.data = joints;
  return result;
}

TEST_P(ForwardKinematics, agreesWithKdlOnTheChainOfTheUrdf) {
  KDL::ChainFkSolverPos_recursive solver(arm.chain());
  for (int i = 0; i < kPostures; ++i) {
    const JointVector joints = postures.next();
    KDL::Frame frame;
    ASSERT_GE(solver.JntToCart(toKdl(joints), frame), 0);
    const Pose flange = forwardKinematics(arm, joints);
    for (int row = 0; row < 3; ++row) {
      ASSERT_NEAR(flange.translation()[row], frame.p(row), 1e-12);
      for (int column = 0; column < 3; ++column) {
        ASSERT_NEAR(flange.linear()(row, column), frame.M(row, column), 1e-12);
      }
    }
  }
}

TEST_P(ForwardKinematics, itsJacobianAgreesWithKdl) {
  KDL::ChainJntToJacSolver solver(arm.chain());
  KDL::Jacobian expected(6);
  for (int i = 0; i < kPostures; ++i) {
    const JointVector joints = postures.next();
    ASSERT_GE(solver.JntToJac(toKdl(joints), expected), 0);
    ASSERT_LT((jacobianAt(arm, joints) - expected.data).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST_P(ForwardKinematics, itsJacobianIsTheDerivativeOfThePose) {
  constexpr double kStep = 1e-6;
  for (int i = 0; i < kPostures / 10; ++i) {
    const JointVector joints = postures.next();
    const Jacobian jacobian = jacobianAt(arm, joints);
    for (Eigen::Index k = 0; k < 6; ++k) {
      const JointVector step = kStep * JointVector::Unit(k);
      const Pose before = forwardKinematics(arm, joints - step);
      const Pose after = forwardKinematics(arm, joints + step);
      const Eigen::Vector3d linear = (after.translation() - before.translation()) / (2 * kStep);
      const Eigen::AngleAxisd turn(after.linear() * before.linear().transpose());
      const Eigen::Vector3d angular = turn.axis() * turn.angle() / (2 * kStep);
      ASSERT_LT((jacobian.col(k).head<3>() - linear).norm(), 1e-8);
      ASSERT_LT((jacobian.col(k).tail<3>() - angular).norm(), 1e-8);
    }
  }
}

TEST_P(ForwardKinematics, theJacobiansDeterminantIsTheProductOfTheSingularityDistances) {
  for (int i = 0; i < kPostures; ++i) {
    const JointVector joints = postures.next();
    const SingularityDistance distance = singularityDistance(arm, joints);
    const double expected =
        arm.lengths().a2 * arm.lengths().a3 * distance.shoulder * distance.elbow * distance.wrist;
    ASSERT_NEAR(std::abs(jacobianAt(arm, joints).determinant()), expected, 1e-12);
  }
}

TEST_P(ForwardKinematics, aWholeTurnOfAnyJointChangesNothing) {
  for (int i = 0; i < kPostures / 10; ++i) {
    const JointVector joints = postures.next();
    for (Eigen::Index k = 0; k < 6; ++k) {
      const JointVector turned = joints - 2 * kPi * JointVector::Unit(k);
      ASSERT_LT(difference(forwardKinematics(arm, turned), forwardKinematics(arm, joints)), 1e-14);
    }
  }
}

TEST(SingularityDistance, isZeroOnlyInTheCoordinateThatIsSingular) {
  const ArmModel arm = model("tm5-900");
  const auto elbow = singularityDistance(arm, toJointVector({10, 40, 0, 20, 80, 30}));
  EXPECT_EQ(elbow.elbow, 0);
  EXPECT_GT(elbow.wrist, 0.9);
  EXPECT_GT(elbow.shoulder, 0.1);
  const auto wrist = singularityDistance(arm, toJointVector({10, 40, 90, 20, 180, 30}));
  EXPECT_NEAR(wrist.wrist, 0, 1e-15);
  EXPECT_EQ(wrist.elbow, 1);
  EXPECT_NEAR(singularityDistance(arm, toJointVector({10, 0, 0, 0, 90, 30})).shoulder, 0, 1e-15);
}

}  // namespace
}  // namespace cobot_command::arm
