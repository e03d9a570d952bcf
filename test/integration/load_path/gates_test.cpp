// Goals that wait for tracking objects.
#include "path_goals.h"
#include <gmock/gmock.h>

#include "cobot_command/common/units.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using ::testing::HasSubstr;

class LoadPathGates : public LoadPathCell {
 protected:
  [[nodiscard]] static LoadPathGoal wanting(path::TrackingFlags tracking, int points = 3, int from = 0) {
    LoadPathGoal goal = turns(points, true, from);
    goal.enable_tracking = tracking;
    return goal;
  }
  [[nodiscard]] Phase phaseOf(GoalId id) {
    const auto& told = cell.progress(id);
    return told.empty() ? Phase::Sent : told.back().phase;
  }
  [[nodiscard]] bool waits(GoalId id) {
    return cell.accepted(id) && phaseOf(id) == Phase::WaitingForTracking;
  }
  void expectNothingLoaded(GoalId id) {
    ASSERT_FALSE(placesOf(id).empty());
    const PathPlace place = placesOf(id).back();
    EXPECT_TRUE(place.waits_for_tracking);
    EXPECT_FALSE(place.loaded);
    EXPECT_EQ(place.queued_path_points, 0);
    EXPECT_EQ(place.done_path_points, 0);
  }
};

/// Oracle 21.
TEST_F(LoadPathGates, holdBackAllFramesUntilTheObjectIsOn) {
  const GoalId id = cell.submit(wanting({true, false}));
  cell.pass(30s);
  EXPECT_TRUE(waits(id));
  expectNothingLoaded(id);
  EXPECT_THAT(cell.progress(id).back().text, HasSubstr("tracking object 0 to be on"));
  EXPECT_TRUE(cell.scripts().empty());
  EXPECT_FALSE(cell.switchTracking({0, true, false}));
  EXPECT_EQ(cell.scripts().size(), 1U) << "the first frame leaves at once";
  expectDone(id);
}

TEST_F(LoadPathGates, areClosedToAGoalWithoutFlagsUntilBothHaveStopped) {
  EXPECT_FALSE(cell.switchTracking({0, true, false}));
  EXPECT_FALSE(cell.switchTracking({1, true, false}));
  const GoalId id = cell.submit(wanting({false, false}));
  cell.pass(1s);
  EXPECT_THAT(cell.progress(id).back().text, HasSubstr("tracking object 0 to be off and tracking object 1"));
  EXPECT_FALSE(cell.switchTracking({0, false, false}));
  EXPECT_TRUE(waits(id));
  EXPECT_FALSE(cell.switchTracking({1, false, false}));
  expectDone(id);
}

/// Oracle 21.
TEST_F(LoadPathGates, areOpenedByAnAutomaticObjectWithTheLastPointInFront) {
  EXPECT_FALSE(cell.switchTracking({0, false, true}));
  const GoalId first = cell.submit(wanting({false, false}));
  const GoalId second = cell.submit(wanting({true, false}, 3, 3));
  ASSERT_TRUE(cell.passUntil([&] { return activeOf(first) == 0; }));
  EXPECT_FALSE(cell.controls().tracking[0].on);
  ASSERT_TRUE(cell.passUntil([&] { return activeOf(first) == 2; }));
  EXPECT_TRUE(cell.controls().tracking[0].on);
  ASSERT_TRUE(cell.passUntil([&] { return cell.outcome(first) != nullptr; }));
  EXPECT_NEAR(radToDeg(cell.robot().joints[0]), 9, 0.01) << "the robot stands between them";
  expectDone(second);
  EXPECT_THAT(reportOf(first).blends_lost, ::testing::ElementsAre(2));
  EXPECT_TRUE(cell.controls().tracking[0].on) << "until a goal wants it off";
  expectDone(cell.submit(wanting({false, false}, 1, 6)));
  EXPECT_FALSE(cell.controls().tracking[0].on);
}

