#include "queue/goal_queue.h"

#include "motion_goals.h"
#include "taken_actions.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::command {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

class GoalQueueTest : public ::testing::Test {
 protected:
  void push(blocks::GoalId id) {
    queue_.came(id);
    Waiting waiting;
    waiting.id = id;
    waiting.goal = testing::moveJoints({});
    waiting.end.emplace();
    queue_.push(std::move(waiting));
  }
  /// Goals and endings of what was told to have ended since the last call.
  std::vector<std::pair<blocks::GoalId, blocks::Ending>> takeEnded() {
    std::vector<std::pair<blocks::GoalId, blocks::Ending>> ended;
    for (const auto& end : take<GoalEnded>()) ended.emplace_back(end.goal, end.outcome.ending);
    return ended;
  }
  template <typename Kind>
  std::vector<Kind> take() {
    return testing::takeOf<Kind>(actions_);
  }
  std::vector<int> takePlaces() {
    queue_.tellPlaces([](int place) { return "place " + std::to_string(place); });
    std::vector<int> places;
    for (const auto& told : take<GoalProgressed>()) places.push_back(told.progress.place_in_queue);
    return places;
  }

  std::vector<Action> actions_;
  OutputBoard board_{actions_};
  PlanDesk plans_{10s, actions_, Planning::Beside};
  GoalQueue queue_{board_, plans_, actions_, {}};
};

TEST_F(GoalQueueTest, handsOutGoalsInTheOrderInWhichTheyCame) {
  push(1);
  push(2);
  EXPECT_EQ(queue_.take().id, 1U);
  EXPECT_EQ(queue_.take().id, 2U);
  EXPECT_TRUE(queue_.empty());
}

TEST_F(GoalQueueTest, tellsAPlaceOnlyWhenItIsAnotherOne) {
  push(1);
  push(2);
  EXPECT_THAT(takePlaces(), ElementsAre(1, 2));
  EXPECT_THAT(takePlaces(), IsEmpty());
  static_cast<void>(queue_.take());
  EXPECT_THAT(takePlaces(), ElementsAre(1));
}

TEST_F(GoalQueueTest, endsACancelledOneAndForgetsWhatWasForeseenBehindIt) {
  push(1);
  push(2);
  push(3);
  EXPECT_TRUE(queue_.drop(2, "cancelled"));
  EXPECT_THAT(takeEnded(), ElementsAre(std::pair(2U, blocks::Ending::CommandAborted)));
  EXPECT_EQ(queue_.size(), 2U);
  EXPECT_FALSE(queue_.back().end);
  EXPECT_FALSE(queue_.drop(2, "cancelled again"));
}

TEST_F(GoalQueueTest, endsAllAndTellsUpToWhichGoalTheyFell) {
  push(1);
  push(2);
  queue_.dropAll("the link was lost");
  ASSERT_TRUE(std::holds_alternative<CommandsFell>(actions_.at(0))) << "before any of them has ended";
  EXPECT_EQ(std::get<CommandsFell>(actions_.at(0)).newest, 2U);
  EXPECT_THAT(takeEnded(), ElementsAre(std::pair(1U, blocks::Ending::CommandAborted),
                                       std::pair(2U, blocks::Ending::CommandAborted)));
}

TEST_F(GoalQueueTest, knowsOfAGoalThatFellBeforeItCame) {
  queue_.dropAll("a cancel", 7);
  const blocks::Goal move = testing::moveJoints({});
  EXPECT_EQ(queue_.fell(7, move), "a cancel");
  EXPECT_FALSE(queue_.fell(8, move));
  EXPECT_FALSE(queue_.fell(7, blocks::StopGoal())) << "what halts the robot falls with nobody";
}

TEST_F(GoalQueueTest, asksWhichGoalIsTheNewestWhereGoalsWaitInFrontOfTheCore) {
  GoalQueue queue(board_, plans_, actions_, [] { return blocks::GoalId(40); });
  queue.came(3);
  queue.dropAll("an error");
  EXPECT_TRUE(queue.fell(40, testing::moveJoints({})));
  EXPECT_FALSE(queue.fell(41, testing::moveJoints({})));
}

TEST_F(GoalQueueTest, failsATakeOverWhoseStopWasNotConfirmed) {
  push(1);
  queue_.front().takes_over = true;
  push(2);
  queue_.dropUnstopped("no answer");
  const auto ends = take<GoalEnded>();
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_EQ(ends[0].goal, 2U);
  EXPECT_EQ(ends[0].outcome.ending, blocks::Ending::CommandAborted);
  EXPECT_EQ(ends[1].goal, 1U);
  EXPECT_EQ(ends[1].outcome.error_id, blocks::own_error::kStopNotConfirmed);
}

}  // namespace
}  // namespace cobot_command::command
