#include "cobot_command/arm/wrist_inverse.h"

#include <limits>

#include "arm_test_support.h"
#include <gtest/gtest.h>

namespace cobot_command::arm {
namespace {

using Eigen::Vector3d;

constexpr int kPostures = 5000;
/// Nearer to a singularity joints are worth less than places.
constexpr double kClearOfSingularities = 1e-3;

/// Tools up to half a metre long, turned in any way; every fifth is the flange itself.
class RandomTools {
 public:
  Pose next() {
    Pose tool = Pose::Identity();
    if (++made_ % 5 == 0) {
      return tool;
    }
    tool.translation() << part(0.3), part(0.3), part(0.3);
    tool.linear() = Eigen::Quaterniond(part(1), part(1), part(1), part(1)).normalized().toRotationMatrix();
    return tool;
  }
  double part(double most) { return std::uniform_real_distribution<double>(-most, most)(generator_); }

 private:
  std::mt19937_64 generator_{7};
  int made_ = 0;
};

Vector3d originOf(const ArmModel& arm, const Pose& tool, const JointVector& joints) {
  return (forwardKinematics(arm, joints) * tool).translation();
}

Vector3d wristOf(const JointVector& joints) {
  return joints.tail<3>();
}

/// What hangs at axis 3, as the forward kinematics show it: with the joints 1 to 3 at zero all of it is seen
/// from the side, straight above the shoulder.
struct Hanging {
  double length;  ///< [m]
  double delta;   ///< [rad]
  double across;  ///< [m]
};
Hanging hangingOf(const ArmModel& arm, const Pose& tool, JointVector joints) {
  joints.head<3>().setZero();
  const Vector3d origin = originOf(arm, tool, joints) - Vector3d(0, 0, arm.lengths().d1 + arm.lengths().a2);
  return {std::hypot(origin.x(), origin.z()), std::atan2(origin.x(), origin.z()), origin.y()};
}

double clearance(const WristArm& arm, const JointVector& joints) {
  const auto distance = arm.singularityDistance(joints);
  return std::min(distance.shoulder, distance.elbow);
}

const WristSolution* withBranch(const WristSolutions& solutions, const WristBranch& branch) {
  const auto found =
      std::find_if(solutions.begin(), solutions.end(), [&](const auto& s) { return s.branch == branch; });
  return found == solutions.end() ? nullptr : &*found;
}

void expectJoints(const JointVector& joints, const ControllerJoints& expected_deg) {
  const ControllerJoints found = toControllerJoints(joints);
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i], expected_deg[i], 5e-5) << "joint " << i + 1;
  }
}

class WristInverse : public ::testing::TestWithParam<std::string> {
 protected:
  const ArmModel arm = model(GetParam());
  RandomPostures postures{arm};
  RandomTools tools;
};
INSTANTIATE_TEST_SUITE_P(EveryModel, WristInverse, ::testing::ValuesIn(ArmModel::knownNames()),
                         modelNameForTest);

TEST_P(WristInverse, findsRandomPosturesAgainUnderTheirOwnBranch) {
  int compared = 0;
  for (int i = 0; i < kPostures; ++i) {
    const Pose tool = tools.next();
    const WristArm wrist_arm(arm, tool);
    const JointVector joints = postures.next();
    const auto found =
        wrist_arm.solve(wristOf(joints), originOf(arm, tool, joints), wrist_arm.branchOf(joints), joints);
    ASSERT_TRUE(found) << joints.transpose();
    ASSERT_LT((originOf(arm, tool, *found) - originOf(arm, tool, joints)).norm(), 1e-9);
    if (clearance(wrist_arm, joints) > kClearOfSingularities) {
      ASSERT_LT((*found - joints).cwiseAbs().maxCoeff(), 1e-9) << joints.transpose();
      ++compared;
    }
  }
  EXPECT_GT(compared, kPostures * 95 / 100);
}

TEST_P(WristInverse, reachesTheOriginWithEverySolutionAndNoTwoAreOfOneBranch) {
  for (int i = 0; i < kPostures; ++i) {
    const Pose tool = tools.next();
    const WristArm wrist_arm(arm, tool);
    const JointVector joints = postures.next();
    const Vector3d origin = originOf(arm, tool, joints);
    const auto solutions = wrist_arm.solutions(wristOf(joints), origin);
    ASSERT_EQ(solutions.size(), 4U);
    for (const auto& solution : solutions) {
      ASSERT_LT((originOf(arm, tool, solution.joints) - origin).norm(), 1e-9);
      ASSERT_EQ(wristOf(solution.joints), wristOf(joints));
      ASSERT_LE(solution.joints.head<3>().maxCoeff(), kPi);
      ASSERT_GT(solution.joints.head<3>().minCoeff(), -kPi);
      ASSERT_EQ(withBranch(solutions, solution.branch), &solution);
      if (clearance(wrist_arm, solution.joints) > kClearOfSingularities) {
        ASSERT_EQ(wrist_arm.branchOf(solution.joints), solution.branch);
      }
    }
  }
}