TEST_F(LoadPathGates, leaveObjectsAloneThatAreNotAutomatic) {
  EXPECT_FALSE(cell.switchTracking({0, false, true}));
  const GoalId id = cell.submit(wanting({true, true}));
  cell.pass(10s);
  EXPECT_TRUE(cell.controls().tracking[0].on) << "nothing is in front that has to end first";
  EXPECT_FALSE(cell.controls().tracking[1].on);
  EXPECT_TRUE(waits(id));
  EXPECT_FALSE(cell.switchTracking({1, true, false}));
  expectDone(id);
}

TEST_F(LoadPathGates, holdBackOnlyWhatIsBehindThem) {
  const GoalId first = cell.submit(wanting({false, false}));
  const GoalId second = cell.submit(wanting({true, false}, 3, 3));
  const GoalId third = cell.submit(wanting({true, false}, 3, 6));
  expectDone(first);
  cell.pass(1min);
  EXPECT_TRUE(waits(second));
  EXPECT_EQ(phaseOf(third), Phase::Queued);
  EXPECT_EQ(placesOf(third).back().pending_path_points, 3);
  EXPECT_EQ(cell.progress(third).back().text,
            "after load_path 2, which waits for tracking object 0 to be on");
  EXPECT_FALSE(cell.switchTracking({0, true, false}));
  expectDone(second);
  expectDone(third);
  EXPECT_TRUE(reportOf(second).blends_lost.empty()) << "the same flags: they go on as one";
}

TEST_F(LoadPathGates, arePassedOnceTheFirstPointIsInTheBuffer) {
  EXPECT_FALSE(cell.switchTracking({0, true, false}));
  LoadPathGoal goal = turns(20, false);  // each is sent by itself
  goal.enable_tracking = {true, false};
  const GoalId id = cell.submit(goal);
  passUntilActive(id, 3);
  EXPECT_FALSE(cell.switchTracking({0, false, false}));
  expectDone(id);
}

TEST_F(LoadPathGates, closeAgainForAGoalThatIsNotInTheBuffer) {
  EXPECT_FALSE(cell.switchTracking({0, true, false}));
  LoadPathGoal goal = turns(20, false);
  goal.enable_tracking = {true, false};
  const GoalId first = cell.submit(goal);
  const GoalId second = cell.submit(wanting({true, false}, 3, 20));
  passUntilActive(first, 3);
  EXPECT_FALSE(cell.switchTracking({0, false, false}));
  expectDone(first);
  EXPECT_TRUE(waits(second));
}

TEST_F(LoadPathGates, letAGoalBeCancelledAtOnce) {
  const GoalId id = cell.submit(wanting({true, false}));
  cell.pass(1s);
  cell.cancel(id);
  ASSERT_NE(cell.outcome(id), nullptr);
  EXPECT_EQ(cell.outcome(id)->ending, Ending::CommandAborted);
  EXPECT_TRUE(cell.scripts().empty());
}

TEST_F(LoadPathGates, letAStopEndAGoalThatWaitsAsNotLoaded) {
  const GoalId id = cell.submit(wanting({true, false}));
  cell.pass(1s);
  cell.endOf(cell.submit(StopGoal()));
  EXPECT_EQ(cell.endOf(id).error_id, load_path_error::kInterrupted);
  EXPECT_EQ(reportOf(id).error_index, 0);
}

TEST_F(LoadPathGates, letALostLinkEndAGoalThatWaits) {
  const GoalId id = cell.submit(wanting({true, false}));
  cell.pass(1s);
  cell.dropConnections();
  EXPECT_EQ(cell.endOf(id).error_id, 1002);
}

TEST_F(LoadPathGates, areOfTwoObjects) {
  for (const int object : {-1, 2}) {
    EXPECT_THAT(cell.switchTracking({object, true, false}).value_or(""), HasSubstr("allowed: 0 to 1"));
  }
  EXPECT_EQ(cell.controls(), path::PathControls());
}

}  // namespace
}  // namespace cobot_command::testing
