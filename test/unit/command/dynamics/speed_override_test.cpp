// The speed override on the wire: what is sent for it, and what becomes of it when the controller does not
// answer as it should.
#include "core_rig.h"
#include "motion_goals.h"
#include "status_frames.h"
#include <gmock/gmock.h>

#include "cobot_command/blocks/list/goal.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::HasSubstr;

class SpeedOverrideOnTheWire : public ::testing::Test {
 protected:
  SpeedOverrideOnTheWire() {
    rig.connect();
    rig.status(StatusFrames());
  }
  void set(double percent) {
    answers.emplace_back();
    rig.core.setSpeedOverride(
        percent, [this, i = answers.size() - 1](const OverrideAnswer& answer) { answers[i] = answer; },
        rig.now);
    rig.pump();
  }
  /// A long move, and the robot on its way.
  GoalId underWay() {
    const GoalId move = rig.submit(moveJoints({150, 0, 90, 0, 90, 0}, 5));
    rig.reply(rig.takeScript().id);
    rig.stream(StatusFrames().moving());
    return move;
  }

  CoreRig rig{*arm::ArmModel::named("tm5-900"), link::LinkSettings{}};
  std::vector<std::optional<OverrideAnswer>> answers;
};

TEST_F(SpeedOverrideOnTheWire, sendsNothingButAtNought) {
  underWay();
  set(30);
  EXPECT_TRUE(rig.nothingSent());
  EXPECT_TRUE(answers.back()->success);
  rig.discardSent();
}

TEST_F(SpeedOverrideOnTheWire, isAnsweredWhenTheControllerHasTakenThePause) {
  underWay();
  set(0);
  EXPECT_FALSE(answers.back());
  const auto pause = rig.takeScript();
  EXPECT_EQ(pause.script, "Pause()");
  rig.reply(pause.id);
  ASSERT_TRUE(answers.back());
  EXPECT_TRUE(answers.back()->success);
  EXPECT_EQ(answers.back()->effective, 0);
  rig.stream(StatusFrames().paused());
  set(0);
  EXPECT_TRUE(answers.back()->success) << "it is so already";
  EXPECT_TRUE(rig.nothingSent());
  set(80);
  const auto resume = rig.takeScript();
  EXPECT_EQ(resume.script, "Resume()");
  rig.reply(resume.id);
  EXPECT_TRUE(answers.back()->success);
  rig.stream(StatusFrames().moving());
}

TEST_F(SpeedOverrideOnTheWire, tellsThatThePauseWasRefused) {
  underWay();
  set(0);
  rig.reply(rig.takeScript().id, false, {1});
  ASSERT_TRUE(answers.back());
  EXPECT_FALSE(answers.back()->success);
  EXPECT_NE(answers.back()->error_id, 0);
  EXPECT_EQ(rig.group_state.speed_override, 0) << "nothing more is sent all the same";
  set(100);
  EXPECT_TRUE(answers.back()->success);
  EXPECT_TRUE(rig.nothingSent()) << "no pause, so no resume";
}

TEST_F(SpeedOverrideOnTheWire, isLiftedBeforeThePauseIsAnswered) {
  underWay();
  set(0);
  const auto pause = rig.takeScript();
  set(50);
  const auto resume = rig.takeScript();
  EXPECT_EQ(resume.script, "Resume()");
  rig.reply(pause.id);
  rig.reply(resume.id);
  ASSERT_TRUE(answers[0] && answers[1]);
  EXPECT_TRUE(answers[1]->success);
  EXPECT_EQ(rig.group_state.speed_override, 50);
}

TEST_F(SpeedOverrideOnTheWire, isBackAtNoughtBeforeTheResumeIsAnswered) {
  underWay();
  set(0);
  rig.reply(rig.takeScript().id);
  rig.stream(StatusFrames().paused());
  set(50);
  const auto resume = rig.takeScript();
  set(0);
  const auto pause = rig.takeScript();
  EXPECT_EQ(pause.script, "Pause()");
  rig.reply(resume.id);
  rig.reply(pause.id);
  for (const auto& answer : answers) EXPECT_TRUE(answer.has_value());
}

TEST_F(SpeedOverrideOnTheWire, forgetsItsPauseWithTheLink) {
  underWay();
  set(0);
  rig.reply(rig.takeScript().id);
  rig.close("reset");
  rig.close("reset", link::Channel::Status);
  rig.discardSent();
  EXPECT_EQ(rig.group_state.speed_override, 0);
  set(100);
  EXPECT_TRUE(answers.back()->success);
  EXPECT_TRUE(rig.nothingSent()) << "whether the project is paused behind the next link nobody knows";
}

TEST_F(SpeedOverrideOnTheWire, scalesAMoveWithoutAModel) {
  CoreRig alone;
  alone.connect();
  alone.core.setSpeedOverride(
      50, [](const OverrideAnswer&) {}, alone.now);
  alone.submit(CoreRig::move());
  const int speed = static_cast<int>(CoreRig::move().speed);
  EXPECT_THAT(alone.takeScript().script,
              HasSubstr("," + std::to_string(speed / 2) + "," +
                        std::to_string(static_cast<int>(CoreRig::move().accel_time)) + ","));
}

}  // namespace
}  // namespace cobot_command::testing
