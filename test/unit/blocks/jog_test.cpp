// What a jog must be, how far it may go, and what the controller is told.

#include "block_goals.h"
#include "jog/jog_drives.h"
#include "jog/jog_plan.h"
#include "jog/jog_run_states.h"
#include "table_checks.h"
#include <gmock/gmock.h>

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/tables/refusal.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

int errorWithJog(const std::function<void(JogGoal&)>& change) {
  return errorWith<JogGoal>(change);
}

TEST(JogTable, isSound) {
  expectSoundTable<JogTable>(JogState::Ended, JogEvent::NothingLeft, JogState::Driving, {JogState::Ended});
}

TEST(JogTable, goesOnOnlyWhileItSlowsDown) {
  for (const auto& row : JogTable::kRows) {
    if (row.to == JogState::Driving) {
      EXPECT_EQ(row.from, JogState::Slowing);
      EXPECT_EQ(row.event, JogEvent::KeepAlive);
    }
  }
}

TEST(JogGoalChecks, takeAGoodOne) {
  EXPECT_EQ(errorOf(good<JogGoal>()), 0);
  EXPECT_EQ(errorWithJog([](JogGoal& g) { g.increment_deg = 0; }), 0) << "hold to run";
  EXPECT_EQ(errorWithJog([](JogGoal& g) { g.speed = 100; }), 0);
}

TEST(JogGoalChecks, refuseModesDirectionsAndIncrementsThatAreNone) {
  for (const auto& change : std::vector<std::function<void(JogGoal&)>>{
           [](JogGoal& g) { g.mode = 3; }, [](JogGoal& g) { g.mode = -1; },
           [](JogGoal& g) { g.directions[5] = -2; }, [](JogGoal& g) { g.directions = {}; },
           [](JogGoal& g) { g.increment_deg = -1; }, [](JogGoal& g) { g.increment_deg = 721; },
           [](JogGoal& g) { g.increment_deg = kInf; }, [](JogGoal& g) { g.increment_mm = 1; },
           [](JogGoal& g) { g.mode = 0; },
           [](JogGoal& g) {
             g.mode = 1;
             g.directions = {1, 0, 0, 1, 0, 0};
             g.increment_deg = 0;
           }}) {
    EXPECT_EQ(errorWithJog(change), jog_error::kInput);
  }
}

TEST(JogGoalChecks, tellNumbersApartThatAreNone) {
  EXPECT_EQ(errorWithJog([](JogGoal& g) { g.speed = kNan; }), own_error::kNotFinite);
  EXPECT_EQ(errorWithJog([](JogGoal& g) { g.increment_deg = kNan; }), own_error::kNotFinite);
  EXPECT_EQ(errorWithJog([](JogGoal& g) { g.increment_mm = kNan; }), own_error::kNotFinite);
  for (const double speed : {-0.1, 100.1, kInf, -kInf}) {
    EXPECT_EQ(errorWithJog([speed](JogGoal& g) { g.speed = speed; }), motion_error::kSpeedRangePercent);
  }
}

TEST(JogGoalChecks, allowTwoRotationsOnlyWhileTheyAreHeld) {
  const auto twice = [](double increment) {
    return errorWithJog([increment](JogGoal& g) {
      g.mode = static_cast<int>(JogMode::Frame);
      g.directions = {0, 0, 0, 1, 0, 1};
      g.increment_deg = increment;
    });
  };
  EXPECT_EQ(twice(5), jog_error::kTwoRotations);
  EXPECT_EQ(twice(0), 0);
  EXPECT_EQ(errorWithJog([](JogGoal& g) { g.directions = {0, 0, 0, 1, 0, 1}; }), 0) << "joints have no order";
}

TEST(JogGoalChecks, lookAtFrameAndToolOnlyWhereTheyCount) {
  const auto with_numbers = [](JogMode mode, int frame, int tool) {
    return errorWithJog([=](JogGoal& g) {
      g.mode = static_cast<int>(mode);
      g.increment_deg = 0;
      g.frame = frame;
      g.tool = tool;
    });
  };
  EXPECT_EQ(with_numbers(JogMode::Frame, 16, 0), tables::table_error::kFrameIndex);
  EXPECT_EQ(with_numbers(JogMode::Frame, -2, 0), tables::table_error::kFrameIndex);
  EXPECT_EQ(with_numbers(JogMode::Tool, 0, 16), tables::table_error::kToolIndex);
  EXPECT_EQ(with_numbers(JogMode::Axes, 99, 99), 0);
  EXPECT_EQ(with_numbers(JogMode::Frame, JogGoal::kActive, JogGoal::kActive), 0);
}

class JogPlans : public ::testing::Test {
 protected:
  JogPlans() {
    scene.arm = &arm;
    scene.start.emplace();
    scene.start->joints = (arm::JointVector() << 0, 0, kPi / 2, 0, kPi / 2, 0).finished();
  }
  std::shared_ptr<const JogPlan> planned(JogMode mode, const std::array<int, 6>& directions, double speed) {
    JogGoal goal;
    goal.mode = static_cast<int>(mode);
    goal.directions = directions;
    goal.speed = speed;
    goal.frame = goal.tool = JogGoal::kActive;
    const auto plan = planJog(goal, scene);
    EXPECT_TRUE(plan) << plan.error().found;
    return *plan;
  }
  arm::ArmModel arm = *arm::ArmModel::named("tm5-900");
  PlanningScene scene;
};

TEST_F(JogPlans, takeRatedSpeedsOfJointsAsReference) {
  const auto plan = planned(JogMode::Axes, {1, 0, 0, 0, 0, -1}, 20);
  EXPECT_NEAR(plan->joint_rate[0], 0.2 * arm.limits()[0].max_velocity, 1e-12);
  EXPECT_NEAR(plan->joint_rate[5], -0.2 * arm.limits()[5].max_velocity, 1e-12);
}

