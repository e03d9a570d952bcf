// At, and at every distance from, the three singularities: no branch lost, no digit lost.
#include <set>
#include <string>
#include <vector>

#include "arm_test_support.h"
#include <gtest/gtest.h>

namespace cobot_command::arm {
namespace {

constexpr int kPostures = 1000;

/// Brings a posture to a distance from a singularity [rad, or for the shoulder rad of joint 2].
struct Approach {
  const char* name;
  void (*bring)(const ArmModel& arm, JointVector& joints, double offset);
  std::vector<double> offsets;  ///< where the posture itself must be found
};

/// Turns joint 2 so that the wrist centre stands above or below the shoulder, then away by `offset`.
void bringToShoulder(const ArmModel& arm, JointVector& joints, double offset) {
  const DhLengths& k = arm.lengths();
  const double forearm = joints[2];
  const double wrist = joints[2] + joints[3];
  const double up = k.a2 + k.a3 * std::cos(forearm) + k.d5 * std::cos(wrist);
  const double forward = k.a3 * std::sin(forearm) + k.d5 * std::sin(wrist);
  joints[1] = -std::atan2(forward, up) + offset;
}

void bringToStraightWrist(const ArmModel&, JointVector& joints, double offset) {
  joints[4] = offset;
}
void bringToFoldedWrist(const ArmModel&, JointVector& joints, double offset) {
  joints[4] = kPi - offset;
}
void bringToElbow(const ArmModel&, JointVector& joints, double offset) {
  joints[2] = offset;
}
void bringToStraightUp(const ArmModel&, JointVector& joints, double offset) {
  joints[1] = offset;
  joints[2] = 0;
}
void bringToElbowAndWrist(const ArmModel&, JointVector& joints, double offset) {
  joints[2] = -offset;
  joints[4] = offset;
}
void bringToShoulderAndWrist(const ArmModel& arm, JointVector& joints, double offset) {
  bringToShoulder(arm, joints, offset);
  joints[4] = -offset;
}
void bringToZero(const ArmModel&, JointVector& joints, double offset) {
  joints.setConstant(offset);
}

const std::vector<double> all_offsets = {1e-2,  1e-4, 1e-6,   1e-8,  1e-10, 1e-12,
                                         1e-14, 0.0,  -1e-12, -1e-8, -1e-6, -1e-2};
/// Between these, where joint 1 and joint 6 are both lost in rounding, a posture with a stretched arm may be
/// missed (doc/kinematics.md).
const std::vector<double> coarse_offsets_and_zero = {1e-2, 1e-4, 1e-6, 0.0, -1e-6, -1e-2};

const std::vector<Approach> approaches = {
    {"straightWrist", bringToStraightWrist, all_offsets},
    {"foldedWrist", bringToFoldedWrist, all_offsets},
    {"elbow", bringToElbow, all_offsets},
    {"shoulder", bringToShoulder, all_offsets},
    {"armStraightUp", bringToStraightUp, all_offsets},
    {"elbowAndWrist", bringToElbowAndWrist, all_offsets},
    {"shoulderAndWrist", bringToShoulderAndWrist, coarse_offsets_and_zero},
    {"zeroPosture", bringToZero, coarse_offsets_and_zero}};

class Singularity : public ::testing::TestWithParam<Approach> {};
INSTANTIATE_TEST_SUITE_P(From, Singularity, ::testing::ValuesIn(approaches),
                         [](const auto& approach) { return std::string(approach.param.name); });

TEST_P(Singularity, theGeneratingPostureIsFoundUnderItsBits) {
  for (const std::string& name : ArmModel::knownNames()) {
    const ArmModel arm = model(name);
    RandomPostures postures(arm);
    for (const double offset : GetParam().offsets) {
      for (int i = 0; i < kPostures; ++i) {
        JointVector joints = postures.next();
        GetParam().bring(arm, joints, offset);
        const Branches branches = allBranches(arm, forwardKinematics(arm, joints), joints);
        ASSERT_NE(branchWith(branches, poseBitsOf(arm, joints)), nullptr)
            << name << ' ' << offset << ": " << joints.transpose();
      }
    }
  }
}

TEST_P(Singularity, everyBranchReachesThePoseWhateverTheOffsetAndTheReference) {
  for (const std::string& name : ArmModel::knownNames()) {
    const ArmModel arm = model(name);
    RandomPostures postures(arm);
    for (const double offset : all_offsets) {
      for (int i = 0; i < kPostures; ++i) {
        JointVector joints = postures.next();
        GetParam().bring(arm, joints, offset);
        const Pose flange = forwardKinematics(arm, joints);
        const Branches branches = allBranches(arm, flange, postures.next());
        ASSERT_FALSE(branches.empty()) << name << ' ' << offset << ": " << joints.transpose();
        ASSERT_LT(worstPoseError(arm, branches, flange), 2e-10)
            << name << ' ' << offset << ": " << joints.transpose();
      }
    }
  }
}

TEST_P(Singularity, noTwoBranchesShareTheirBitsExactlyThere) {
  const ArmModel arm = model("tm5-900");
  RandomPostures postures(arm);
  for (int i = 0; i < kPostures; ++i) {
    JointVector joints = postures.next();
    GetParam().bring(arm, joints, 0.0);
    std::set<std::array<int, 3>> seen;
    for (const Branch& branch : allBranches(arm, forwardKinematics(arm, joints), joints)) {
      ASSERT_TRUE(seen.insert(branch.bits.numbers()).second);
    }
  }
}

class StraightWrist : public ::testing::TestWithParam<double> {
 protected:
  const ArmModel arm = model("tm5-900");
};
INSTANTIATE_TEST_SUITE_P(Joint5, StraightWrist, ::testing::Values(0.0, kPi));

TEST_P(StraightWrist, takesJoint6FromTheReference) {
  RandomPostures postures(arm);
  for (int i = 0; i < kPostures; ++i) {
    JointVector joints = postures.next();
    joints[4] = GetParam();
    const Branches branches = allBranches(arm, forwardKinematics(arm, joints), joints);
    const Branch* branch = branchWith(branches, poseBitsOf(arm, joints));
    ASSERT_NE(branch, nullptr);
    ASSERT_NEAR(std::remainder(branch->joints[5] - joints[5], 2 * kPi), 0, 1e-9);
  }
}

TEST_P(StraightWrist, isFoundWhateverTheReference) {
  RandomPostures postures(arm);
  for (int i = 0; i < kPostures; ++i) {
    JointVector joints = postures.next();
    joints[4] = GetParam();
    const Pose flange = forwardKinematics(arm, joints);
    const Branches branches = allBranches(arm, flange, postures.next());
    ASSERT_NE(branchWith(branches, poseBitsOf(arm, joints)), nullptr) << joints.transpose();
    ASSERT_LT(worstPoseError(arm, branches, flange), 1e-10);
  }
}

TEST_P(StraightWrist, isFoundFromAReferenceThatIsNotFinite) {
  JointVector joints = toJointVector({30, -20, 100, 10, 0, -45});
  joints[4] = GetParam();
  const JointVector unknown = JointVector::Constant(std::nan(""));
  const Pose flange = forwardKinematics(arm, joints);
  const Branches branches = allBranches(arm, flange, unknown);
  ASSERT_FALSE(branches.empty());
  EXPECT_LT(worstPoseError(arm, branches, flange), 1e-10);
}

TEST(ElbowSingularity, reportsTheMeetingBranchesWithTheSameJoints) {
  const ArmModel arm = model("tm5-900");
  const JointVector joints = toJointVector({30, 40, 0, 10, 80, -45});
  const Branches branches = allBranches(arm, forwardKinematics(arm, joints), joints);
  const Branch* above = branchWith(branches, {Shoulder::Righty, Elbow::Above, Wrist::NoFlip});
  const Branch* below = branchWith(branches, {Shoulder::Righty, Elbow::Below, Wrist::NoFlip});
  ASSERT_NE(above, nullptr);
  ASSERT_NE(below, nullptr);
  EXPECT_LT(turnlessDifference(above->joints, below->joints), 1e-7);
  EXPECT_LT(turnlessDifference(above->joints, joints), 1e-7);
}

TEST(ShoulderSingularity, reportsTheMeetingBranchesWithTheSameJoints) {
  const ArmModel arm = model("tm5-900");
  JointVector joints = toJointVector({30, 0, 100, 10, 80, -45});
  bringToShoulder(arm, joints, 0);
  const Branches branches = allBranches(arm, forwardKinematics(arm, joints), joints);
  // Seen from the other side, positive joints are negative ones: each bit changes its name.
  const Branch* righty = branchWith(branches, {Shoulder::Righty, Elbow::Above, Wrist::NoFlip});
  const Branch* lefty = branchWith(branches, {Shoulder::Lefty, Elbow::Below, Wrist::Flip});
  ASSERT_NE(righty, nullptr);
  ASSERT_NE(lefty, nullptr);
  EXPECT_LT(turnlessDifference(righty->joints, lefty->joints), 1e-7);
  EXPECT_LT(turnlessDifference(righty->joints, joints), 1e-7);
}

}  // namespace
}  // namespace cobot_command::arm
