// Reference dynamics and software limits of a core, as they are told.
#include "core_rig.h"
#include "status_frames.h"
#include <gmock/gmock.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/common/units.h"

namespace cobot_command::testing {
namespace {

using namespace command;
using ::testing::HasSubstr;

TEST(DynamicsOfACore, areThoseOfItsModel) {
  const CoreRig rig(*arm::ArmModel::named("tm5-900"));
  const auto reference = rig.core.referenceDynamics();
  ASSERT_TRUE(reference);
  EXPECT_NEAR(radToDeg(reference->joint_speeds[0]), 180, 1e-9);
  EXPECT_NEAR(radToDeg(reference->joint_speeds[3]), 225, 1e-9);
  EXPECT_EQ(reference->tcp_speed, 1.4);
  const auto limits = rig.core.limits();
  ASSERT_TRUE(limits);
  EXPECT_EQ(limits->rule.upper, limits->model.upper);
  EXPECT_NEAR(radToDeg(limits->model.upper[0]), 270, 1e-9);
}

TEST(DynamicsOfACore, areNoneWithoutAModel) {
  CoreRig rig;
  EXPECT_FALSE(rig.core.referenceDynamics());
  EXPECT_FALSE(rig.core.limits());
  EXPECT_EQ(rig.core.writeLimits({}, rig.now).error_id, blocks::own_error::kNoModel);
}

TEST(SoftwareLimitsOfACore, areToldWithTheArmThatHasThem) {
  CoreRig rig(*arm::ArmModel::named("tm5-900"));
  SoftwareLimits narrow = rig.core.limits()->rule;
  narrow.upper[2] = 1.0;
  const DynamicsAnswer answer = rig.core.writeLimits(narrow, rig.now);
  rig.pump();
  EXPECT_TRUE(answer.success);
  EXPECT_THAT(answer.message, HasSubstr("the position of the robot is unknown"));
  ASSERT_NE(rig.limited_arm, nullptr);
  EXPECT_EQ(rig.limited_arm->limits()[2].upper, 1.0);
  EXPECT_EQ(rig.core.limits()->rule.upper[2], 1.0);
  EXPECT_NE(rig.core.limits()->model.upper[2], 1.0) << "that they may be widened to";
}

TEST(SoftwareLimitsOfACore, areNotSetWhileAnythingMoves) {
  CoreRig rig(*arm::ArmModel::named("tm5-900"), link::LinkSettings{});
  rig.connect();
  rig.stream(StatusFrames().moving());
  rig.discardSent();
  EXPECT_EQ(rig.core.writeLimits(rig.core.limits()->rule, rig.now).error_id, 0x8C53);
  rig.stream(StatusFrames(), 5);
  rig.pass(2s);
  rig.discardSent();
}

/// Degrees that were made radians, and back, are those of the model.
TEST(SoftwareLimitsOfACore, mayBeThoseOfTheModelButForRounding) {
  CoreRig rig(*arm::ArmModel::named("tm5-900"));
  SoftwareLimits limits = rig.core.limits()->model;
  limits.lower.array() -= 1e-9;
  limits.upper.array() += 1e-9;
  EXPECT_TRUE(rig.core.writeLimits(limits, rig.now).success);
  EXPECT_EQ(rig.core.limits()->rule.upper, rig.core.limits()->model.upper);
}

}  // namespace
}  // namespace cobot_command::testing
