// Paths as motions of a script, one for each point.
#include "path_goals.h"
#include <gmock/gmock.h>

#include "cobot_command/common/units.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using ::testing::HasSubstr;

class LoadPathScript : public LoadPathCell {
 protected:
  static LoadPathGoal asScript(LoadPathGoal goal) {
    goal.execution = static_cast<int>(Execution::Script);
    goal.allow_approximation = true;
    return goal;
  }
  /// Lines with a tool that is not the active one.
  static LoadPathGoal withTool(int points) {
    LoadPathGoal goal;
    for (int i = 1; i <= points; ++i) {
      path::PathPoint point = pathLine({417.5, -122.3, 400 + 10.0 * i, 180, 0, 90});
      point.pose_type = static_cast<int>(path::MovedFrame::Tool);
      point.pose_id = 0;
      point.ref_frame_type = static_cast<int>(path::Reference::Robot);
      goal.path.push_back(point);
    }
    goal.number_of_moves = points;
    return asScript(goal);
  }
  /// The active TCP is another one than that of the path.
  void changeTcp() {
    ChangeTcpGoal tcp;
    tcp.tcp_offset = {0, 0, 30, 0, 0, 0};
    tcp.weight = 1;
    expectDone(cell.submit(tcp));
  }
  [[nodiscard]] double tcpHeight() { return cell.robot().tcp.translation().z(); }
};

/// Oracle 25.
TEST_F(LoadPathScript, isRefusedWithTheListOfWhatItCannotSay) {
  LoadPathGoal goal = asScript(turns(1, false));
  goal.allow_approximation = false;
  goal.path[0].profile_type = static_cast<int>(path::ProfileType::ModSine);
  goal.path[0].acceleration_jerk = goal.path[0].deceleration_jerk = 100;
  const GoalId id = cell.submit(goal);
  const Outcome& outcome = cell.endOf(id);
  EXPECT_EQ(outcome.error_id, 0x271);
  EXPECT_THAT(outcome.error_description, HasSubstr("MOD_SINE"));
  EXPECT_TRUE(cell.scripts().empty());
}

TEST_F(LoadPathScript, tellsWhatItSaysOtherwise) {
  LoadPathGoal goal = asScript(turns(1, false));
  goal.path[0].speed = 50;
  goal.path[0].acceleration = goal.path[0].deceleration = 100;
  const GoalId id = cell.submit(goal);
  expectDone(id);
  ASSERT_EQ(cell.scripts().size(), 1U);
  EXPECT_THAT(cell.scripts()[0], HasSubstr("PTP(\"JPP\",3,0,90,0,90,0,27,500,"));
  EXPECT_EQ(reportOf(id).execution, Execution::Script);
  EXPECT_FALSE(reportOf(id).approximations.empty());
}

TEST_F(LoadPathScript, hasFivePointsAtTheControllerBesideTheActiveOne) {
  const GoalId id = cell.submit(asScript(turns(10, true)));
  EXPECT_EQ(cell.scripts().size(), 6U);
  for (const std::string& script : cell.scripts()) EXPECT_THAT(script, HasSubstr("QueueTag("));
  expectDone(id);
  EXPECT_EQ(cell.scripts().size(), 10U);
  EXPECT_NEAR(radToDeg(cell.robot().joints[0]), 30, 0.01);
}

TEST_F(LoadPathScript, blendsFromPointToPoint) {
  const GoalId blended = cell.submit(asScript(turns(10, true)));
  expectDone(blended);
  EXPECT_TRUE(reportOf(blended).blends_lost.empty());
  const Duration with_blends = *cell.outcome(blended)->actual;
  expectDone(cell.submit(asScript(turns(1, false, -1))));
  const GoalId stopped = cell.submit(asScript(turns(10, false)));
  expectDone(stopped);
  EXPECT_LT(toSeconds(with_blends), 0.8 * toSeconds(*cell.outcome(stopped)->actual));
}

TEST_F(LoadPathScript, isWhatAutoChoosesOnceTheControllerHasRefusedToEnterAPvt) {
  LoadPathGoal goal = asScript(turns(3, false));
  goal.execution = static_cast<int>(Execution::Auto);
  cell.operate(simulator::SetFault{"refuse_script", true, 1, 0, "1"});
  const GoalId refused = cell.submit(goal);
  EXPECT_EQ(cell.endOf(refused).error_id, motion_error::kRejected);
  EXPECT_EQ(reportOf(refused).execution, Execution::Pvt);
  const GoalId other = cell.submit(goal);
  expectDone(other);
  EXPECT_EQ(reportOf(other).execution, Execution::Script);
  EXPECT_EQ(reportOf(other).execution_reason, "the controller has refused to enter a PVT");
}

