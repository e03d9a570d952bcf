#include "cobot_command/arm/pose_bits.h"

#include "arm_test_support.h"
#include <gtest/gtest.h>

namespace cobot_command::arm {
namespace {

PoseBits bitsAt(const ControllerJoints& joints) {
  return poseBitsOf(model("tm5-900"), toJointVector(joints));
}

TEST(PoseBits, areTheNumbersOfAScript) {
  for (const int config1 : {0, 1}) {
    for (const int config2 : {2, 3}) {
      for (const int config3 : {4, 5}) {
        const auto bits = PoseBits::fromNumbers(config1, config2, config3);
        ASSERT_TRUE(bits);
        EXPECT_EQ(bits->numbers(), (std::array<int, 3>{config1, config2, config3}));
      }
    }
  }
}

TEST(PoseBits, refuseNumbersThatNoScriptHas) {
  EXPECT_FALSE(PoseBits::fromNumbers(2, 2, 4));
  EXPECT_FALSE(PoseBits::fromNumbers(-1, 2, 4));
  EXPECT_FALSE(PoseBits::fromNumbers(0, 1, 4));
  EXPECT_FALSE(PoseBits::fromNumbers(0, 4, 4));
  EXPECT_FALSE(PoseBits::fromNumbers(0, 2, 3));
  EXPECT_FALSE(PoseBits::fromNumbers(0, 2, 6));
  EXPECT_FALSE(PoseBits::fromNumbers(4, 2, 0));
}

TEST(PoseBits, areWrittenAsPeopleSayThem) {
  EXPECT_EQ(toString({Shoulder::Righty, Elbow::Above, Wrist::NoFlip}), "RIGHTY ABOVE NOFLIP");
  EXPECT_EQ(toString({Shoulder::Lefty, Elbow::Below, Wrist::Flip}), "LEFTY BELOW FLIP");
}

TEST(PoseBits, differWhenOneOfThemDiffers) {
  const PoseBits bits{Shoulder::Righty, Elbow::Above, Wrist::NoFlip};
  EXPECT_EQ(bits, PoseBits{});
  EXPECT_NE(bits, (PoseBits{Shoulder::Lefty, Elbow::Above, Wrist::NoFlip}));
  EXPECT_NE(bits, (PoseBits{Shoulder::Righty, Elbow::Below, Wrist::NoFlip}));
  EXPECT_NE(bits, (PoseBits{Shoulder::Righty, Elbow::Above, Wrist::Flip}));
}

// Table of the manual's appendix: with Config1 = 1 the signs of J3 and J5 change their meaning.
TEST(PoseBits, followTheSignsOfTheManual) {
  const PoseBits righty = bitsAt({0, 45, 90, 0, 90, 0});
  EXPECT_EQ(righty, (PoseBits{Shoulder::Righty, Elbow::Above, Wrist::NoFlip}));
  EXPECT_EQ(bitsAt({0, 90, -90, 0, 90, 0}).elbow, Elbow::Below);
  EXPECT_EQ(bitsAt({0, 45, 90, 0, -90, 0}).wrist, Wrist::Flip);
  const PoseBits lefty = bitsAt({0, -45, -90, 0, -90, 0});
  EXPECT_EQ(lefty, (PoseBits{Shoulder::Lefty, Elbow::Above, Wrist::NoFlip}));
  EXPECT_EQ(bitsAt({0, -90, 90, 0, -90, 0}).elbow, Elbow::Below);
  EXPECT_EQ(bitsAt({0, -45, -90, 0, 90, 0}).wrist, Wrist::Flip);
}

TEST(PoseBits, fallToTheElseBranchOfTheManualOnASingularity) {
  EXPECT_EQ(bitsAt({0, 0, 0, 0, 0, 0}), (PoseBits{Shoulder::Lefty, Elbow::Below, Wrist::Flip}));
  EXPECT_EQ(bitsAt({0, 45, 0, 0, 90, 0}).elbow, Elbow::Below);
  EXPECT_EQ(bitsAt({0, 45, 90, 0, 0, 0}).wrist, Wrist::Flip);
}

TEST(PoseBits, doNotChangeWithWholeTurns) {
  const ArmModel arm = model("tm12s");
  const PoseBits bits = poseBitsOf(arm, toJointVector({0, 45, 90, 0, -90, 0}));
  EXPECT_EQ(poseBitsOf(arm, toJointVector({360, -315, 90, 360, 270, -360})), bits);
}

// D of the manual: the direction of the shoulder's offset, and A + B + C: from the shoulder to the wrist
// centre.
TEST(PoseBits, theFirstIsTheManualsCrossProduct) {
  for (const std::string& name : ArmModel::knownNames()) {
    const ArmModel arm = model(name);
    RandomPostures postures(arm);
    for (int i = 0; i < 2000; ++i) {
      const JointVector joints = postures.next();
      const Pose flange = forwardKinematics(arm, joints);
      const Eigen::Vector3d centre = flange.translation() - arm.lengths().d6 * flange.linear().col(2);
      const Eigen::Vector2d d(std::sin(joints[0]), -std::cos(joints[0]));
      const Eigen::Vector2d abc = centre.head<2>() + arm.lengths().d4 * d;  // without the offset itself
      const double cross = abc.x() * d.y() - abc.y() * d.x();
      ASSERT_EQ(poseBitsOf(arm, joints).shoulder, cross < 0 ? Shoulder::Righty : Shoulder::Lefty);
    }
  }
}

}  // namespace
}  // namespace cobot_command::arm
