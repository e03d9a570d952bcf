// Default dynamics: what moves have whose own value is negative.
#include <limits>

#include "dynamics_cell.h"

#include "cobot_command/blocks/list/goal.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using ::testing::HasSubstr;

class DefaultDynamicsOfMoves : public DynamicsCell {
 protected:
  [[nodiscard]] static MoveAbsoluteGoal withoutItsOwn() {
    MoveAbsoluteGoal goal = turnTo(90, -1);
    goal.accel_time = -1;
    return goal;
  }
  static DefaultDynamics slow() {
    DefaultDynamics defaults;
    defaults.speed_percent = 25;
    defaults.accel_time = 500;
    return defaults;
  }
};

TEST_F(DefaultDynamicsOfMoves, areNoneAtTheStart) {
  const Outcome& outcome = cell.endOf(cell.submit(withoutItsOwn()));
  EXPECT_EQ(outcome.error_id, motion_error::kSpeedRangePercent);
  EXPECT_THAT(outcome.error_description, HasSubstr("there is no default for it"));
}

TEST_F(DefaultDynamicsOfMoves, standInForWhatIsNegative) {
  EXPECT_TRUE(cell.writeDefaults(slow()).success);
  const GoalId move = cell.submit(withoutItsOwn());
  expectDone(move);
  EXPECT_NEAR(planned(move), 2.5, 1e-3);
  EXPECT_THAT(cell.scripts().back(), HasSubstr(",25,500,0,"));
}

TEST_F(DefaultDynamicsOfMoves, leaveWhatAMoveGivesByItself) {
  cell.writeDefaults(slow());
  const GoalId move = cell.submit(turnTo(90));
  EXPECT_NEAR(planned(move), 1.2, 1e-3);
}

TEST_F(DefaultDynamicsOfMoves, areOfTheUnitOfTheFormat) {
  DefaultDynamics defaults = slow();
  MoveRelativeGoal line;
  line.movement_command = static_cast<int>(Movement::Line);
  line.data_format = static_cast<int>(RelativeFormat::Cap);
  line.target = {0, 0, -100, 0, 0, 0};
  line.speed = -1;
  line.accel_time = 200;
  cell.writeDefaults(defaults);
  EXPECT_EQ(cell.endOf(cell.submit(line)).error_id, motion_error::kSpeedRangeAbsolute)
      << "there is none in mm/s";
  defaults.speed_mm_s = 80;
  cell.writeDefaults(defaults);
  expectDone(cell.submit(line));
  EXPECT_THAT(cell.scripts().back(), HasSubstr(",80,200,0,"));
}

TEST_F(DefaultDynamicsOfMoves, countForTheStepsOfCyclesAndChecks) {
  cell.writeDefaults(slow());
  PickAndPlaceGoal cycle;
  cycle.steps.resize(1);
  cycle.steps[0].move = withoutItsOwn();
  cycle.steps[0].move.buffer_mode = 0;
  expectDone(cell.submit(cycle));
  EXPECT_NEAR(joint1(), 90, 1e-3);
  CheckSequenceGoal sequence;
  MoveAbsoluteGoal back = withoutItsOwn();
  back.target[0] = 0;
  sequence.steps = {back};
  EXPECT_NEAR(planned(cell.submit(sequence)), 2.5, 1e-3);
}

TEST_F(DefaultDynamicsOfMoves, blendOnlyWhereThatIsEnabled) {
  DefaultDynamics defaults = slow();
  defaults.blending_percent = 30;
  cell.writeDefaults(defaults);
  MoveAbsoluteGoal move = withoutItsOwn();
  move.blending_value = -1;
  expectDone(cell.submit(move));
  EXPECT_THAT(cell.scripts().back(), HasSubstr(",25,500,0,"));
  move.target[0] = 0;
  move.blending_enable = true;
  expectDone(cell.submit(move));
  EXPECT_THAT(cell.scripts().back(), HasSubstr(",25,500,30,"));
}

TEST_F(DefaultDynamicsOfMoves, areThoseOfWhenAGoalCame) {
  cell.writeDefaults(slow());
  const GoalId first = cell.submit(turnTo(0.5));
  const GoalId second = cell.submit(withoutItsOwn());
  cell.writeDefaults({});
  expectDone(first);
  expectDone(second);
}

TEST_F(DefaultDynamicsOfMoves, areSlowedByTheSpeedOverride) {
  cell.writeDefaults(slow());
  cell.setSpeedOverride(50);
  expectDone(cell.submit(withoutItsOwn()));
  EXPECT_THAT(cell.scripts().back(), HasSubstr(",12,500,0,"));
}

TEST_F(DefaultDynamicsOfMoves, areRefusedOutOfTheirRangeAllTogether) {
  cell.writeDefaults(slow());
  const double none = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [&](const DefaultDynamics& defaults, const char* words) {
    const auto answer = cell.writeDefaults(defaults);
    EXPECT_FALSE(answer.success);
    EXPECT_EQ(answer.error_id, 0x8D07);
    EXPECT_THAT(answer.message, HasSubstr(words));
  };
  DefaultDynamics bad;
  for (const double speed : {0.0, 100.1, none}) {
    bad = {};
    bad.speed_percent = speed;
    refused(bad, "allowed: above 0 to 100");
  }
  bad = {};
  bad.speed_mm_s = 4501;
  refused(bad, "4500");
  bad = {};
  bad.accel_time = 149;
  refused(bad, "allowed: 150 to 9999");
  bad = {};
  bad.blending_percent = 101;
  refused(bad, "blending_percent");
  bad = {};
  bad.blending_mm = 2001;
  refused(bad, "blending_mm");
  expectDone(cell.submit(withoutItsOwn()));
}

}  // namespace
}  // namespace cobot_command::testing