TEST_F(LoadPathScript, isNotChosenByAutoForWhatWasRefusedOnAnotherLink) {
  LoadPathGoal goal = turns(3, false);
  GoalId link{};
  const auto execution_after = [&](const std::function<void()>& end_link) {
    cell.operate(simulator::SetFault{"refuse_script", true, 1, 0, "1"});
    EXPECT_EQ(cell.endOf(cell.submit(goal)).error_id, motion_error::kRejected);
    end_link();
    link = cell.connect();
    const GoalId id = cell.submit(goal);
    expectDone(id);
    return reportOf(id).execution;
  };
  EXPECT_EQ(execution_after([&] { cell.dropConnections(); }), Execution::Pvt)
      << "another controller may be there";
  EXPECT_EQ(execution_after([&] {
              cell.cancel(link);
              cell.endOf(link);
            }),
            Execution::Pvt)
      << "closed on purpose";
}

TEST_F(LoadPathScript, isJoinedByOtherGoals) {
  const GoalId first = cell.submit(asScript(turns(4, true)));
  const GoalId second = cell.submit(asScript(turns(4, true, 4)));
  expectDone(first);
  expectDone(second);
  EXPECT_NEAR(radToDeg(cell.robot().joints[0]), 24, 0.01);
}

TEST_F(LoadPathScript, beginsAtRestBehindAPvtAndAPvtBehindIt) {
  const GoalId first = cell.submit(turns(4, true));
  const GoalId second = cell.submit(asScript(turns(4, true, 4)));
  const GoalId third = cell.submit(turns(4, true, 8));
  expectDone(first);
  expectDone(second);
  expectDone(third);
  EXPECT_NEAR(radToDeg(cell.robot().joints[0]), 36, 0.01);
  EXPECT_THAT(reportOf(first).blends_lost, ::testing::ElementsAre(3));
}

TEST_F(LoadPathScript, leavesBaseAndTcpAsTheyWere) {
  changeTcp();
  const GoalId id = cell.submit(withTool(3));
  expectDone(id);
  EXPECT_THAT(cell.scripts().front() + cell.scripts()[1], HasSubstr("ChangeTCP"));
  cell.pass(100ms);
  EXPECT_NEAR(tcpHeight(), 0.03, 1e-9);
}

TEST_F(LoadPathScript, leavesThemSoWhenItIsCancelled) {
  changeTcp();
  const GoalId id = cell.submit(withTool(5));
  passUntilActive(id, 1);
  cell.cancel(id);
  EXPECT_EQ(cell.endOf(id).ending, Ending::CommandAborted);
  cell.pass(100ms);
  EXPECT_NEAR(tcpHeight(), 0.03, 1e-9);
}

TEST_F(LoadPathScript, isCancelledOnceHoweverOftenThatIsAskedFor) {
  changeTcp();
  const GoalId id = cell.submit(withTool(5));
  passUntilActive(id, 1);
  cell.cancel(id);
  while (cell.outcome(id) == nullptr) {
    cell.cancel(id);
    cell.pass(1ms);
  }
  cell.pass(100ms);
  EXPECT_NEAR(tcpHeight(), 0.03, 1e-9);
}

TEST_F(LoadPathScript, leavesTheOpenEndInFrontOfItSentOnce) {
  LoadPathGoal goal = turns(4, false);
  goal.path[3].termination_type = static_cast<int>(path::Termination::Blend);
  goal.path[3].command_tolerance = 50;
  const GoalId first = cell.submit(goal);
  const GoalId second = cell.submit(asScript(turns(4, true, 4)));
  passUntilActive(first, 2);
  ASSERT_EQ(cell.scripts().size(), 4U) << "the open end is out, and the script is not";
  cell.cancel(second);
  expectDone(first);
  cell.pass(2s);
  EXPECT_EQ(cell.scripts().size(), 4U);
}

TEST_F(LoadPathScript, hasTagsEnoughBehindTwoPvts) {
  const GoalId first = cell.submit(turns(9, false));
  LoadPathGoal blended = turns(20, true, 9);
  const GoalId second = cell.submit(blended);
  const GoalId third = cell.submit(asScript(turns(8, true, 2)));
  expectDone(first);
  expectDone(second);
  expectDone(third);
}

TEST_F(LoadPathScript, endsWithTheLinkThoughNothingCanBeSetBackThen) {
  changeTcp();
  const GoalId id = cell.submit(withTool(5));
  passUntilActive(id, 1);
  cell.dropConnections();
  EXPECT_EQ(cell.endOf(id).error_id, 1002);
}

TEST_F(LoadPathScript, endsWithTheCoreThoughNothingIsSetBackThen) {
  changeTcp();
  const GoalId first = cell.submit(withTool(5));
  const GoalId second = cell.submit(withTool(2));
  passUntilActive(first, 1);
  cell.shutDown();
  ASSERT_NE(cell.outcome(first), nullptr);
  ASSERT_NE(cell.outcome(second), nullptr);
}

}  // namespace
}  // namespace cobot_command::testing
