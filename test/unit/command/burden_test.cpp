// What the arm carries, where no status stream tells the mass of the tool: what was commanded, as long as
// that holds.

#include "core_rig.h"
#include "motion_goals.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::HasSubstr;
using ::testing::Not;

/// More than a TM5-900 carries.
constexpr const char* kHeavyTool = "ChangeTCP(0,0,100,0,0,0,8)";
constexpr const char* kHeavyLoad = "ChangeLoad(8)";

class CommandedBurden : public ::testing::TestWithParam<const char*> {
 protected:
  CommandedBurden() : rig(*arm::ArmModel::named("tm5-900"), link::LinkSettings{}) {
    rig.connect();
    rig.status(StatusFrames());
  }
  /// A blended motion, done for its goal.
  void setInMotion() {
    MoveAbsoluteGoal blended = moveJoints({60, 0, 90, 0, 90, 0}, 10);
    blended.blending_enable = true;
    rig.submit(blended);
    rig.reply(rig.takeScript().id);
    rig.stream(StatusFrames().moving());
  }
  void change() {
    RunScriptGoal change;
    change.script = GetParam();
    const GoalId goal = rig.submit(change);
    rig.reply(rig.takeScript().id);
    ASSERT_NE(rig.outcome(goal), nullptr);
    ASSERT_EQ(rig.outcome(goal)->ending, Ending::Done) << rig.outcome(goal)->error_description;
  }
  void stop() {
    rig.submit(StopGoal{});
    rig.reply(rig.takeScript().id);
    rig.stream(StatusFrames());
  }
  void expectTold(bool told) {
    rig.status(StatusFrames().error(0x22, "OVERLOAD"));
    const GoalId goal = rig.submit(CoreRig::move());
    ASSERT_NE(rig.outcome(goal), nullptr);
    EXPECT_EQ(rig.outcome(goal)->error_id, own_error::kRobotError);
    if (told) {
      EXPECT_THAT(rig.latest().diagnosis, HasSubstr("8 kg, the payload of tm5-900 is 4 kg"));
      EXPECT_THAT(rig.outcome(goal)->remedy, HasSubstr("change_tcp"));
    } else {
      EXPECT_THAT(rig.latest().diagnosis, Not(HasSubstr("the payload of")));
      EXPECT_THAT(rig.outcome(goal)->remedy, Not(HasSubstr("change_tcp")));
    }
  }

  CoreRig rig;
};

/// The controller never came to it.
TEST_P(CommandedBurden, isGoneWithTheStopThatDroppedItBehindAMotion) {
  setInMotion();
  change();
  stop();
  expectTold(false);
}

TEST_P(CommandedBurden, isGoneWithAStopThatMayHaveDroppedIt) {
  setInMotion();
  change();
  rig.submit(StopGoal{});
  rig.takeScript();
  rig.stream(StatusFrames().moving(), 300);
  expectTold(false);
}

TEST_P(CommandedBurden, staysWhereTheStopWasRefused) {
  setInMotion();
  change();
  rig.submit(StopGoal{});
  rig.reply(rig.takeScript().id, false, {1});
  expectTold(true);
}

TEST_P(CommandedBurden, staysWhenItWasInForceBeforeTheMotionThatIsStopped) {
  change();
  rig.stream(StatusFrames(), 40);  // 0.6 s: it might have been a script that moves
  setInMotion();
  stop();
  expectTold(true);
}

TEST_P(CommandedBurden, staysOnceTheMotionInFrontOfItIsDone) {
  setInMotion();
  change();
  rig.stream(StatusFrames(), 40);  // 0.6 s
  setInMotion();
  stop();
  expectTold(true);
}

INSTANTIATE_TEST_SUITE_P(ToolAndLoad, CommandedBurden, ::testing::Values(kHeavyTool, kHeavyLoad));

}  // namespace
}  // namespace cobot_command::testing
