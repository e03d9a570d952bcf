#include "runs/command_reports.h"

#include <gtest/gtest.h>

namespace cobot_command::command {
namespace {

using namespace std::chrono_literals;
using blocks::Phase;

constexpr Instant kStart{100s};

class CommandReportsTest : public ::testing::Test {
 protected:
  /// It has been executed for so long at kStart.
  CommandReports& planned(Duration duration, Duration executed = 0s) {
    order.plan.emplace();
    order.plan->duration = duration;
    clock.execute(kStart - executed);
    return reports;
  }

  CommandOrder order;
  robot::RobotWatch robot;
  CommandClock clock{kStart - 10s, 300s};
  CommandReports reports{order, robot, clock, nullptr};
};

TEST_F(CommandReportsTest, tellWhatIsNewSinceTheLastCall) {
  order.command_id_ack = 7;
  reports.tell(Phase::Sent, "sent", kStart);
  reports.tell(Phase::Active, "executed", kStart);
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

TEST_F(CommandReportsTest, tellHowFarAPlannedMotionIs) {
  planned(4s, 1s).tell(Phase::Active, "executed", kStart);
  reports.tell(Phase::Active, "executed", kStart + 4s);
  const auto told = reports.take();
  EXPECT_DOUBLE_EQ(told[0].fraction, 0.25);
  EXPECT_EQ(told[0].planned, 4s);
  EXPECT_EQ(told[0].remaining, 3s);
  EXPECT_LT(told[1].fraction, 1.0) << "its tag tells the end, not the clock";
  EXPECT_EQ(told[1].remaining, 0s);
}

TEST_F(CommandReportsTest, tellNoFractionOfAMotionWithoutAWay) {
  planned(0s, 1s).tell(Phase::Active, "executed", kStart);
  EXPECT_EQ(reports.take()[0].fraction, 0.0);
}

TEST_F(CommandReportsTest, areDueAWhileBehindTheLastOneOfWhatIsExecuted) {
  planned(4s).tell(Phase::Active, "executed", kStart);
  EXPECT_FALSE(reports.due(kStart + 99ms));
  EXPECT_TRUE(reports.due(kStart + 100ms));
  reports.tell(Phase::Held, "held", kStart + 100ms);
  EXPECT_FALSE(reports.due(kStart + 1h)) << "nothing changes while it is held";
}

}  // namespace
}  // namespace cobot_command::command
