#include <limits>

#include "arm_test_support.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::arm {
namespace {

using ::testing::HasSubstr;
using Reason = IkRefusal::Reason;

constexpr PoseBits kRightyAboveNoFlip{};
constexpr ControllerJoints kReady = {0, 0, 90, 0, 90, 0};

class NearestTurn : public ::testing::Test {
 protected:
  /// In degrees; empty when there is none.
  std::vector<double> turned(const ControllerJoints& joints, const ControllerJoints& reference,
                             const char* name = "tm5-900") {
    const auto result = nearestTurn(model(name), toJointVector(joints), toJointVector(reference));
    if (!result) return {};
    const ControllerJoints degrees = toControllerJoints(*result);
    return {degrees.begin(), degrees.end()};
  }
};

#define EXPECT_JOINTS(actual, ...) \
  EXPECT_THAT(actual, ::testing::Pointwise(::testing::DoubleNear(1e-9), ControllerJoints{__VA_ARGS__}))

TEST_F(NearestTurn, keepsWhatIsNearestAlready) {
  EXPECT_JOINTS(turned({10, 20, 30, 40, 50, 60}, {0, 0, 0, 0, 0, 0}), 10, 20, 30, 40, 50, 60);
}

TEST_F(NearestTurn, choosesTheNearestTurnOfTheJointsThatHaveMoreThanOne) {
  EXPECT_JOINTS(turned({-170, 0, 90, 0, 90, 100}, {180, 0, 90, 0, 90, -200}), 190, 0, 90, 0, 90, -260);
  EXPECT_JOINTS(turned({-170, 0, 90, 0, 90, 100}, {-100, 0, 90, 0, 90, 250}), -170, 0, 90, 0, 90, 100);
}

TEST_F(NearestTurn, staysInsideTheLimitsThoughAnotherTurnWereNearer) {
  // 80 + 360 is nearest to 270 + a bit, but joint 1 ends at 270.
  EXPECT_JOINTS(turned({80, 0, 90, 0, 90, 0}, {268, 0, 90, 0, 90, 0}), 80, 0, 90, 0, 90, 0);
  EXPECT_JOINTS(turned({0, -170, 90, 0, 90, 0}, {0, 180, 90, 0, 90, 0}), 0, -170, 90, 0, 90, 0);
}

TEST_F(NearestTurn, bringsAJointBackFromFarOutside) {
  EXPECT_JOINTS(turned({730, 0, 90, -350, 90, 0}, {0, 0, 90, 0, 90, 0}), 10, 0, 90, 10, 90, 0);
}

TEST_F(NearestTurn, canTurnEveryJointOfTheSSeriesButTheElbow) {
  EXPECT_JOINTS(turned({-100, -100, 90, 100, 100, 100}, {250, 250, 90, -250, -250, -250}, "tm12s"), 260, 260,
                90, -260, -260, -260);
}

TEST_F(NearestTurn, isNothingWhenAJointHasNoTurnInsideItsLimits) {
  EXPECT_TRUE(turned({0, 0, 156, 0, 90, 0}, kReady).empty());
  EXPECT_TRUE(turned({0, 0, -160, 0, 90, 0}, kReady).empty());
}

TEST_F(NearestTurn, allowsAJointExactlyAtItsLimit) {
  EXPECT_JOINTS(turned({0, 180, 155, -180, 90, 0}, kReady), 0, 180, 155, -180, 90, 0);
}

TEST_F(NearestTurn, isNothingForWhatIsNotFinite) {
  const ArmModel arm = model("tm5-900");
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const JointVector good = toJointVector(kReady);
    JointVector broken = good;
    broken[1] = bad;
    EXPECT_FALSE(nearestTurn(arm, broken, good));
  }
}

class PostureFor : public ::testing::Test {
 protected:
  Result<JointVector, IkRefusal> posture(const Pose& flange, const PoseBits& bits) {
    return postureFor(arm, flange, bits, toJointVector(kReady));
  }
  Pose flangeAt(const ControllerJoints& joints) { return forwardKinematics(arm, toJointVector(joints)); }

  const ArmModel arm = model("tm5-900");
};

