// A controller whose data table has few of the items that every data table should have.
#include <algorithm>

#include "block_goals.h"
#include "field_cell.h"

namespace cobot_command::testing {
namespace {

simulator::Settings streaming(std::vector<std::string> items) {
  simulator::Settings settings;
  settings.stream_items = std::move(items);
  return settings;
}

simulator::Settings sparse() {
  return streaming({"Robot_Link", "Robot_Error", "Project_Run", "Project_Pause", "Error_Code"});
}

simulator::Settings without(const std::string& name) {
  simulator::Settings settings;
  auto& items = settings.stream_items;
  items.erase(std::remove(items.begin(), items.end(), name), items.end());
  return settings;
}

TEST(SparseStream, isNamedWithAllThatCannotBeDone) {
  CoreAndRobot cell("tm5-900", sparse());
  cell.connect();
  cell.pass(1s);
  for (const char* missing : {"Joint_Angle (no joint_states; moves are sent unplanned", "ESTOP (",
                              "Safeguard_A (", "Project_Speed (", "Base_Value (", "MA_Mode ("}) {
    EXPECT_THAT(cell.status().status_diagnosis, HasSubstr(missing));
  }
  EXPECT_EQ(cell.status().status_diagnosis.find("Project_Run ("), std::string::npos) << "it has that";
  EXPECT_THAT(cell.status().diagnosis, HasSubstr("does not have Safeguard_A, ESTOP, Joint_Angle, so only "
                                                 "their queue tags report that motions are done"));
  ASSERT_EQ(cell.messages().size(), 1U) << "once";
  EXPECT_EQ(cell.messages()[0].severity, command::Severity::Warning);
  EXPECT_EQ(cell.messages()[0].origin, "status_stream");
  EXPECT_TRUE(cell.messages()[0].pending);
  EXPECT_THAT(cell.messages()[0].text, HasSubstr("Joint_Angle"));
  EXPECT_THAT(cell.messages()[0].remedy, HasSubstr("Ethernet Slave"));
}

TEST(SparseStream, isSaidByTheResultOfAMoveThatNobodyHasSeen) {
  CoreAndRobot cell("tm5-900", sparse());
  cell.connect();
  const blocks::Outcome& outcome = endOf(cell, turnTo(20));
  EXPECT_EQ(outcome.ending, blocks::Ending::Done);
  EXPECT_THAT(outcome.error_description,
              HasSubstr("sent unplanned and unchecked: the status stream does not have Joint_Angle"));
  EXPECT_THAT(outcome.error_description,
              HasSubstr("its end position was not confirmed: only its queue tag reports that it is done"));
}

TEST(SparseStream, isSaidByTheResultOfAMoveThatWasOnlySeenToStand) {
  CoreAndRobot cell("tm5-900", without("Joint_Angle"));
  cell.connect();
  const blocks::Outcome& outcome = endOf(cell, turnTo(20));
  EXPECT_EQ(outcome.ending, blocks::Ending::Done);
  EXPECT_THAT(outcome.error_description,
              HasSubstr("the robot is at standstill, but its position is not known"));
  EXPECT_THAT(cell.status().diagnosis, HasSubstr("so the end positions of motions are not confirmed"));
}

TEST(SparseStream, isSaidByTheCycleOfAMoveThatNobodyHasSeen) {
  CoreAndRobot cell("tm5-900", sparse());
  cell.connect();
  blocks::PickAndPlaceGoal goal;
  goal.steps.resize(1);
  goal.steps[0].move = turnTo(20);
  goal.cycles = 2;
  const blocks::Outcome& outcome = endOf(cell, goal);
  EXPECT_EQ(outcome.ending, blocks::Ending::Done) << outcome.error_description;
  EXPECT_THAT(outcome.error_description, HasSubstr("sent unplanned and unchecked"));
}

TEST(SparseStream, isNamedByWhatIsRefusedForWantOfAnItem) {
  CoreAndRobot cell("tm5-900", sparse());
  cell.connect();
  for (const blocks::Goal& goal :
       {blocks::Goal(good<blocks::JogGoal>()), blocks::Goal(good<blocks::FollowJointTrajectoryGoal>()),
        blocks::Goal(good<blocks::LoadPathGoal>())}) {
    const blocks::Outcome& outcome = endOf(cell, goal);
    EXPECT_EQ(outcome.ending, blocks::Ending::Rejected) << toString(blockOf(goal));
    EXPECT_THAT(outcome.error_description, HasSubstr("the status stream does not have Joint_Angle: tick it"));
  }
  blocks::MoveAbsoluteGoal checked = turnTo(20);
  checked.check_only = true;
  EXPECT_THAT(endOf(cell, checked).error_description, HasSubstr("does not have Joint_Angle: tick it"));
}

TEST(SparseStream, isNoneOfAControllerWithItsPreselectedItems) {
  CoreAndRobot cell;
  cell.connect();
  cell.pass(1s);
  EXPECT_EQ(cell.status().status_diagnosis, "");
  EXPECT_EQ(endOf(cell, turnTo(20)).error_description, "");
  EXPECT_TRUE(cell.messages().empty());
}

TEST(SparseStream, isNoneAtAllWhereNobodyAsksForOne) {
  link::LinkSettings link;
  link.status_port = 0;
  CoreAndRobot cell("tm5-900", {}, link);
  cell.connect();
  EXPECT_THAT(cell.status().diagnosis, HasSubstr("no status stream shows the robot"));
  EXPECT_THAT(endOf(cell, turnTo(20)).error_description,
              HasSubstr("sent unplanned and unchecked: no status stream shows where the robot is"));
}

}  // namespace
}  // namespace cobot_command::testing