TEST_P(WristInverse, choosesTheTurnsNearestToTheReferenceWhateverTheLimits) {
  for (int i = 0; i < kPostures; ++i) {
    const JointVector joints = postures.next();
    const WristArm wrist_arm(arm, Pose::Identity());
    if (clearance(wrist_arm, joints) < kClearOfSingularities) {
      continue;
    }
    JointVector reference = joints;
    reference.head<3>() += Vector3d(2 * kPi, -4 * kPi, 2 * kPi);
    const auto found = wrist_arm.solve(wristOf(joints), originOf(arm, Pose::Identity(), joints),
                                       wrist_arm.branchOf(joints), reference);
    ASSERT_TRUE(found);
    ASSERT_LT((*found - reference).cwiseAbs().maxCoeff(), 1e-9);
  }
}

/// Both solutions of the other sign come close only at a singularity: the way never has to choose.
TEST_P(WristInverse, keepsItsBranchAlongStraightWaysThatAvoidTheSingularities) {
  constexpr int kSteps = 500;
  int whole = 0;
  for (int way = 0; way < 300; ++way) {
    const Pose tool = tools.next();
    const WristArm wrist_arm(arm, tool);
    const JointVector start = postures.next();
    const JointVector target = postures.next();
    const Vector3d from = originOf(arm, tool, start);
    const Vector3d to = originOf(arm, tool, target);
    const WristBranch branch = wrist_arm.branchOf(start);
    JointVector here = start;
    for (int step = 1; step <= kSteps; ++step) {
      const double share = static_cast<double>(step) / kSteps;
      const Vector3d wrist = (1 - share) * wristOf(start) + share * wristOf(target);
      const Vector3d origin = (1 - share) * from + share * to;
      const auto next = wrist_arm.solve(wrist, origin, branch, here);
      const auto distance = next ? wrist_arm.singularityDistance(*next) : WristSingularityDistance{};
      // A short forearm, too, turns joint 3 by a lot in a step.
      if (distance.shoulder < 0.1 || distance.elbow < 0.2 || hangingOf(arm, tool, *next).length < 0.1) {
        break;
      }
      ASSERT_EQ(wrist_arm.branchOf(*next), branch);
      for (const auto& other : wrist_arm.solutions(wrist, origin)) {
        ASSERT_TRUE(other.branch == branch ||
                    turnlessDifference(other.joints, here) > turnlessDifference(*next, here))
            << "a jump from " << here.transpose() << " to " << next->transpose();
      }
      here = *next;
      whole += step == kSteps ? 1 : 0;
    }
  }
  EXPECT_GT(whole, 10) << "too few ways came to their end to tell anything";
}

TEST_P(WristInverse, hasNoSolutionBeyondItsReachAndFourWithinIt) {
  constexpr double kStep = 1e-9;
  for (int i = 0; i < kPostures; ++i) {
    const Pose tool = tools.next();
    const WristArm wrist_arm(arm, tool);
    const JointVector joints = postures.next();
    const Hanging hanging = hangingOf(arm, tool, joints);
    const double stretched = arm.lengths().a2 + hanging.length;
    const double folded = std::abs(arm.lengths().a2 - hanging.length);
    const auto count = [&](double distance) {
      const double height = std::min(distance, folded) * 0.5;
      const Vector3d in_plane(std::sqrt(distance * distance - height * height), hanging.across,
                              arm.lengths().d1 + height);
      const Vector3d origin = Eigen::AngleAxisd(joints[0], Vector3d::UnitZ()) * in_plane;
      return wrist_arm.solutions(wristOf(joints), origin).size();
    };
    ASSERT_EQ(count(stretched + kStep), 0U);
    ASSERT_EQ(count(stretched - kStep), 4U);
    ASSERT_EQ(count(folded + kStep), 4U);
    if (folded > kStep) {
      ASSERT_EQ(count(folded - kStep), 0U);
    }
  }
}

TEST_P(WristInverse, hasNoSolutionInTheCylinderAroundAxis1) {
  constexpr double kStep = 1e-9;
  for (int i = 0; i < kPostures; ++i) {
    const Pose tool = tools.next();
    const WristArm wrist_arm(arm, tool);
    const JointVector joints = postures.next();
    const Hanging hanging = hangingOf(arm, tool, joints);
    const auto count = [&](double radius) {
      const Vector3d origin(radius * std::cos(joints[0]), radius * std::sin(joints[0]),
                            arm.lengths().d1 + std::max(arm.lengths().a2, hanging.length));
      return wrist_arm.solutions(wristOf(joints), origin).size();
    };
    ASSERT_EQ(count(std::abs(hanging.across) + kStep), 4U);
    if (std::abs(hanging.across) > kStep) {
      ASSERT_EQ(count(std::abs(hanging.across) - kStep), 0U);
    }
  }
}

