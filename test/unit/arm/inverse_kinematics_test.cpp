#include "cobot_command/arm/inverse_kinematics.h"

#include <limits>
#include <set>

#include "arm_test_support.h"
#include <gtest/gtest.h>

namespace cobot_command::arm {
namespace {

constexpr int kPostures = 10000;

class InverseKinematics : public ::testing::TestWithParam<std::string> {
 protected:
  const ArmModel arm = model(GetParam());
  RandomPostures postures{arm};
};
INSTANTIATE_TEST_SUITE_P(EveryModel, InverseKinematics, ::testing::ValuesIn(ArmModel::knownNames()),
                         modelNameForTest);

TEST_P(InverseKinematics, everyBranchOfRandomPosturesReachesThePose) {
  for (int i = 0; i < kPostures; ++i) {
    const Pose flange = forwardKinematics(arm, postures.next());
    const Branches branches = allBranches(arm, flange);
    ASSERT_FALSE(branches.empty());
    ASSERT_LT(worstPoseError(arm, branches, flange), 1e-11);
  }
}

TEST_P(InverseKinematics, theControllersOwnPoseSurvivesTheRoundTripToItsLastDigit) {
  for (int i = 0; i < kPostures; ++i) {
    const ControllerPose wanted = toControllerPose(forwardKinematics(arm, postures.next()));
    for (const Branch& branch : allBranches(arm, toPose(wanted))) {
      const ControllerPose reached = toControllerPose(forwardKinematics(arm, branch.joints));
      for (std::size_t k = 0; k < 6; ++k) {
        const double off = k < 3 ? wanted[k] - reached[k] : std::remainder(wanted[k] - reached[k], 360.0);
        ASSERT_LT(std::abs(off), 1e-6) << "coordinate " << k;
      }
    }
  }
}

TEST_P(InverseKinematics, thePostureThatMadeThePoseIsFoundUnderItsOwnBits) {
  for (int i = 0; i < kPostures; ++i) {
    const JointVector joints = postures.next();
    const Branches branches = allBranches(arm, forwardKinematics(arm, joints));
    const Branch* branch = branchWith(branches, poseBitsOf(arm, joints));
    ASSERT_NE(branch, nullptr) << joints.transpose();
    // Random postures may be near a singularity, where joints are worth less than poses.
    const auto distance = singularityDistance(arm, joints);
    const double worth = std::min({distance.shoulder, distance.elbow, distance.wrist});
    ASSERT_LT(turnlessDifference(branch->joints, joints), 1e-12 / worth) << joints.transpose();
  }
}

TEST_P(InverseKinematics, theBitsOfEveryBranchAreThoseOfItsPostureAndNoTwoAreEqual) {
  for (int i = 0; i < kPostures; ++i) {
    std::set<std::array<int, 3>> seen;
    for (const Branch& branch : allBranches(arm, forwardKinematics(arm, postures.next()))) {
      ASSERT_EQ(poseBitsOf(arm, branch.joints), branch.bits) << branch.joints.transpose();
      ASSERT_TRUE(seen.insert(branch.bits.numbers()).second);
    }
  }
}

TEST_P(InverseKinematics, aBranchAskedForByItsBitsIsTheSameToTheLastDigit) {
  for (int i = 0; i < kPostures; ++i) {
    JointVector joints = postures.next();
    if (i % 5 == 0) joints[4] = 0;  // singular
    if (i % 7 == 0) joints[2] = 0;
    const Pose flange = forwardKinematics(arm, joints);
    const Branches all = allBranches(arm, flange, joints);
    for (const int bits : {0, 1, 2, 3, 4, 5, 6, 7}) {
      const PoseBits wanted = *PoseBits::fromNumbers(bits & 1, 2 + (bits >> 1 & 1), 4 + (bits >> 2));
      const Branch* expected = branchWith(all, wanted);
      const auto found = branchWith(arm, flange, wanted, joints);
      ASSERT_EQ(found.has_value(), expected != nullptr);
      if (found) {
        ASSERT_EQ(*found, expected->joints);
      }
    }
  }
}

TEST_P(InverseKinematics, everyJointOfEveryBranchIsWithinHalfATurn) {
  for (int i = 0; i < kPostures; ++i) {
    for (const Branch& branch : allBranches(arm, forwardKinematics(arm, postures.next()))) {
      ASSERT_GT(branch.joints.minCoeff(), -kPi);
      ASSERT_LE(branch.joints.maxCoeff(), kPi);
    }
  }
}

TEST_P(InverseKinematics, aPoseOutOfReachHasNoBranches) {
  Pose far = Pose::Identity();
  far.translation() << 2.0, 0.0, 0.5;
  EXPECT_TRUE(allBranches(arm, far).empty());

  Pose inside_the_shoulder_cylinder = Pose::Identity();
  inside_the_shoulder_cylinder.translation() << 0.0, std::abs(arm.lengths().d4) - 1e-3, 0.5;
  EXPECT_TRUE(allBranches(arm, inside_the_shoulder_cylinder).empty());
}

TEST_P(InverseKinematics, whatIsNotAFinitePoseHasNoBranches) {
  const Pose good = forwardKinematics(arm, toJointVector({30, -20, 100, 10, 80, -45}));
  ASSERT_EQ(allBranches(arm, good).size(), 8U);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity(), 1e308, -1e308}) {
    for (Eigen::Index row = 0; row < 3; ++row) {
      for (Eigen::Index column = 0; column < 4; ++column) {
        Pose pose = good;
        pose.matrix()(row, column) = bad;
        EXPECT_TRUE(allBranches(arm, pose).empty()) << row << ' ' << column << ' ' << bad;
      }
    }
  }
}

TEST_P(InverseKinematics, aMirrorImageOrAStretchedFrameHasNoBranches) {
  const Pose good = forwardKinematics(arm, toJointVector({30, -20, 100, 10, 80, -45}));
  Pose mirrored = good;
  mirrored.linear().col(0) *= -1;
  Pose stretched = good;
  stretched.linear() *= 1.001;
  Pose skewed = good;
  skewed.linear().col(0) += 1e-3 * good.linear().col(1);
  for (const Pose& pose : {mirrored, stretched, skewed}) EXPECT_TRUE(allBranches(arm, pose).empty());
}

TEST_P(InverseKinematics, aPoseInSinglePrecisionIsStillAPose) {
  const Pose exact = forwardKinematics(arm, toJointVector({30, -20, 100, 10, 80, -45}));
  const Pose rounded(exact.matrix().cast<float>().cast<double>());
  const Branches branches = allBranches(arm, rounded);
  ASSERT_EQ(branches.size(), 8U);
  EXPECT_LT(worstPoseError(arm, branches, exact), 1e-5);
}

}  // namespace
}  // namespace cobot_command::arm
