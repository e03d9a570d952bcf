// What a speed override makes of the lines of a goal.
#include "block_goals.h"
#include "motion_goals.h"
#include <gmock/gmock.h>

#include "cobot_command/blocks/list/goal_rules.h"

namespace cobot_command::blocks {
namespace {

using cobot_command::testing::good;
using cobot_command::testing::moveJoints;
using ::testing::HasSubstr;

Order orderFor(const Goal& goal) {
  return GoalRules(goal).command()->order(arm::Pose::Identity());
}

TEST(SlowedOrder, hasAShareOfTheSpeedRoundedDownAndTheSameRamp) {
  const Order order = slowed(orderFor(moveJoints({10, 0, 90, 0, 90, 0}, 45)), 0.5);
  ASSERT_EQ(order.lines.size(), 1U);
  EXPECT_THAT(order.lines[0], HasSubstr(",22,200,0,"));
  EXPECT_EQ(std::get<script::Ptp>(order.commands->front()).options.speed, 22)
      << "what is planned is what is sent";
  EXPECT_EQ(order.speed_share, 0.5);
}

TEST(SlowedOrder, roundsNothingThatIsWhole) {
  for (int percent = 1; percent <= 100; ++percent) {
    const Order order = slowed(orderFor(moveJoints({10, 0, 90, 0, 90, 0}, 100)), percent / 100.0);
    EXPECT_EQ(std::get<script::Ptp>(order.commands->front()).options.speed, percent);
  }
}

TEST(SlowedOrder, isNeverBelowOne) {
  const Order order = slowed(orderFor(moveJoints({10, 0, 90, 0, 90, 0}, 3)), 0.01);
  EXPECT_EQ(std::get<script::Ptp>(order.commands->front()).options.speed, 1);
}

TEST(SlowedOrder, isAnyMove) {
  for (const Goal& goal :
       {Goal(good<MoveAbsoluteGoal>()), Goal(good<MoveRelativeGoal>()), Goal(good<MoveCircleGoal>())}) {
    const Order full = orderFor(goal);
    EXPECT_NE(slowed(full, 0.5).lines, full.lines);
  }
}

TEST(SlowedOrder, isNeitherAScriptNorASetting) {
  for (const Goal& goal :
       {Goal(good<RunScriptGoal>()), Goal(good<ChangeBaseGoal>()), Goal(good<SetOutputGoal>())}) {
    const Order full = orderFor(goal);
    EXPECT_EQ(slowed(full, 0.5).lines, full.lines);
    EXPECT_EQ(slowed(full, 0.5).speed_share, 1.0);
  }
}

}  // namespace
}  // namespace cobot_command::blocks
