#include "cobot_command/arm/arm_model.h"

#include <limits>

#include "arm_test_support.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include "cobot_command/arm/any_arm.h"

namespace cobot_command::arm {
namespace {

struct DataSheet {
  const char* name;
  DhLengths mm;
  std::array<double, 6> limit_deg;  ///< to both sides
  std::array<double, 6> speed_deg;  ///< per second
  Ratings ratings;
};

const std::vector<DataSheet> data_sheets = {
    {"tm5-700",
     {145.2, 329.0, 311.5, -122.3, 106.0, 113.15},
     {270, 180, 155, 180, 180, 270},
     {180, 180, 180, 225, 225, 225},
     {6, 0.7, 1.1}},
    {"tm5-900",
     {145.2, 429.0, 411.5, -122.3, 106.0, 113.15},
     {270, 180, 155, 180, 180, 270},
     {180, 180, 180, 225, 225, 225},
     {4, 0.9, 1.4}},
    {"tm12",
     {165.2, 636.1, 557.9, -156.3, 106.0, 113.15},
     {270, 180, 166, 180, 180, 270},
     {120, 120, 180, 180, 180, 180},
     {12, 1.3, 1.3}},
    {"tm14",
     {165.2, 536.1, 457.9, -156.3, 106.0, 113.15},
     {270, 180, 163, 180, 180, 270},
     {120, 120, 180, 150, 150, 180},
     {14, 1.1, 1.1}},
    {"tm12s",
     {165.2, 636.1, 532.4, -181.8, 131.5, 134.95},
     {360, 360, 162, 360, 360, 360},
     {160, 160, 240, 260, 260, 520},
     {12, 1.3, 1.3}},
    {"tm14s",
     {165.2, 536.1, 432.4, -181.8, 131.5, 134.95},
     {360, 360, 159, 360, 360, 360},
     {160, 160, 240, 260, 260, 520},
     {14, 1.1, 1.1}},
};

TEST(ArmModel, knowsTheSixModelsOfTheFamily) {
  EXPECT_THAT(ArmModel::knownNames(),
              ::testing::ElementsAre("tm5-700", "tm5-900", "tm12", "tm14", "tm12s", "tm14s"));
}

TEST(ArmModel, everyModelHasTheLengthsOfItsDataSheet) {
  for (const DataSheet& sheet : data_sheets) {
    SCOPED_TRACE(sheet.name);
    const DhLengths found = model(sheet.name).lengths();
    EXPECT_NEAR(found.d1, mmToM(sheet.mm.d1), 1e-12);
    EXPECT_NEAR(found.a2, mmToM(sheet.mm.a2), 1e-12);
    EXPECT_NEAR(found.a3, mmToM(sheet.mm.a3), 1e-12);
    EXPECT_NEAR(found.d4, mmToM(sheet.mm.d4), 1e-12);
    EXPECT_NEAR(found.d5, mmToM(sheet.mm.d5), 1e-12);
    EXPECT_NEAR(found.d6, mmToM(sheet.mm.d6), 1e-12);
  }
}

TEST(ArmModel, everyModelHasTheLimitsAndRatingsOfItsDataSheet) {
  for (const DataSheet& sheet : data_sheets) {
    SCOPED_TRACE(sheet.name);
    const ArmModel arm = model(sheet.name);
    EXPECT_EQ(arm.name(), sheet.name);
    for (std::size_t i = 0; i < kJointCount; ++i) {
      EXPECT_NEAR(radToDeg(arm.limits()[i].lower), -sheet.limit_deg[i], 1e-9);
      EXPECT_NEAR(radToDeg(arm.limits()[i].upper), sheet.limit_deg[i], 1e-9);
      EXPECT_NEAR(radToDeg(arm.limits()[i].max_velocity), sheet.speed_deg[i], 1e-9);
    }
    EXPECT_EQ(arm.ratings().payload, sheet.ratings.payload);
    EXPECT_EQ(arm.ratings().reach, sheet.ratings.reach);
    EXPECT_EQ(arm.ratings().max_tcp_speed, sheet.ratings.max_tcp_speed);
  }
}

TEST(ArmModel, everyModelNamesItsJointsAsTheVendorsDriverDoes) {
  for (const std::string& name : ArmModel::knownNames()) {
    const ArmModel arm = model(name);
    EXPECT_THAT(arm.jointNames(),
                ::testing::ElementsAre("shoulder_1_joint", "shoulder_2_joint", "elbow_joint", "wrist_1_joint",
                                       "wrist_2_joint", "wrist_3_joint"));
    EXPECT_EQ(arm.chain().getNrOfJoints(), 6U);
  }
}

TEST(ArmModel, refusesAnUnknownNameWithTheKnownOnes) {
  const auto unknown = ArmModel::named("tm99");
  ASSERT_FALSE(unknown);
  EXPECT_THAT(unknown.error().message, ::testing::AllOf(::testing::HasSubstr("\"tm99\""),
                                                        ::testing::HasSubstr("tm5-700, tm5-900, tm12")));
}

TEST(ArmModel, namesTheFirstJointOutsideItsLimits) {
  const ArmModel arm = model("tm5-900");
  EXPECT_EQ(arm.firstJointOutsideLimits(toJointVector({270, -180, 155, 180, -180, -270})), -1);
  EXPECT_EQ(arm.firstJointOutsideLimits(toJointVector({0, 0, 155.001, 0, 181, 0})), 2);
  EXPECT_EQ(arm.firstJointOutsideLimits(toJointVector({0, 0, 0, 0, 0, -270.001})), 5);
}

TEST(ArmModel, toleratesRoundingAtALimitButNotMore) {
  const ArmModel arm = model("tm5-900");
  JointVector joints = JointVector::Zero();
  joints[2] = arm.limits()[2].upper + 0.9e-9;
  EXPECT_EQ(arm.firstJointOutsideLimits(joints), -1);
  joints[2] = arm.limits()[2].upper + 1.1e-9;
  EXPECT_EQ(arm.firstJointOutsideLimits(joints), 2);
}

TEST(ArmModel, aJointThatIsNotANumberIsOutsideItsLimits) {
  const ArmModel arm = model("tm5-900");
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity(), 1e308}) {
    JointVector joints = JointVector::Zero();
    joints[3] = bad;
    EXPECT_EQ(arm.firstJointOutsideLimits(joints), 3);
  }
}

