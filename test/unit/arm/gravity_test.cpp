// The torques that hold the arm: KDL's recursive Newton-Euler and a sum by hand confirm them.
#include "cobot_command/arm/gravity.h"

#include <random>

#include "arm_test_support.h"
#include <gtest/gtest.h>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>

namespace cobot_command::arm {
namespace {

constexpr double kGravity = 9.80665;

/// By KDL, with the mass at the end of the chain.
JointVector byKdl(const ArmModel& arm, const JointVector& joints, const PointMass& carried) {
  KDL::Chain chain = arm.chain();
  const KDL::Vector centre(carried.centre.x(), carried.centre.y(), carried.centre.z());
  chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), KDL::Frame::Identity(),
                                KDL::RigidBodyInertia(carried.mass, centre)));
  KDL::ChainIdSolver_RNE solver(chain, KDL::Vector(0, 0, -kGravity));
  KDL::JntArray position(6), still(6), torques(6);
  position.data = joints;
  EXPECT_GE(solver.CartToJnt(position, still, still, KDL::Wrenches(chain.getNrOfSegments()), torques), 0);
  return torques.data;
}

TEST(HoldingTorques, areThoseOfKdlForEachModelAndWhatItCarries) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(-3.0, 3.0);
  std::uniform_real_distribution<double> place(-0.3, 0.3);
  for (const std::string& name : ArmModel::knownNames()) {
    const ArmModel arm = *ArmModel::named(name);
    for (int i = 0; i < 200; ++i) {
      JointVector joints;
      for (double& joint : joints) joint = angle(random);
      const PointMass carried{i % 2 == 0 ? 0.0 : 3.5, {place(random), place(random), place(random)}};
      EXPECT_LT((holdingTorques(arm, joints, carried) - byKdl(arm, joints, carried)).cwiseAbs().maxCoeff(),
                1e-9)
          << name;
    }
  }
}

TEST(HoldingTorques, areNoneAboutTheUprightAxisAndLeastWhereTheArmStandsUpright) {
  const ArmModel arm = *ArmModel::named("tm5-900");
  JointVector forward = JointVector::Zero();
  forward[1] = kPi / 2;
  const JointVector stretched = holdingTorques(arm, forward);
  const JointVector upright = holdingTorques(arm, JointVector::Zero());
  EXPECT_NEAR(stretched[0], 0.0, 1e-12);
  EXPECT_LT(stretched[1], -50.0) << "it falls forward, so the shoulder pushes back";
  EXPECT_GT(stretched[1], -157.0) << "the arm can hold itself: the effort of the shoulder in the URDF";
  EXPECT_NEAR(upright[1], 0.0, 0.5);
}

TEST(HoldingTorques, growWithTheToolAndItsLever) {
  const ArmModel arm = *ArmModel::named("tm5-900");
  JointVector joints = JointVector::Zero();
  joints[2] = joints[4] = kPi / 2;  // the flange looks down
  const PointMass aside{2.0, {0.1, 0.0, 0.0}};
  const JointVector more = holdingTorques(arm, joints, aside) - holdingTorques(arm, joints);
  const Pose flange = forwardKinematics(arm, joints);
  const double reach = (flange * aside.centre).x();  // axis 2 is the Y of the base
  EXPECT_NEAR(more[1], -2.0 * kGravity * reach, 1e-9);
  EXPECT_NEAR(more[5], 0.0, 1e-9) << "axis 6 is upright";
}

TEST(HoldingTorques, areNoneOfAnArmWhoseUrdfTellsNoMasses) {
  std::string urdf = ArmModel::urdfOf("tm12");
  for (std::size_t begin; (begin = urdf.find("<inertial>")) != std::string::npos;) {
    urdf.erase(begin, urdf.find("</inertial>", begin) + 11 - begin);
  }
  const ArmModel arm = *ArmModel::fromUrdf(urdf);
  EXPECT_EQ(holdingTorques(arm, JointVector::Constant(0.5)), JointVector::Zero());
}

TEST(PointMasses, addUpAroundTheirCommonCentre) {
  const PointMass both = PointMass{1.0, {0.0, 0.0, 0.4}} + PointMass{3.0, {0.2, 0.0, 0.0}};
  EXPECT_EQ(both.mass, 4.0);
  EXPECT_LT((both.centre - Eigen::Vector3d(0.15, 0.0, 0.1)).norm(), 1e-15);
  EXPECT_EQ((PointMass{} + PointMass{}).mass, 0.0);
  EXPECT_EQ((PointMass{} + PointMass{}).centre, Eigen::Vector3d(Eigen::Vector3d::Zero()));
}

}  // namespace
}  // namespace cobot_command::arm
