// The vectors of TM 2.3, 4.4, 5.1 and 5.2: numbers that were computed or
// recorded by others than this code.
#include <array>
#include <string>
#include <vector>

#include "arm_test_support.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::arm {
namespace {

using std::array;

struct ForwardVector {
  const char* model;
  ControllerJoints joints;
  ControllerPose pose;
  array<int, 3> bits;
};

// clang-format off
const std::vector<ForwardVector> forward_vectors = {
    {"tm5-700", {0, 0, 0, 0, 0, 0}, {0.000, -235.450, 891.700, 90.000, 0.000, 0.000}, {1, 3, 5}},
    {"tm5-700", {0, 0, 90, 0, 90, 0}, {417.500, -122.300, 361.050, 180.000, 0.000, 90.000}, {0, 2, 4}},
    {"tm5-700", {0, 0, 90, -90, 90, 0}, {424.650, -122.300, 580.200, 90.000, 0.000, 90.000}, {0, 2, 4}},
    {"tm5-700", {-90, 0, 90, 0, 90, 0}, {-122.300, -417.500, 361.050, 180.000, 0.000, 0.000}, {0, 2, 4}},
    {"tm5-700", {90, -35, 125, 0, 90, 0}, {122.300, 228.793, 301.551, 180.000, 0.000, 180.000}, {0, 2, 4}},
    {"tm5-700", {30, -20, 100, 10, 80, -45}, {330.992, 27.191, 397.019, -172.893, 7.053, 165.439}, {0, 2, 4}},
    {"tm5-700", {-120, 25, -60, 40, -70, 150}, {-71.274, 198.548, 813.405, -84.482, -31.595, -12.827}, {1, 2, 4}},
    {"tm5-900", {0, 0, 0, 0, 0, 0}, {0.000, -235.450, 1091.700, 90.000, 0.000, 0.000}, {1, 3, 5}},
    {"tm5-900", {0, 0, 90, 0, 90, 0}, {517.500, -122.300, 461.050, 180.000, 0.000, 90.000}, {0, 2, 4}},
    {"tm5-900", {0, 0, 90, -90, 90, 0}, {524.650, -122.300, 680.200, 90.000, 0.000, 90.000}, {0, 2, 4}},
    {"tm5-900", {-90, 0, 90, 0, 90, 0}, {-122.300, -517.500, 461.050, 180.000, 0.000, 0.000}, {0, 2, 4}},
    {"tm5-900", {90, -35, 125, 0, 90, 0}, {122.300, 271.436, 383.466, 180.000, 0.000, 180.000}, {0, 2, 4}},
    {"tm5-900", {30, -20, 100, 10, 80, -45}, {386.659, 59.330, 508.353, -172.893, 7.053, 165.439}, {0, 2, 4}},
    {"tm5-900", {-120, 25, -60, 40, -70, 150}, {-63.726, 211.622, 985.951, -84.482, -31.595, -12.827}, {1, 2, 4}},
    {"tm12", {0, 0, 0, 0, 0, 0}, {0.000, -269.450, 1465.200, 90.000, 0.000, 0.000}, {1, 3, 5}},
    {"tm12", {0, 0, 90, 0, 90, 0}, {663.900, -156.300, 688.150, 180.000, 0.000, 90.000}, {0, 2, 4}},
    {"tm12", {0, 0, 90, -90, 90, 0}, {671.050, -156.300, 907.300, 90.000, 0.000, 90.000}, {0, 2, 4}},
    {"tm12", {-90, 0, 90, 0, 90, 0}, {-156.300, -663.900, 688.150, 180.000, 0.000, 0.000}, {0, 2, 4}},
    {"tm12", {90, -35, 125, 0, 90, 0}, {156.300, 299.048, 573.113, 180.000, 0.000, 180.000}, {0, 2, 4}},
    {"tm12", {30, -20, 100, 10, 80, -45}, {467.177, 66.557, 748.386, -172.893, 7.053, 165.439}, {0, 2, 4}},
    {"tm12", {-120, 25, -60, 40, -70, 150}, {-94.948, 225.545, 1313.571, -84.482, -31.595, -12.827}, {1, 2, 4}},
    {"tm14", {0, 0, 0, 0, 0, 0}, {0.000, -269.450, 1265.200, 90.000, 0.000, 0.000}, {1, 3, 5}},
    {"tm14", {0, 0, 90, 0, 90, 0}, {563.900, -156.300, 588.150, 180.000, 0.000, 90.000}, {0, 2, 4}},
    {"tm14", {0, 0, 90, -90, 90, 0}, {571.050, -156.300, 807.300, 90.000, 0.000, 90.000}, {0, 2, 4}},
    {"tm14", {-90, 0, 90, 0, 90, 0}, {-156.300, -563.900, 588.150, 180.000, 0.000, 0.000}, {0, 2, 4}},
    {"tm14", {90, -35, 125, 0, 90, 0}, {156.300, 256.406, 491.197, 180.000, 0.000, 180.000}, {0, 2, 4}},
    {"tm14", {30, -20, 100, 10, 80, -45}, {411.510, 34.418, 637.052, -172.893, 7.053, 165.439}, {0, 2, 4}},
    {"tm14", {-120, 25, -60, 40, -70, 150}, {-102.496, 212.472, 1141.025, -84.482, -31.595, -12.827}, {1, 2, 4}},
};
// clang-format on

TEST(RobotVectors, forwardKinematicsGivesEveryListedPoseWithItsBits) {
  ASSERT_EQ(forward_vectors.size(), 28U);
  for (const ForwardVector& vector : forward_vectors) {
    const ArmModel arm = model(vector.model);
    const JointVector joints = toJointVector(vector.joints);
    SCOPED_TRACE(std::string(vector.model) + ::testing::PrintToString(vector.joints));
    EXPECT_THAT(toControllerPose(forwardKinematics(arm, joints)),
                ::testing::Pointwise(::testing::DoubleNear(5.1e-4), vector.pose));
    EXPECT_EQ(poseBitsOf(arm, joints).numbers(), vector.bits);
  }
}

struct ListedBranch {
  array<int, 3> bits;
  ControllerJoints joints;
};

struct InverseTable {
  const char* model;
  ControllerPose pose;
  std::vector<ListedBranch> branches;  ///< the first one defines the pose exactly
};

// clang-format off
const std::vector<InverseTable> inverse_tables = {
    {"tm5-700",
     {417.5, -122.3, 361.05, 180, 0, 90},
     {
         {{0, 2, 4}, {0.0000, 0.0000, 90.0000, 0.0000, 90.0000, 0.0000}},
         {{0, 2, 5}, {0.0000, 43.1401, 30.2710, -163.4111, -90.0000, -180.0000}},
         {{0, 3, 4}, {0.0000, 86.8699, -90.0000, 93.1301, 90.0000, 0.0000}},
         {{0, 3, 5}, {0.0000, 72.5642, -30.2710, -132.2933, -90.0000, -180.0000}},
         {{1, 2, 4}, {147.3458, 0.0000, -90.0000, 0.0000, -90.0000, -32.6542}},
         {{1, 2, 5}, {147.3458, -43.1401, -30.2710, 163.4111, 90.0000, 147.3458}},
         {{1, 3, 4}, {147.3458, -86.8699, 90.0000, -93.1301, -90.0000, -32.6542}},
         {{1, 3, 5}, {147.3458, -72.5642, 30.2710, 132.2933, 90.0000, 147.3458}},
     }},
    {"tm5-700",
     {330.992, 27.191, 397.019, -172.893, 7.053, 165.439},
     {
         {{0, 2, 4}, {30.0000, -20.0000, 100.0000, 10.0000, 80.0000, -45.0000}},
         {{0, 2, 5}, {30.0000, 17.4549, 63.4203, -170.8752, -80.0000, 135.0000}},
         {{0, 3, 4}, {30.0000, 76.2700, -100.0000, 113.7300, 80.0000, -45.0000}},
         {{0, 3, 5}, {30.0000, 78.9409, -63.4203, -105.5206, -80.0000, 135.0000}},
         {{1, 2, 4}, {165.6743, 20.2139, -102.5482, -0.6419, -97.1360, -89.7643}},
         {{1, 2, 5}, {165.6743, -17.7614, -60.5901, 175.3753, 97.1360, 90.2357}},
         {{1, 3, 4}, {165.6743, -78.4314, 102.5482, -107.0930, -97.1360, -89.7643}},
         {{1, 3, 5}, {165.6743, -76.5225, 60.5901, 112.9562, 97.1360, 90.2357}},
     }},
    {"tm5-900",
     {386.659, 59.33, 508.353, -172.893, 7.053, 165.439},
     {
         {{0, 2, 4}, {30.0000, -20.0000, 100.0000, 10.0000, 80.0000, -45.0000}},
         {{0, 2, 5}, {30.0000, 8.3208, 74.6860, -173.0069, -80.0000, 135.0000}},
         {{0, 3, 4}, {30.0000, 77.1572, -100.0000, 112.8428, 80.0000, -45.0000}},
         {{0, 3, 5}, {30.0000, 81.1866, -74.6860, -96.5006, -80.0000, 135.0000}},
         {{1, 2, 4}, {172.9060, 20.1650, -101.6865, -2.4081, -97.9616, -82.5169}},
         {{1, 2, 5}, {172.9060, -8.4502, -72.9614, 177.4821, 97.9616, 97.4831}},
         {{1, 3, 4}, {172.9060, -78.5922, 101.6865, -107.0238, -97.9616, -82.5169}},
         {{1, 3, 5}, {172.9060, -79.6475, 72.9614, 102.7566, 97.9616, 97.4831}},
     }},
    {"tm12",
     {467.177, 66.557, 748.386, -172.893, 7.053, 165.439},
     {
         {{0, 2, 4}, {30.0000, -20.0000, 100.0000, 10.0000, 80.0000, -45.0000}},
         {{0, 2, 5}, {30.0000, -0.9861, 84.9557, -173.9696, -80.0000, 135.0000}},
         {{0, 3, 4}, {30.0000, 71.0739, -100.0000, 118.9261, 80.0000, -45.0000}},
         {{0, 3, 5}, {30.0000, 77.1060, -84.9557, -82.1503, -80.0000, 135.0000}},
         {{1, 2, 4}, {170.7110, 20.1171, -101.2952, -2.4509, -97.7238, -84.7195}},
         {{1, 2, 5}, {170.7110, 0.9219, -83.6766, 179.1257, 97.7238, 95.2805}},
         {{1, 3, 4}, {170.7110, -72.0452, 101.2952, -112.8790, -97.7238, -84.7195}},
         {{1, 3, 5}, {170.7110, -76.0430, 83.6766, 88.7375, 97.7238, 95.2805}},
     }},
    {"tm14",
     {411.51, 34.418, 637.052, -172.893, 7.053, 165.439},
     {
         {{0, 2, 4}, {30.0000, -20.0000, 100.0000, 10.0000, 80.0000, -45.0000}},
         {{0, 2, 5}, {30.0000, 2.5852, 81.4318, -174.0170, -80.0000, 135.0000}},
         {{0, 3, 4}, {30.0000, 69.2875, -100.0000, 120.7125, 80.0000, -45.0000}},
         {{0, 3, 5}, {30.0000, 76.2702, -81.4318, -84.8384, -80.0000, 135.0000}},
         {{1, 2, 4}, {164.5934, 20.1409, -101.7575, -1.2265, -97.0025, -90.8451}},
         {{1, 2, 5}, {164.5934, -2.6662, -79.6822, 179.5052, 97.0025, 89.1549}},
         {{1, 3, 4}, {164.5934, -70.5663, 101.7575, -114.0344, -97.0025, -90.8451}},
         {{1, 3, 5}, {164.5934, -74.8371, 79.6822, 92.3117, 97.0025, 89.1549}},
     }},
};
// clang-format on

TEST(RobotVectors, inverseKinematicsGivesAllEightListedPosturesWithTheirBits) {
  ASSERT_EQ(inverse_tables.size(), 5U);
  for (const InverseTable& table : inverse_tables) {
    SCOPED_TRACE(table.model);
    const ArmModel arm = model(table.model);
    const Pose flange = forwardKinematics(arm, toJointVector(table.branches.front().joints));
    EXPECT_THAT(toControllerPose(flange), ::testing::Pointwise(::testing::DoubleNear(5.1e-4), table.pose));

    const Branches branches = allBranches(arm, flange);
    ASSERT_EQ(branches.size(), 8U);
    for (const ListedBranch& listed : table.branches) {
      const auto bits = PoseBits::fromNumbers(listed.bits[0], listed.bits[1], listed.bits[2]);
      const Branch* branch = branchWith(branches, bits.value());
      ASSERT_NE(branch, nullptr);
      EXPECT_LT(radToDeg(turnlessDifference(branch->joints, toJointVector(listed.joints))), 5.1e-5);
    }
  }
}

struct Capture {
  const char* model;
  ControllerJoints joints;
  ControllerPose pose;
};

TEST(RobotVectors, posesRecordedFromRealArmsAreWithinTheirCalibration) {
  const std::vector<Capture> captures = {
      {"tm12",
       {-5.303604, 55.2007942, 69.6347, -29.8407936, 79.27841, 6.384208},
       {1053.882, -277.370331, 90.85741, -175.800278, 11.7489395, 79.05987}},
      {"tm14",
       {89.4597, -35.00033, 125.000435, -0.000127, 90, 0.000595},
       {158.595123, 252.253464, 490.568024, -179.6098, -0.190238521, 179.489044}}};
  for (const Capture& capture : captures) {
    SCOPED_TRACE(capture.model);
    const Pose nominal = forwardKinematics(model(capture.model), toJointVector(capture.joints));
    const Pose recorded = toPose(capture.pose);
    EXPECT_LT((nominal.translation() - recorded.translation()).norm(), 3e-3);
    EXPECT_LT(Eigen::AngleAxisd(nominal.linear().transpose() * recorded.linear()).angle(), degToRad(1.0));
  }
}

// The manual's trans(): translation P2 - P1, rotation R2 R1^T, both in the common base.
TEST(RobotVectors, theManualsTransExampleHoldsWithThisEulerConvention) {
  const Pose p1 = toPose({-388.3831, -199.8061, 367.0702, 177.4319, 1.717448, -46.02005});
  const Pose p2 = toPose({-436.9584, 115.7343, 371.4378, 179.4419, -42.86601, -96.91867});
  Pose trans = Pose::Identity();
  trans.translation() = p2.translation() - p1.translation();
  trans.linear() = p2.linear() * p1.linear().transpose();
  const ControllerPose expected = {-48.57532, 315.5404, 4.367615, -34.39363, -30.39285, -40.52448};
  EXPECT_THAT(toControllerPose(trans), ::testing::Pointwise(::testing::DoubleNear(1e-4), expected));
  const ControllerPose inverse = {206.4934, -100.5999, -221.7758, 44.54835, -2.848977, 48.96799};
  EXPECT_THAT(toControllerPose(toPose(expected).inverse()),
              ::testing::Pointwise(::testing::DoubleNear(1e-4), inverse));
}

TEST(RobotVectors, theManualsChangerefExampleHoldsWithThisEulerConvention) {
  const Pose pose = toPose({-431.927, -140.6103, 368.7306, -179.288, -0.6893783, -105.8449});
  const Pose base = toPose({-431.93, -140.61, 368.73, -57.70, -44.98, 33.62});
  const ControllerPose expected = {0.0020, 0.0000, -0.0023, 113.9423, 14.9346, -123.1989};
  EXPECT_THAT(toControllerPose(base.inverse() * pose),
              ::testing::Pointwise(::testing::DoubleNear(6e-3), expected));
}

}  // namespace
}  // namespace cobot_command::arm
