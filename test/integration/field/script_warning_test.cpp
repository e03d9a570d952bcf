// Lines that the controller takes with a warning.
#include "field_cell.h"

namespace cobot_command::testing {
namespace {

blocks::RunScriptGoal script(const std::string& lines) {
  blocks::RunScriptGoal goal;
  goal.script = lines;
  return goal;
}

TEST(ScriptWarnings, areInTheResultAndAMessage) {
  CoreAndRobot cell;
  cell.connect();
  const blocks::Outcome& outcome = endOf(cell, script("IO[ControlBox].DO[0]=1"));
  EXPECT_EQ(outcome.ending, blocks::Ending::Done);
  const std::string warning = "the controller warns of line 1: IO[ControlBox].DO[0]=1";
  EXPECT_THAT(outcome.error_description, HasSubstr(warning));
  ASSERT_FALSE(cell.messages().empty());
  const command::Message& message = cell.messages().back();
  EXPECT_EQ(message.severity, command::Severity::Warning);
  EXPECT_EQ(message.type, command::MessageType::Command);
  EXPECT_EQ(message.origin, "run_script");
  EXPECT_EQ(message.text, warning);
  EXPECT_FALSE(message.remedy.empty());
}

TEST(ScriptWarnings, areNoneWhereTheControllerHasNone) {
  CoreAndRobot cell;
  cell.connect();
  const blocks::Outcome& outcome = endOf(cell, script("IO[\"ControlBox\"].DO[0]=1"));
  EXPECT_EQ(outcome.error_description.find("warns"), std::string::npos) << outcome.error_description;
  EXPECT_TRUE(cell.messages().empty());
}

}  // namespace
}  // namespace cobot_command::testing