TEST(Urdf, everyMovingLinkHasABodyAndAMassThatCanExist) {
  for (const std::string& name : ArmModel::knownNames()) {
    const auto urdf = urdf::parseURDF(ArmModel::urdfOf(name));
    ASSERT_NE(urdf, nullptr) << name;
    EXPECT_EQ(urdf->getName(), name);
    EXPECT_EQ(urdf->getRoot()->name, "base");
    EXPECT_NE(urdf->getLink("tool0"), nullptr);
    for (int i = 0; i <= 6; ++i) {
      const auto link = urdf->getLink("link_" + std::to_string(i));
      ASSERT_NE(link, nullptr) << name << i;
      EXPECT_FALSE(link->visual_array.empty());
      EXPECT_FALSE(link->collision_array.empty());
      ASSERT_NE(link->inertial, nullptr);
      const auto& inertial = *link->inertial;
      EXPECT_GT(inertial.mass, 0);
      // No moment of inertia of a body exceeds the sum of the two others.
      const double sum = inertial.ixx + inertial.iyy + inertial.izz;
      const double largest = std::max({inertial.ixx, inertial.iyy, inertial.izz});
      EXPECT_GT(std::min({inertial.ixx, inertial.iyy, inertial.izz}), 0);
      EXPECT_LE(2 * largest, sum);
    }
  }
}

TEST(AnyArm, goesAsFarAndAsFastAsEveryKnownOne) {
  for (const std::string& name : ArmModel::knownNames()) {
    const ArmModel known = *ArmModel::named(name);
    for (std::size_t i = 0; i < kJointCount; ++i) {
      EXPECT_LE(anyArm().limits()[i].lower, known.limits()[i].lower) << name;
      EXPECT_GE(anyArm().limits()[i].upper, known.limits()[i].upper) << name;
      EXPECT_GE(anyArm().limits()[i].max_velocity, known.limits()[i].max_velocity) << name;
    }
  }
  EXPECT_NEAR(anyArm().limits()[0].max_velocity, degToRad(180), 1e-12);
  EXPECT_NEAR(anyArm().limits()[5].max_velocity, degToRad(520), 1e-12);
}

}  // namespace
}  // namespace cobot_command::arm
