// A chain that is planned at another feedrate beside the core, while it changes.
#include <algorithm>

#include "block_goals.h"
#include <gtest/gtest.h>

#include "cobot_command/blocks/list/goal_rules.h"
#include "cobot_command/blocks/shared/run.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;

class PathReplan : public ::testing::Test {
 protected:
  PathReplan() {
    LoadPathGoal goal = good<LoadPathGoal>();
    run_ = GoalRules(goal).run(1, planned(goal), now_);
    for (path::PathPoint& point : goal.path) point.speed = 20;
    const Outcome second = planned(goal);
    EXPECT_TRUE(run_->chain()->join(2, second, now_));
    use(1.0);
  }

  [[nodiscard]] Outcome planned(const LoadPathGoal& goal) {
    PlanningScene scene;
    scene.arm = &arm_;
    scene.start.emplace();
    scene.start->joints = arm::toJointVector({0, 0, 90, 0, 90, 0});
    scene.number = ++number_;
    if (run_) scene.chain = run_->chain()->end();
    return *GoalRules(goal).plan(scene);
  }
  void use(double feedrate) {
    path::PathControls controls;
    controls.feedrate = feedrate;
    run_->paths()->use(controls, now_);
  }
  [[nodiscard]] PathControlled& paths() { return *run_->paths(); }
  [[nodiscard]] bool sends() const { return run_->next().has_value(); }

  arm::ArmModel arm_ = *arm::ArmModel::named("tm5-900");
  Instant now_{};
  int number_ = 0;
  std::unique_ptr<blocks::Run> run_;
};

TEST_F(PathReplan, holdsBackWhatIsNotSent) {
  EXPECT_FALSE(paths().takeReplan());
  EXPECT_TRUE(sends());
  use(0.5);
  const auto work = paths().takeReplan();
  ASSERT_TRUE(work);
  EXPECT_FALSE(paths().takeReplan()) << "it is asked for once";
  EXPECT_FALSE(sends());
  EXPECT_FALSE(paths().replanned((*work)()));
  EXPECT_TRUE(sends());
  EXPECT_FALSE(paths().takeReplan());
}

TEST_F(PathReplan, isForNobodyOnceAGoalHasLeftTheChain) {
  use(0.5);
  const auto work = paths().takeReplan();
  ASSERT_TRUE(run_->chain()->takeOut(2, "cancelled", now_));
  const auto again = paths().takeReplan();
  ASSERT_TRUE(again);
  EXPECT_FALSE(paths().replanned((*work)()));
  EXPECT_FALSE(sends()) << "it was of a chain that is no more";
  EXPECT_FALSE(paths().replanned((*again)()));
  EXPECT_TRUE(sends());
}

TEST_F(PathReplan, isForNobodyOnceWhatItBeganWithIsSent) {
  use(0.5);
  const auto work = paths().takeReplan();
  use(1.0);
  ASSERT_TRUE(sends());
  run_->commandStarted(run_->next()->key);
  use(0.5);
  const auto again = paths().takeReplan();
  ASSERT_TRUE(again);
  EXPECT_FALSE(paths().replanned((*work)()));
  EXPECT_FALSE(sends());
  EXPECT_FALSE(paths().replanned((*again)()));
  EXPECT_EQ(paths().pace().next_point, 1);
}

TEST_F(PathReplan, thatTookTooLongIsTriedAgainWithTheNextFeedrate) {
  use(0.5);
  ASSERT_TRUE(paths().takeReplan());
  EXPECT_TRUE(paths().replanned(Detail()));
  EXPECT_FALSE(sends()) << "it would be faster than was asked for";
  EXPECT_FALSE(paths().takeReplan());
  use(1.0);
  EXPECT_TRUE(sends());
  use(0.5);
  EXPECT_TRUE(paths().takeReplan()) << "what could not be may be by now";
}

TEST_F(PathReplan, thatWasRefusedIsTriedAgainWithoutTheGoalThatRefusedIt) {
  use(0.5);
  ASSERT_TRUE(paths().takeReplan());
  EXPECT_TRUE(paths().replanned(Detail()));
  ASSERT_TRUE(run_->chain()->takeOut(2, "cancelled", now_));
  const auto work = paths().takeReplan();
  ASSERT_TRUE(work);
  EXPECT_FALSE(paths().replanned((*work)()));
  EXPECT_TRUE(sends());
}

TEST_F(PathReplan, thatIsRefusedIsNotChargedToAnotherFeedrate) {
  use(0.5);
  ASSERT_TRUE(paths().takeReplan());
  use(0.4);
  EXPECT_TRUE(paths().takeReplan());
  use(0.5);
  use(0.4);
  EXPECT_FALSE(sends());
}

}  // namespace
}  // namespace cobot_command::testing
