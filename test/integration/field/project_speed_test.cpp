// A project speed that the operator changes in the moment in which a motion begins.
#include "field_cell.h"

namespace cobot_command::testing {
namespace {

struct Turn {
  double planned = 0;
  double actual = 0;
  std::string text;
};

/// In the moment in which the operator sets `percent`.
Turn turnAt(int percent, Duration planning, bool set_first) {
  CoreAndRobot cell("tm5-900", {}, {}, planning);
  cell.connect();
  if (set_first) cell.operate(simulator::SetProjectSpeed{percent});
  const blocks::GoalId id = cell.submit(turnTo(20));
  if (!set_first) cell.operate(simulator::SetProjectSpeed{percent});
  const blocks::Outcome& outcome = cell.endOf(id);
  EXPECT_EQ(outcome.ending, blocks::Ending::Done) << outcome.error_description;
  return {toSeconds(outcome.planned.value_or(0s)), toSeconds(outcome.actual.value_or(0s)),
          outcome.error_description};
}

TEST(ProjectSpeed, thatIsSetAsAMotionBeginsIsTheOneOfItsPlan) {
  for (const Duration planning : {Duration::zero(), Duration(20ms)}) {
    const Turn turn = turnAt(10, planning, true);
    EXPECT_NEAR(turn.actual, turn.planned, 0.05);
    EXPECT_GT(turn.planned, 2);
    if (turn.text.empty()) continue;  // it was seen before the motion was sent
    EXPECT_THAT(turn.text, HasSubstr("planned for 0.42 s at the project speed of 100 %"));
    EXPECT_THAT(turn.text, HasSubstr("at 10 %, which the status stream showed when it began"));
  }
}

TEST(ProjectSpeed, thatIsRaisedAsAMotionBeginsIsTheOneOfItsPlan) {
  simulator::Settings slow;
  slow.project_speed_percent = 10;
  CoreAndRobot cell("tm5-900", slow);
  cell.connect();
  cell.operate(simulator::SetProjectSpeed{100});
  const blocks::Outcome& outcome = endOf(cell, turnTo(20));
  EXPECT_NEAR(toSeconds(*outcome.actual), toSeconds(*outcome.planned), 0.05);
  EXPECT_LT(*outcome.planned, 1s);
}

/// The controller made the motion as it was planned.
TEST(ProjectSpeed, thatIsSetWhileAMotionIsUnderWayIsNotTheOneOfItsPlan) {
  CoreAndRobot cell;
  cell.connect();
  const blocks::GoalId id = cell.submit(turnTo(60));
  cell.pass(200ms);
  cell.operate(simulator::SetProjectSpeed{10});
  const blocks::Outcome& outcome = cell.endOf(id);
  EXPECT_NEAR(toSeconds(*outcome.actual), toSeconds(*outcome.planned), 0.05);
  EXPECT_EQ(outcome.error_description, "");
}

}  // namespace
}  // namespace cobot_command::testing
