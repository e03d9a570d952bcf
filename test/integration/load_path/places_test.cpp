// Where the points of a goal are on their way, in the words of the instruction.
#include "path_goals.h"
#include <gmock/gmock.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;

class LoadPathPlaces : public LoadPathCell {};

/// Oracle 17.
TEST_F(LoadPathPlaces, ofASectionGoThroughABufferOfFive) {
  LoadPathGoal goal = turns(20, true);
  goal.start_index = 5;
  goal.number_of_moves = 10;
  const GoalId id = cell.submit(goal);
  expectDone(id);
  std::vector<int> active;
  for (const PathPlace& place : placesOf(id)) {
    const int n = place.done_path_points + place.queued_path_points + place.pending_path_points;
    EXPECT_LE(place.queued_path_points, 5);
    EXPECT_GE(n + 2, 10);
    EXPECT_LE(n, 10);
    EXPECT_EQ(place.loaded, place.pending_path_points == 0);
    if (place.active_path_point < 0) continue;
    if (active.empty() || active.back() != place.active_path_point) active.push_back(place.active_path_point);
    if (place.active_path_point == 5 && n == 9) {
      EXPECT_EQ(place.queued_path_points, 5);
      EXPECT_EQ(place.pending_path_points, 4);
    }
    EXPECT_EQ(place.loaded, place.active_path_point + 5 + (n < 9 ? 1 : 0) >= 14);
  }
  EXPECT_THAT(active, ::testing::ElementsAre(5, 6, 7, 8, 9, 10, 11, 12, 13, 14));
}

TEST_F(LoadPathPlaces, tellTheMoveIdsOfTheGoal) {
  LoadPathGoal goal = turns(3, false);
  goal.path[1].move_id = 77;
  const GoalId first = cell.submit(turns(1, false));
  expectDone(first);
  const GoalId id = cell.submit(goal);
  expectDone(id);
  std::vector<int> ids;
  for (const PathPlace& place : placesOf(id)) {
    const bool is_new = place.active && (ids.empty() || ids.back() != place.active_move_id);
    if (is_new) ids.push_back(place.active_move_id);
  }
  EXPECT_THAT(ids, ::testing::ElementsAre(2, 77, 2)) << "0 is the number of the goal, the second one";
  EXPECT_EQ(reportOf(id).method_id, 2);
}

TEST_F(LoadPathPlaces, areToldByTheStreamWhereAllPointsAreOnePvt) {
  const GoalId id = cell.submit(turns(30, true));
  expectDone(id);
  bool seen = false;
  for (const PathPlace& place : placesOf(id)) seen = seen || place.source == ProgressSource::Stream;
  EXPECT_TRUE(seen);
}

TEST_F(LoadPathPlaces, sayWhenEachPointWasDone) {
  const GoalId id = cell.submit(turns(6, true));
  expectDone(id);
  const auto& points = reportOf(id).points;
  ASSERT_EQ(points.size(), 6U);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(toSeconds(points[i].done), toSeconds(points[i].start + points[i].duration), 0.06) << i;
  }
}

TEST_F(LoadPathPlaces, areForetoldWithTheProjectSpeed) {
  cell.operate(simulator::SetProjectSpeed{50});
  cell.pass(1s);
  const GoalId id = cell.submit(turns(6, true));
  expectDone(id);
  const Outcome& outcome = cell.endOf(id);
  EXPECT_NEAR(toSeconds(*outcome.planned), toSeconds(*outcome.actual), 0.1);
  EXPECT_EQ(cell.progress(id).back().planned, outcome.planned) << "the feedback says the same";
}

}  // namespace
}  // namespace cobot_command::testing