TEST_F(PostureFor, givesThePostureWithTheWantedBits) {
  const Pose flange = flangeAt({30, -20, 100, 10, 80, -45});
  for (const Branch& branch : allBranches(arm, flange)) {
    const auto found = posture(flange, branch.bits);
    ASSERT_TRUE(found);
    EXPECT_EQ(poseBitsOf(arm, *found), branch.bits);
    EXPECT_LT(difference(forwardKinematics(arm, *found), flange), 1e-12);
  }
}

TEST_F(PostureFor, takesTheTurnNearestToTheReference) {
  const JointVector joints = toJointVector({200, -20, 100, 10, 80, -260});
  const auto found = postureFor(arm, forwardKinematics(arm, joints), poseBitsOf(arm, joints), joints);
  ASSERT_TRUE(found);
  EXPECT_LT((*found - joints).cwiseAbs().maxCoeff(), 1e-12);
}

TEST_F(PostureFor, refusesAPoseOutOfReachWithDistances) {
  const auto refused = posture(toPose({1200, 0, 500, 180, 0, 90}), kRightyAboveNoFlip);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().reason, Reason::OutOfReach);
  EXPECT_EQ(refused.error().joint, -1);
  EXPECT_THAT(refused.error().message, ::testing::AllOf(HasSubstr("X 1200.00"), HasSubstr("at most 954.37")));
}

TEST_F(PostureFor, refusesBitsThatThePoseDoesNotAllowAndNamesThePossibleOnes) {
  // Arm nearly straight forward, wrist bent outwards: turned the other way the wrist does not reach.
  const ControllerJoints stretched = {0, 90, 1, 0, 90, 0};
  const Pose flange = flangeAt(stretched);
  const Branches branches = allBranches(arm, flange);
  ASSERT_FALSE(branches.empty());
  ASSERT_LT(branches.size(), 8U);
  int refusals = 0;
  for (const int config1 : {0, 1}) {
    for (const int config2 : {2, 3}) {
      for (const int config3 : {4, 5}) {
        const PoseBits bits = *PoseBits::fromNumbers(config1, config2, config3);
        if (branchWith(branches, bits) != nullptr) continue;
        const auto refused = posture(flange, bits);
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().reason, Reason::BitsNotPossible);
        EXPECT_THAT(refused.error().message,
                    ::testing::AllOf(HasSubstr(toString(bits)), HasSubstr(toString(branches[0].bits))));
        ++refusals;
      }
    }
  }
  EXPECT_EQ(refusals, 8 - static_cast<int>(branches.size()));
}

TEST_F(PostureFor, namesTheJointThatWouldLeaveItsLimits) {
  const JointVector folded = toJointVector({30, 20, 160, 10, 80, -45});
  const auto refused = posture(forwardKinematics(arm, folded), poseBitsOf(arm, folded));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().reason, Reason::OutsideLimits);
  EXPECT_EQ(refused.error().joint, 2);
  EXPECT_THAT(refused.error().message,
              ::testing::AllOf(HasSubstr("Joint 3"), HasSubstr("160.000"), HasSubstr("-155.000 to 155.000")));
}

TEST_F(PostureFor, refusesWhatIsNotFiniteOrNotAPose) {
  const Pose good = flangeAt(kReady);
  Pose not_finite = good;
  not_finite.translation().x() = std::numeric_limits<double>::quiet_NaN();
  Pose huge = good;
  huge.linear()(0, 0) = 1e308;
  Pose mirrored = good;
  mirrored.linear().col(2) *= -1;
  for (const Pose& bad : {not_finite, huge, mirrored}) {
    const auto refused = posture(bad, kRightyAboveNoFlip);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().reason, Reason::NotFinite);
  }
  JointVector reference = toJointVector(kReady);
  reference[5] = std::numeric_limits<double>::infinity();
  const auto refused = postureFor(arm, good, kRightyAboveNoFlip, reference);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().reason, Reason::NotFinite);
}

TEST_F(PostureFor, refusesAFinitePoseThatIsTooFarToSquareAsOutOfReach) {
  Pose far = flangeAt(kReady);
  far.translation().y() = -1e308;
  const auto refused = posture(far, kRightyAboveNoFlip);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().reason, Reason::OutOfReach);
}

}  // namespace
}  // namespace cobot_command::arm
