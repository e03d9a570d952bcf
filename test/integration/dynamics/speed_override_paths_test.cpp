// The speed override and paths: it multiplies their feedrate, and shares their pause.
#include "../load_path/path_goals.h"
#include <gmock/gmock.h>

#include "cobot_command/common/units.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using ::testing::HasSubstr;

class SpeedOverridesOfPaths : public LoadPathCell {
 protected:
  /// Joint 1 from 0 to 90 degrees in 1.5 s.
  [[nodiscard]] static LoadPathGoal quarterTurn() {
    LoadPathGoal goal;
    path::PathPoint point = pathPoint({90, 0, 90, 0, 90, 0});
    point.speed = 90;
    point.acceleration = 180;
    point.deceleration = 180;
    goal.path = {point};
    goal.number_of_moves = 1;
    return goal;
  }
  [[nodiscard]] double joint1() { return radToDeg(cell.robot().joints[0]); }
};

TEST_F(SpeedOverridesOfPaths, multiplyTheFeedrate) {
  cell.setFeedrate(50);
  cell.setSpeedOverride(50);
  EXPECT_EQ(cell.controls().feedrate, 0.5) << "that stays as it was set";
  const GoalId path = cell.submit(quarterTurn());
  expectDone(path);
  EXPECT_NEAR(toSeconds(*cell.endOf(path).planned), 6.0, 1e-3);
}

TEST_F(SpeedOverridesOfPaths, countForPointsThatAreNotSentYet) {
  const GoalId path = cell.submit(turns(20, false));
  passUntilActive(path, 2);
  const auto answer = cell.setSpeedOverride(50);
  EXPECT_EQ(answer->effective, 100);
  ASSERT_TRUE(cell.passUntil([&] { return cell.group().effective_speed == 50; }, 1min));
  expectDone(path);
}

/// What it has set, it sets back.
TEST_F(SpeedOverridesOfPaths, letAScriptThatIsCancelledAtNoughtEnd) {
  arm::Pose tool = arm::Pose::Identity();
  tool.translation().z() = 0.1;
  ASSERT_TRUE(cell.write({3, std::optional(tables::Tool{"", tool, 0})}));
  LoadPathGoal goal = turns(20, false);
  goal.execution = static_cast<int>(Execution::Script);
  goal.allow_approximation = true;
  path::PathPoint first = pathLine({417.5, -122.3, 381.05, 180, 0, 90});
  first.pose_type = static_cast<int>(path::MovedFrame::Tool);
  first.pose_id = 3;
  goal.path.insert(goal.path.begin(), first);
  goal.number_of_moves = 21;
  const GoalId path = cell.submit(goal);
  passUntilActive(path, 2);
  cell.setSpeedOverride(0);
  cell.pass(300ms);
  cell.cancel(path);
  ASSERT_TRUE(cell.passUntil([&] { return cell.outcome(path) != nullptr; }, 10s));
  EXPECT_EQ(cell.endOf(path).ending, Ending::CommandAborted);
  EXPECT_THAT(cell.scripts().back(), HasSubstr("ChangeTCP"));
}

TEST_F(SpeedOverridesOfPaths, doNotLetAPathGoThatIsStopped) {
  const GoalId path = cell.submit(quarterTurn());
  ASSERT_TRUE(cell.passUntil([&] { return joint1() > 20; }));
  cell.setSpeedOverride(0);
  cell.pass(300ms);
  cell.setFeedrate(0);
  cell.pass(300ms);
  const auto answer = cell.setSpeedOverride(100);
  ASSERT_TRUE(answer);
  EXPECT_THAT(answer->message, HasSubstr("a stopped path"));
  cell.pass(10s);
  EXPECT_EQ(cell.outcome(path), nullptr);
  cell.setFeedrate(100);
  expectDone(path);
}

TEST_F(SpeedOverridesOfPaths, areNotLiftedByAPathThatGoesOn) {
  const GoalId path = cell.submit(quarterTurn());
  ASSERT_TRUE(cell.passUntil([&] { return joint1() > 20; }));
  cell.setFeedrate(0);
  cell.pass(300ms);
  cell.setSpeedOverride(0);
  cell.pass(300ms);
  const auto answer = cell.setFeedrate(100);
  ASSERT_TRUE(answer);
  EXPECT_THAT(answer->message, HasSubstr("speed override"));
  cell.pass(10s);
  EXPECT_EQ(cell.outcome(path), nullptr);
  cell.setSpeedOverride(100);
  expectDone(path);
}

}  // namespace
}  // namespace cobot_command::testing
