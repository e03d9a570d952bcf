// What a trial tells of its robots.
#include "run_rig.h"

namespace cobot_command::trial {
namespace {

TEST(ATrial, hasEachRobotWhereItsMotionIsAtAnyMoment) {
  RunRig rig(artifactOf("handover"));
  rig.begin(1);
  ASSERT_TRUE(rig.passUntil([&] { return rig.isMoving(0); }));
  rig.pass(500ms);
  for (int look = 0; look < 10; ++look) {
    const arm::JointVector before = rig.robot(0).state().joints;
    rig.trial->pass(1ms);  // far less than from one message of the robot to the next
    EXPECT_FALSE(rig.robot(0).state().joints == before);
  }
}

TEST(ATrial, measuresHowDeepRobotsAreInEachOther) {
  TrialSettings settings;
  settings.policy = cell::Policy::None;
  const auto trial = *CellTrial::of(artifactOf("handover"), settings);
  ASSERT_TRUE(trial->start());
  trial->runAll(1);
  double least = 1.0;
  for (int look = 0; look < 400; ++look) {
    trial->pass(20ms);
    const auto one = trial->robot(0).bodies();
    const auto other = trial->robot(1).bodies();
    least = std::min(least, cell::nearestOf(one, other).distance);
  }
  EXPECT_LT(least, -0.05);
  EXPECT_NEAR(trial->least().distance, least, 0.01) << "at other moments";
}

}  // namespace
}  // namespace cobot_command::trial
