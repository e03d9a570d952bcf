#include "runs/command_reports.h"

#include <gtest/gtest.h>

namespace cobot_command::command {
namespace {

using namespace std::chrono_literals;
using blocks::Phase;

constexpr Instant kStart{100s};

TEST(CommandReports, tellWhatIsNewSinceTheLastCall) {
  CommandReports reports(7, std::nullopt);
  reports.tell(Phase::Sent, "sent", 0s, kStart);
  reports.tell(Phase::Active, "executed", 0s, kStart);
  const auto told = reports.take();
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(told[0].phase, Phase::Sent);
  EXPECT_EQ(told[1].phase, Phase::Active);
  EXPECT_EQ(told[1].command_id_ack, 7);
  EXPECT_EQ(told[1].text, "executed");
  EXPECT_EQ(told[1].planned, std::nullopt) << "nobody knows how long it takes";
  EXPECT_EQ(told[1].fraction, 0.0);
  EXPECT_EQ(reports.phase(), Phase::Active);
  EXPECT_TRUE(reports.take().empty());
}

TEST(CommandReports, tellHowFarAPlannedMotionIs) {
  CommandReports reports(0, 4s);
  reports.tell(Phase::Active, "executed", 1s, kStart);
  reports.tell(Phase::Active, "executed", 5s, kStart);
  const auto told = reports.take();
  EXPECT_DOUBLE_EQ(told[0].fraction, 0.25);
  EXPECT_EQ(told[0].planned, 4s);
  EXPECT_EQ(told[0].remaining, 3s);
  EXPECT_LT(told[1].fraction, 1.0) << "its tag tells the end, not the clock";
  EXPECT_EQ(told[1].remaining, 0s);
}

TEST(CommandReports, tellNoFractionOfAMotionWithoutAWay) {
  CommandReports reports(0, 0s);
  reports.tell(Phase::Active, "executed", 1s, kStart);
  EXPECT_EQ(reports.take()[0].fraction, 0.0);
}

TEST(CommandReports, areDueAWhileBehindTheLastOneOfWhatIsExecuted) {
  CommandReports reports(0, 4s);
  reports.tell(Phase::Active, "executed", 0s, kStart);
  EXPECT_FALSE(reports.due(kStart + 99ms));
  EXPECT_TRUE(reports.due(kStart + 100ms));
  reports.tell(Phase::Held, "held", 0s, kStart + 100ms);
  EXPECT_FALSE(reports.due(kStart + 1h)) << "nothing changes while it is held";
}

}  // namespace
}  // namespace cobot_command::command