TEST_F(JogPlans, takeTypicalSpeedAndTurnSpeedOfTheTcpAsReference) {
  const auto plan = planned(JogMode::Frame, {1, -1, 0, 0, 0, 1}, 0);
  EXPECT_EQ(plan->percent, 10);
  EXPECT_NEAR(plan->tcp_rate.linear.norm(), 0.1 * arm.ratings().max_tcp_speed, 1e-12);
  EXPECT_NEAR(plan->tcp_rate.angular.z(), 0.1 * arm.ratings().turn_speed, 1e-12);
}

TEST_F(JogPlans, roundSpeedsToWholePercents) {
  EXPECT_EQ(planned(JogMode::Axes, {1, 0, 0, 0, 0, 0}, 0.01)->percent, 1);
  EXPECT_EQ(planned(JogMode::Axes, {1, 0, 0, 0, 0, 0}, 12.6)->percent, 13);
}

TEST_F(JogPlans, reachToTheLimitOfAJoint) {
  const auto plan = planned(JogMode::Axes, {0, 0, 1, 0, 0, 0}, 10);
  ASSERT_TRUE(plan->obstacle);
  EXPECT_EQ(plan->obstacle->joint, 2);
  const double way = plan->reach * plan->joint_rate[2];
  EXPECT_NEAR(kPi / 2 + way, arm.limits()[2].upper, 1e-6);
}

TEST_F(JogPlans, reachFurtherThanOneLookOfTheTcp) {
  const auto plan = planned(JogMode::Frame, {0, 0, 1, 0, 0, 0}, 2);
  ASSERT_TRUE(plan->obstacle);
  EXPECT_GT(plan->reach, 5);
  EXPECT_THAT(plan->obstacleText(), HasSubstr("singularity"));
}

TEST_F(JogPlans, measureTheDriveThatAnArmHasMade) {
  const auto of_joints = planned(JogMode::Axes, {1, -1, 0, 0, 0, 0}, 10);
  EXPECT_NEAR(of_joints->driveAt(of_joints->start + 0.7 * of_joints->joint_rate, 0), 0.7, 1e-9);
  const auto turn = planned(JogMode::Tool, {0, 0, 0, 0, 0, 1}, 10);
  arm::JointVector turned = turn->start;
  turned[5] += 1.2 * kPi;
  const double expected = 1.2 * kPi / turn->tcp_rate.angular.norm();
  EXPECT_NEAR(std::abs(turn->driveAt(turned, expected * 0.99)), expected, 1e-6) << "beyond half a turn";
}

TEST_F(JogPlans, tellTheControllerVelocitiesInItsUnits) {
  const auto plan = planned(JogMode::Axes, {1, 0, 0, 0, 0, 0}, 10);
  EXPECT_THAT(plan->enterVelocity().lines, ElementsAre("ContinueVJog()", "SetContinueVJog(18,0,0,0,0,0)"));
  EXPECT_THAT(plan->setVelocity(true).lines, ElementsAre("SetContinueVJog(0,0,0,0,0,0)"));
  EXPECT_THAT(JogPlan::leaveVelocity().lines, ElementsAre("StopContinueVmode()"));
  EXPECT_THAT(plan->move(0.06, true).lines, ElementsAre("Move_PTP(\"JPP\",1.08,0,0,0,0,0,10,60,100,false)"));
}

TEST_F(JogPlans, keepTheBudgetOf250MsByEachMeans) {
  const auto plan = planned(JogMode::Axes, {1, 0, 0, 0, 0, 0}, 10);
  EXPECT_EQ(velocityDrive(plan)->patience() + plan->stop_time + kJogReserve, kJogStandsWithin);
  EXPECT_EQ(movesDrive(plan)->patience() + kJogPiece + kJogRamp + kJogReserve, kJogStandsWithin);
}

TEST_F(JogPlans, neverHaveMoreThanAFifthOfASecondOfMovesAhead) {
  const auto drive = movesDrive(planned(JogMode::Axes, {1, 0, 0, 0, 0, 0}, 10));
  Instant now{10s};
  const Instant kept = now + 1h;
  Duration sent{};
  for (int i = 0; i < 1000; ++i, now += 1ms) {
    drive->look(now, kept);
    while (drive->next(JogWish::Drive)) {
      drive->started(JogWish::Drive);
      drive->sent(now);
      sent += kJogPiece;
      drive->look(now, kept);
    }
    EXPECT_LE(sent + kJogRamp, now - Instant{10s} + 200ms) << i;
  }
  EXPECT_GT(sent, 1s) << "and never run dry";
}

TEST_F(JogPlans, areNoneOfTheTcpWhileBaseOrTcpAreNotKnown) {
  scene.start->base.reset();
  JogGoal goal;
  goal.directions = {1, 0, 0, 0, 0, 0};
  ASSERT_FALSE(planJog(goal, scene));
  EXPECT_EQ(planJog(goal, scene).error().error_id, own_error::kStartUnknown);
  goal.mode = static_cast<int>(JogMode::Axes);
  EXPECT_TRUE(planJog(goal, scene));
}

TEST_F(JogPlans, turnOnlyAboutTheActiveTcp) {
  scene.start->tcp = arm::Pose(Eigen::Translation3d(0, 0, 0.1));
  JogGoal goal;
  goal.mode = static_cast<int>(JogMode::Frame);
  goal.directions = {0, 0, 0, 0, 0, 1};
  const auto plan = planJog(goal, scene);
  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().error_id, tables::table_error::kToolIndex);
  goal.tool = JogGoal::kActive;
  EXPECT_TRUE(planJog(goal, scene));
}

}  // namespace
}  // namespace cobot_command::testing