TEST_P(WristInverse, tellsHowFarThePostureIsFromBothSingularities) {
  for (int i = 0; i < kPostures; ++i) {
    const Pose tool = tools.next();
    const WristArm wrist_arm(arm, tool);
    const JointVector joints = postures.next();
    const auto distance = wrist_arm.singularityDistance(joints);
    const Vector3d x1(std::cos(joints[0]), std::sin(joints[0]), 0);
    ASSERT_NEAR(distance.shoulder, std::abs(originOf(arm, tool, joints).dot(x1)), 1e-12);
    ASSERT_NEAR(distance.elbow, std::abs(std::sin(joints[2] + hangingOf(arm, tool, joints).delta)), 1e-12);
  }
}

TEST_P(WristInverse, isAtAnElbowSingularityWithTheArmStretchedOrFolded) {
  for (int i = 0; i < 1000; ++i) {
    const Pose tool = tools.next();
    const WristArm wrist_arm(arm, tool);
    JointVector joints = postures.next();
    for (const double bend : {0.0, kPi}) {
      joints[2] = bend - hangingOf(arm, tool, joints).delta;
      EXPECT_LT(wrist_arm.singularityDistance(joints).elbow, 1e-14);
      const auto meeting = wrist_arm.solutions(wristOf(joints), originOf(arm, tool, joints));
      ASSERT_EQ(meeting.size(), 4U);
      EXPECT_LT(turnlessDifference(meeting[0].joints, meeting[1].joints), 1e-4);
    }
  }
}

TEST_P(WristInverse, isAtAShoulderSingularityWithTheOriginBesideAxis1) {
  for (int i = 0; i < 1000; ++i) {
    const Pose tool = tools.next();
    const WristArm wrist_arm(arm, tool);
    JointVector joints = postures.next();
    joints[1] = 0;
    const Vector3d upright = originOf(arm, tool, joints) - Vector3d(0, 0, arm.lengths().d1);
    const Vector3d x1(std::cos(joints[0]), std::sin(joints[0]), 0);
    joints[1] = -std::atan2(upright.dot(x1), upright.z());
    EXPECT_LT(wrist_arm.singularityDistance(joints).shoulder, 1e-14);
    const Vector3d origin = originOf(arm, tool, joints);
    const auto found = wrist_arm.solve(wristOf(joints), origin, wrist_arm.branchOf(joints), joints);
    ASSERT_TRUE(found);
    EXPECT_LT((originOf(arm, tool, *found) - origin).norm(), 1e-9);
  }
}

class WristInverseOfATm5 : public ::testing::Test {
 protected:
  const ArmModel arm = model("tm5-900");
  const WristArm wrist_arm{arm, Pose::Identity()};

  [[nodiscard]] Vector3d origin(const JointVector& joints) const {
    return originOf(arm, Pose::Identity(), joints);
  }
  /// Straight, and with the joints 4 to 6 in step, as far as `share` of the way.
  [[nodiscard]] std::optional<JointVector> onTheWay(const JointVector& start, const Vector3d& shift,
                                                    const Vector3d& wrist, double share) const {
    return wrist_arm.solve((1 - share) * wristOf(start) + share * wrist, origin(start) + share * shift,
                           wrist_arm.branchOf(start), start);
  }
};

TEST_F(WristInverseOfATm5, passesAStraightWristOnItsWay) {
  const JointVector start = toJointVector({0, 0, 90, 0, 30, 0});
  const Vector3d shift(0, 0.2, 0);
  const Vector3d wrist(0, degToRad(-30), 0);
  const auto half_way = onTheWay(start, shift, wrist, 0.5);
  const auto end = onTheWay(start, shift, wrist, 1);
  ASSERT_TRUE(half_way && end);
  expectJoints(*half_way, {13.2200, -5.1230, 101.2085, 0, 0, 0});
  EXPECT_NEAR(origin(*half_way).y(), -0.120291, 5e-7);
  expectJoints(*end, {22.9278, -6.5706, 108.7367, 0, -30, 0});
  EXPECT_EQ(poseBitsOf(arm, start), (PoseBits{Shoulder::Righty, Elbow::Above, Wrist::NoFlip}));
  EXPECT_EQ(poseBitsOf(arm, *end), (PoseBits{Shoulder::Righty, Elbow::Above, Wrist::Flip}));
  EXPECT_EQ(wrist_arm.branchOf(*end), wrist_arm.branchOf(start));
}

