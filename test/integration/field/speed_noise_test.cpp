// Joint speeds that are noise while the robot stands.
#include "field_cell.h"

#include "cobot_command/common/units.h"

namespace cobot_command::testing {
namespace {

simulator::Settings noisy() {
  simulator::Settings settings;
  settings.speed_noise = degToRad(0.1);
  return settings;
}

TEST(SpeedNoise, keepsNoGoalFromBeingPlannedAndSeen) {
  CoreAndRobot cell("tm5-900", noisy());
  cell.connect();
  cell.pass(1s);
  for (int i = 1; i <= 10; ++i) {
    const blocks::Outcome& outcome = endOf(cell, turnTo(2.0 * i));
    EXPECT_EQ(outcome.ending, blocks::Ending::Done) << outcome.error_description;
    EXPECT_TRUE(outcome.planned) << i;
    EXPECT_EQ(outcome.error_description, "");
  }
}

TEST(SpeedNoise, isNoMotionOfSomebodyElse) {
  CoreAndRobot cell("tm5-900", noisy());
  cell.connect();
  cell.pass(5s);
  EXPECT_EQ(cell.status().diagnosis.find("moves"), std::string::npos) << cell.status().diagnosis;
  EXPECT_TRUE(cell.scripts().empty()) << "nothing was to be stopped";
}

/// Where it starts nobody knows.
TEST(SpeedNoise, ofARobotThatMovesIsSaidByWhatGoesUnplanned) {
  CoreAndRobot cell;
  cell.connect();
  blocks::RunScriptGoal other;  // of which this layer does not know where it ends
  other.script = "PTP(\"JPP\",30,0,90,0,90,0,10 + IO[\"ControlBox\"].DI[0],200,0,false)";
  const blocks::Outcome& before = endOf(cell, other);
  EXPECT_EQ(before.ending, blocks::Ending::Done) << before.error_description;
  EXPECT_THAT(before.error_description, HasSubstr("the command layer cannot interpret its lines"));
  cell.pass(500ms);
  blocks::MoveRelativeGoal up;
  up.movement_command = static_cast<int>(blocks::Movement::Line);
  up.target = {0, 0, 20, 0, 0, 0};
  up.speed = 50;
  up.accel_time = 200;
  const blocks::Outcome& outcome = endOf(cell, up);
  EXPECT_EQ(outcome.ending, blocks::Ending::Done) << outcome.error_description;
  EXPECT_FALSE(outcome.planned);
  EXPECT_THAT(outcome.error_description,
              HasSubstr("sent unplanned and unchecked: the robot moves, and its destination is unknown"));
}

}  // namespace
}  // namespace cobot_command::testing
