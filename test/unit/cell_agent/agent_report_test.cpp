// What an agent tells of itself.
#include "made_path.h"
#include <gmock/gmock.h>

#include "cobot_command/cell/agent/agent.h"

namespace cobot_command::cell {
namespace {

using namespace std::chrono_literals;
using testing::EndsWith;

TEST(AnAgentsReport, isOfRightLengthHoweverLongTheReasonIs) {
  const Instant now(1h);
  const auto agent = *Agent::of(artifactOfTurn(), "R", 7);
  link::RobotStatus status;
  status.joints = turned(0);
  agent->observe(status, now);
  agent->linked(std::string(1000, 'x'), now);
  const auto report = agent->takeReport(now);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->condition, RobotCondition::Unlinked);
  EXPECT_THAT(report->text, EndsWith("..."));
  EXPECT_EQ(malformed(*report), std::nullopt);
}

}  // namespace
}  // namespace cobot_command::cell
