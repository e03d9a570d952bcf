// Goals for paths of a TM5-900 that stands at J = 0 0 90 0 90 0.
#pragma once

#include "block_goals.h"
#include "core_and_robot.h"
#include <gtest/gtest.h>

#include "cobot_command/blocks/load_path.h"

namespace cobot_command::testing {

using namespace std::chrono_literals;

/// Joint 1 goes on by 3 degrees with each point; blended, or with a stop at each.
inline blocks::LoadPathGoal turns(int points, bool blended, int from = 0) {
  blocks::LoadPathGoal goal;
  for (int i = 1; i <= points; ++i) {
    path::PathPoint point = pathPoint({3.0 * (from + i), 0, 90, 0, 90, 0});
    if (blended) {
      point.termination_type = static_cast<int>(path::Termination::Blend);
      point.command_tolerance = 50;
    }
    goal.path.push_back(point);
  }
  goal.number_of_moves = points;
  return goal;
}

class LoadPathCell : public ::testing::Test {
 protected:
  explicit LoadPathCell(const simulator::Settings& settings = {}) : cell("tm5-900", settings) {
    cell.connect();
  }
  [[nodiscard]] const blocks::PathReport& reportOf(blocks::GoalId id) {
    return cell.endOf(id).detail.as<blocks::PathReport>();
  }
  [[nodiscard]] std::vector<blocks::PathPlace> placesOf(blocks::GoalId id) {
    std::vector<blocks::PathPlace> places;
    for (const blocks::Progress& progress : cell.progress(id)) {
      if (const auto* place = progress.detail.find<blocks::PathPlace>()) places.push_back(*place);
    }
    return places;
  }
  [[nodiscard]] int activeOf(blocks::GoalId id) {
    const auto places = placesOf(id);
    return places.empty() ? -1 : places.back().active_path_point;
  }
  void passUntilActive(blocks::GoalId id, int point) {
    ASSERT_TRUE(cell.passUntil([&] { return activeOf(id) >= point; }, 1min)) << "point " << point;
  }
  void expectDone(blocks::GoalId id) {
    const blocks::Outcome& outcome = cell.endOf(id);
    EXPECT_EQ(outcome.ending, blocks::Ending::Done)
        << "goal " << id << ": " << outcome.error_id << " " << outcome.error_description;
  }

  CoreAndRobot cell;
};

}  // namespace cobot_command::testing
