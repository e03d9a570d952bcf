// What everyone is told of how a path goes.
#include <algorithm>

#include "path_goals.h"
#include <gmock/gmock.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;

class LoadPathStatus : public LoadPathCell {
 protected:
  [[nodiscard]] std::vector<PathStatus> told() const {
    std::vector<PathStatus> told;
    for (const auto& [when, news] : cell.told()) told.push_back(news.as<PathStatus>());
    return told;
  }
  /// The move ids that were active, in their order.
  [[nodiscard]] std::vector<int> activeIds() const {
    std::vector<int> ids;
    for (const PathStatus& status : told()) {
      const bool is_new = status.active_move_id != 0 && (ids.empty() || ids.back() != status.active_move_id);
      if (is_new) ids.push_back(status.active_move_id);
    }
    return ids;
  }
  static LoadPathGoal withIds(LoadPathGoal goal, int first) {
    for (path::PathPoint& point : goal.path) point.move_id = first++;
    return goal;
  }
};

TEST_F(LoadPathStatus, comesTwentyTimesASecondAndOnceMoreAtTheEnd) {
  expectDone(cell.submit(turns(10, false)));
  const auto& all = cell.told();
  ASSERT_GT(all.size(), 10U);
  for (std::size_t i = 1; i + 1 < all.size(); ++i) {
    EXPECT_NEAR(toSeconds(all[i].first - all[i - 1].first), 0.05, 0.02) << i;
  }
  const auto statuses = told();
  for (std::size_t i = 0; i < statuses.size(); ++i) {
    EXPECT_EQ(statuses[i].path_planner_active, i + 1 < statuses.size()) << i;
  }
  EXPECT_EQ(statuses.back().active_move_id, 0);
  EXPECT_EQ(statuses.back().angular_velocity, 0);
  cell.pass(1s);
  EXPECT_EQ(told().size(), statuses.size()) << "nothing is told of no path";
}

TEST_F(LoadPathStatus, namesThePointsThatMoveTheRobotAndThoseThatTheyBlendInto) {
  expectDone(cell.submit(withIds(turns(6, true), 11)));
  EXPECT_THAT(activeIds(), ::testing::ElementsAre(11, 12, 13, 14, 15, 16));
  bool blended = false;
  PathStatus last;
  for (const PathStatus& status : told()) {
    if (status.blending_move_id != 0) {
      EXPECT_EQ(status.blending_move_id, status.active_move_id + 1);
      EXPECT_GT(status.active_move_percent, status.blending_move_percent);
    }
    blended = blended || status.blending_move_percent > 0;
    if (status.active_move_id == last.active_move_id) {
      EXPECT_GE(status.active_move_percent, last.active_move_percent);
    }
    last = status;
  }
  EXPECT_TRUE(blended);
}

TEST_F(LoadPathStatus, hasTheSpeedOfTheFlange) {
  LoadPathGoal goal = turns(1, false);
  goal.path[0].joints[0] = 90;
  expectDone(cell.submit(goal));
  double most = 0;
  for (const PathStatus& status : told()) most = std::max(most, status.angular_velocity);
  EXPECT_NEAR(most, goal.path[0].speed, 0.01);
}

TEST_F(LoadPathStatus, isOfOnePathWhereGoalsFollowEachOther) {
  const GoalId first = cell.submit(withIds(turns(4, true), 1));
  const GoalId second = cell.submit(withIds(turns(4, true, 4), 5));
  expectDone(first);
  expectDone(second);
  EXPECT_THAT(activeIds(), ::testing::ElementsAre(1, 2, 3, 4, 5, 6, 7, 8));
  const auto statuses = told();
  const auto ends = std::count_if(statuses.begin(), statuses.end(),
                                  [](const PathStatus& status) { return !status.path_planner_active; });
  EXPECT_EQ(ends, 1);
}

TEST_F(LoadPathStatus, comesToItsEndWithAPathThatIsStopped) {
  const GoalId id = cell.submit(turns(20, false));
  passUntilActive(id, 2);
  cell.submit(StopGoal{});
  static_cast<void>(cell.endOf(id));
  ASSERT_FALSE(told().empty());
  EXPECT_FALSE(told().back().path_planner_active);
}

TEST_F(LoadPathStatus, isToldOfAScriptToo) {
  LoadPathGoal goal = withIds(turns(3, false), 21);
  goal.execution = static_cast<int>(Execution::Script);
  goal.allow_approximation = true;
  expectDone(cell.submit(goal));
  EXPECT_THAT(activeIds(), ::testing::ElementsAre(21, 22, 23));
}

}  // namespace
}  // namespace cobot_command::testing
