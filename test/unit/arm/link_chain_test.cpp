#include "cobot_command/arm/link_chain.h"

#include "arm_test_support.h"
#include <gtest/gtest.h>
#include <kdl/chainfksolverpos_recursive.hpp>

#include "cobot_command/arm/urdf_prefix.h"

namespace cobot_command::arm {
namespace {

class LinkChainTest : public ::testing::TestWithParam<std::string> {
 protected:
  const ArmModel arm = model(GetParam());
  const LinkChain chain{arm};
  RandomPostures postures{arm};
};
INSTANTIATE_TEST_SUITE_P(EveryModel, LinkChainTest, ::testing::ValuesIn(ArmModel::knownNames()),
                         modelNameForTest);

TEST_P(LinkChainTest, endsAtTheFlangeOfTheClosedForm) {
  Pose base = Pose::Identity();
  base.translate(Eigen::Vector3d(1, 2, 3)).rotate(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitX()));
  for (int i = 0; i < 500; ++i) {
    const JointVector joints = postures.next();
    const LinkFrames frames = chain.framesAt(joints, base);
    ASSERT_EQ(difference(frames.front(), base), 0);
    ASSERT_LT(difference(frames.back() * chain.flange(), base * forwardKinematics(arm, joints)), 1e-12);
  }
}

TEST_P(LinkChainTest, agreesWithKdlOnEachLink) {
  KDL::ChainFkSolverPos_recursive solver(arm.chain());
  for (int i = 0; i < 100; ++i) {
    const JointVector joints = postures.next();
    KDL::JntArray angles(6);
    angles.data = joints;
    const LinkFrames frames = chain.framesAt(joints);
    std::size_t link = 0;
    for (unsigned int segment = 0; segment < arm.chain().getNrOfSegments(); ++segment) {
      if (arm.chain().getSegment(segment).getJoint().getType() == KDL::Joint::None) continue;
      ++link;
      KDL::Frame frame;
      ASSERT_GE(solver.JntToCart(angles, frame, static_cast<int>(segment) + 1), 0);
      for (int row = 0; row < 3; ++row) {
        ASSERT_NEAR(frames[link].translation()[row], frame.p(row), 1e-12);
        for (int column = 0; column < 3; ++column) {
          ASSERT_NEAR(frames[link].linear()(row, column), frame.M(row, column), 1e-12);
        }
      }
    }
    ASSERT_EQ(link, kJointCount);
  }
}

TEST_P(LinkChainTest, itsAxesAreThoseOfTheJacobian) {
  for (int i = 0; i < 200; ++i) {
    const JointVector joints = postures.next();
    const Jacobian jacobian = jacobianAt(arm, joints);
    const Eigen::Vector3d flange = forwardKinematics(arm, joints).translation();
    const JointAxes axes = chain.axesOf(chain.framesAt(joints));
    for (std::size_t k = 0; k < kJointCount; ++k) {
      const auto column = jacobian.col(static_cast<Eigen::Index>(k));
      ASSERT_LT((axes[k].direction - column.tail<3>()).norm(), 1e-12);
      ASSERT_LT((axes[k].direction.cross(flange - axes[k].origin) - column.head<3>()).norm(), 1e-12);
    }
  }
}

}  // namespace
}  // namespace cobot_command::arm