TEST_F(WristInverseOfATm5, hasFourSolutionsForAPlace) {
  const JointVector start = toJointVector({0, 0, 90, 0, 30, 0});
  const auto solutions =
      wrist_arm.solutions(Vector3d(0, degToRad(-30), 0), origin(start) + Vector3d(0, 0.2, 0));
  ASSERT_EQ(solutions.size(), 4U);
  const auto expect = [&](const WristBranch& branch, const ControllerJoints& joints_deg) {
    const auto* const found = withBranch(solutions, branch);
    ASSERT_NE(found, nullptr);
    expectJoints(found->joints, joints_deg);
  };
  expect({true, true}, {22.9278, -6.5706, 108.7367, 0, -30, 0});
  expect({true, false}, {22.9278, 109.6312, -96.2587, 0, -30, 0});
  expect({false, true}, {152.5814, -109.6312, 108.7367, 0, -30, 0});
  expect({false, false}, {152.5814, 6.5706, -96.2587, 0, -30, 0});
}

TEST_F(WristInverseOfATm5, staysUprightWhileJoint6TurnsOnceAround) {
  const JointVector start = toJointVector({0, 0, 90, 0, 90, -180});
  const Vector3d shift(0, 0, 0.1);
  const Vector3d wrist(0, degToRad(90), degToRad(180));
  const auto half_way = onTheWay(start, shift, wrist, 0.5);
  const auto end = onTheWay(start, shift, wrist, 1);
  ASSERT_TRUE(half_way && end);
  expectJoints(*half_way, {0, -1.1297, 85.6338, 0, 90, 0});
  expectJoints(*end, {0, -1.6118, 80.6824, 0, 90, 180});
  for (const JointVector& joints : {*half_way, *end}) {
    EXPECT_LT((origin(joints) - origin(start)).head<2>().norm(), 1e-12);
  }
}

TEST_F(WristInverseOfATm5, countsNoWristSingularity) {
  for (const double joint_5 : {0.0, 180.0}) {
    const JointVector joints = toJointVector({30, -20, 100, 10, joint_5, -45});
    EXPECT_GT(clearance(wrist_arm, joints), 0.1);
    const auto found = wrist_arm.solve(wristOf(joints), origin(joints), wrist_arm.branchOf(joints), joints);
    ASSERT_TRUE(found);
    EXPECT_LT((*found - joints).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST_F(WristInverseOfATm5, hasNoSolutionForAnOriginOnAxis3AsJoint3DoesNotMatter) {
  const JointVector joints = toJointVector({30, -20, 100, 10, 80, -45});
  JointVector elbow = joints;
  elbow.head<3>() << 0, 0, 0;
  Pose tool = Pose::Identity();
  tool.translation() = forwardKinematics(arm, elbow).inverse() *
                       Vector3d(0, arm.lengths().d4, arm.lengths().d1 + arm.lengths().a2);
  const WristArm short_arm(arm, tool);
  EXPECT_EQ(short_arm.singularityDistance(joints).elbow, 0);
  EXPECT_TRUE(short_arm.solutions(wristOf(joints), originOf(arm, tool, joints)).empty());
}

TEST_F(WristInverseOfATm5, keepsJoint1OfTheReferenceForAnOriginOnAxis1) {
  JointVector joints = toJointVector({0, -20, 100, 10, 80, -45});
  Pose tool = Pose::Identity();
  tool.translation() = forwardKinematics(arm, joints).inverse() * Vector3d(0, 0, 0.7);
  joints[0] = 1.234;
  const WristArm wrist_on_axis_1(arm, tool);
  const auto found = wrist_on_axis_1.solve(wristOf(joints), Vector3d(0, 0, 0.7), {true, true}, joints);
  ASSERT_TRUE(found);
  EXPECT_EQ((*found)[0], 1.234);
  EXPECT_LT((originOf(arm, tool, *found) - Vector3d(0, 0, 0.7)).norm(), 1e-9);
}

TEST_F(WristInverseOfATm5, hasNoSolutionWhereANumberIsNotFinite) {
  const JointVector good = toJointVector({30, -20, 100, 10, 80, -45});
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity(), 1e308, -1e308}) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      Vector3d place = origin(good);
      place[i] = bad;
      EXPECT_TRUE(wrist_arm.solutions(wristOf(good), place).empty());
      EXPECT_FALSE(wrist_arm.solve(wristOf(good), place, {true, true}, good));
      if (!std::isfinite(bad)) {
        Vector3d wrist = wristOf(good);
        wrist[i] = bad;
        EXPECT_TRUE(wrist_arm.solutions(wrist, origin(good)).empty());
        JointVector reference = good;
        reference[i] = bad;
        EXPECT_FALSE(wrist_arm.solve(wristOf(good), origin(good), {true, true}, reference));
      }
    }
  }
}

}  // namespace
}  // namespace cobot_command::arm
