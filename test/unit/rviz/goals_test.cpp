#include "goals/goals.h"

#include <tuple>

#include "block_messages.h"
#include "files/pick_and_place_file.h"
#include "forms/forms.h"
#include "no_lookups.h"
#include "source_tree.h"
#include <gmock/gmock.h>

namespace cobot_command::rviz_plugin {
namespace {

using ::testing::ElementsAre;

TEST(Goals, haveASpeedAndABlendingInTheUnitsOfTheFormat) {
  Form form = moveAbsoluteForm();
  form.set("movement_command", 0);
  form.set("data_format", 4);
  form.set("speed_mm_s", 1234);
  form.set("blending_enable", 1);
  form.set("blending_mm", 56);
  const auto goal = toMoveAbsolute(form);
  EXPECT_EQ(goal.speed, 1234);
  EXPECT_EQ(goal.blending_value, 56);
  form.set("data_format", 1);
  EXPECT_EQ(toMoveAbsolute(form).speed, 20);
  EXPECT_EQ(toMoveAbsolute(form).blending_value, 50);
}

TEST(Goals, haveTheTargetThatIsShown) {
  Form form = moveAbsoluteForm();
  form.setSix("joints", {1, 2, 3, 4, 5, 6});
  form.setSix("target", {10, 20, 30, 40, 50, 60});
  EXPECT_EQ(toMoveAbsolute(form).target_position.rz, 60);
  form.set("data_format", 0);
  EXPECT_EQ(toMoveAbsolute(form).target_position.rz, 6);
}

TEST(Goals, settleAtTheTargetWherePrecisePointIsOn) {
  Form form = moveRelativeForm();
  EXPECT_FALSE(toMoveRelative(form).disable_precise_positioning);
  form.set("precise", 0);
  EXPECT_TRUE(toMoveRelative(form).disable_precise_positioning);
}

TEST(Goals, chooseNoRobotPoseThatIsNotShown) {
  Form form = moveAbsoluteForm();
  form.set("robot_pose_enable", 1);
  EXPECT_TRUE(toMoveAbsolute(form).robot_pose_enable);
  form.set("movement_command", 0);
  EXPECT_FALSE(toMoveAbsolute(form).robot_pose_enable);
}

TEST(Goals, ofAStepInJogHaveTheIncrementOfTheirDirectionAlone) {
  Form form = jogForm();
  form.set("mode", 0);
  form.set("stepwise", 1);
  EXPECT_EQ(toJog(form, 2, 1).increment_mm, 10);
  EXPECT_EQ(toJog(form, 2, 1).increment_deg, 0);
  EXPECT_EQ(toJog(form, 4, -1).increment_mm, 0);
  EXPECT_EQ(toJog(form, 4, -1).increment_deg, 5);
  EXPECT_THAT(toJog(form, 4, -1).directions, ElementsAre(0, 0, 0, 0, -1, 0));
  form.set("mode", 2);
  EXPECT_EQ(toJog(form, 2, 1).increment_deg, 5);
}

TEST(Goals, ofAHeldJogHaveNoIncrement) {
  const auto goal = toJog(jogForm(), 0, 1);
  EXPECT_EQ(goal.increment_mm, 0);
  EXPECT_EQ(goal.increment_deg, 0);
}

/// What a step means to the block, but for its names and what is a default in both.
auto meaningOf(const blocks::MoveAbsoluteGoal& move) {
  return std::tuple(move.movement_command, move.data_format, move.target, move.speed, move.accel_time,
                    move.blending_enable, move.disable_precise_positioning, move.robot_pose_enable);
}

TEST(PresetCycle, isTheOneOfTheExample) {
  const auto file =
      ros_adapter::readPickAndPlaceFile(test_support::inSourceTree("config/pick_and_place.yaml"));
  ASSERT_TRUE(file);
  const auto preset =
      ros_adapter::toGoal(toPickAndPlace(presetCycle(), false),
                          {ros_adapter::noFrame, ros_adapter::noSteps, ros_adapter::noPoints});
  EXPECT_TRUE(blocks::check(preset).empty());
  ASSERT_EQ(preset.steps.size(), file->size());
  for (std::size_t i = 0; i < preset.steps.size(); ++i) {
    EXPECT_EQ(meaningOf(preset.steps[i].move), meaningOf((*file)[i].move)) << i;
    EXPECT_EQ(preset.steps[i].dwell, (*file)[i].dwell) << i;
  }
}

TEST(PresetCycle, setsTheOutputThatAMoveIsGiven) {
  Cycle cycle = presetCycle();
  cycle.moves[1].set("output_module", 1);
  cycle.moves[1].set("output", 3);
  const auto goal = toPickAndPlace(cycle, true);
  EXPECT_EQ(goal.steps[0].output.module, "");
  EXPECT_EQ(goal.steps[1].output.module, "EndModule");
  EXPECT_EQ(goal.steps[1].output.output, 3);
  EXPECT_TRUE(goal.steps[1].output.value);
  EXPECT_TRUE(goal.check_only);
}

}  // namespace
}  // namespace cobot_command::rviz_plugin
