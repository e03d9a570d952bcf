// Breaches of the margin, and what stops all (cell.md, M35).
#include <string>

#include "watched_cell.h"
#include <gtest/gtest.h>

namespace cobot_command::cell {
namespace {

constexpr double kTiny = 1e-6;

TEST(MonitorBreach, warnsJustBelowTheMarginAndNotJustAboveIt) {
  Monitor monitor = handover();
  stand(monitor, leftAt(0.020 + kTiny), kT1, at(1));
  EXPECT_TRUE(monitor.takeActions().empty());
  stand(monitor, leftAt(0.020 - kTiny), kT1, at(2));
  const auto actions = monitor.takeActions();
  ASSERT_EQ(actions.size(), 1u);
  ASSERT_EQ(only<Warning>(actions).size(), 1u);
  EXPECT_NE(only<Warning>(actions)[0].text.find("below the margin of 20.0 mm"), std::string::npos);
  EXPECT_TRUE(monitor.status().pairs.front().breached);
  EXPECT_FALSE(monitor.latched());
}

TEST(MonitorBreach, stopsAllJustBelowTheStopDistanceAndNotJustAboveIt) {
  MonitorSettings settings;
  for (const std::optional<double> told : {std::optional<double>{}, std::optional<double>{0.015}}) {
    settings.stop_distance = told;
    const double limit = told.value_or(0.010);
    Monitor monitor = handover(settings);
    stand(monitor, leftAt(limit + kTiny), kT1, at(1));
    EXPECT_TRUE(only<StopAll>(monitor.takeActions()).empty());
    stand(monitor, leftAt(limit - kTiny), kT1, at(2));
    const auto stops = only<StopAll>(monitor.takeActions());
    ASSERT_EQ(stops.size(), 1u);
    EXPECT_NE(stops[0].why.find("below the stop distance"), std::string::npos);
    EXPECT_TRUE(monitor.latched());
  }
}

TEST(MonitorBreach, countsTheUncertaintyOfTheDistance) {
  Monitor monitor = handover();
  monitor.take("left", leftAt(0.025), arm::JointVector::Unit(0), Duration(0), at(0));
  monitor.take("right", kT1, kStanding, Duration(0), at(0));
  monitor.tick(at(0));
  EXPECT_TRUE(monitor.takeActions().empty());
  monitor.tick(at(0.010));
  EXPECT_EQ(only<Warning>(monitor.takeActions()).size(), 1u);
  EXPECT_FALSE(monitor.latched());
  monitor.tick(at(0.030));
  EXPECT_EQ(only<StopAll>(monitor.takeActions()).size(), 1u);
  EXPECT_NEAR(monitor.status().pairs.front().distance, 0.025, 1e-6);
}

TEST(MonitorBreach, isRecordedWithItsStartItsLeastAndItsEnd) {
  Monitor monitor = handover();
  stand(monitor, leftAt(0.018), kT1, at(1));
  stand(monitor, leftAt(0.012), kT1, at(2));
  stand(monitor, leftAt(0.016), kT1, at(3));
  ASSERT_EQ(monitor.breaches().size(), 1u);
  EXPECT_FALSE(monitor.breaches()[0].end.has_value());
  stand(monitor, kHome, kT1, at(4));
  const auto ended = only<BreachEnded>(monitor.takeActions());
  ASSERT_EQ(ended.size(), 1u);
  ASSERT_EQ(monitor.breaches().size(), 1u);
  for (const Breach& breach : {ended[0].breach, monitor.breaches()[0]}) {
    EXPECT_EQ(breach.first, "left");
    EXPECT_EQ(breach.second, "right");
    EXPECT_EQ(breach.start, at(1));
    EXPECT_NEAR(breach.least, 0.012, 1e-6);
    EXPECT_NEAR(breach.distance, 0.012, 1e-6);
    EXPECT_EQ(breach.least_at, at(2));
    EXPECT_EQ(breach.end, at(4));
    EXPECT_FALSE(breach.first_body.empty() || breach.second_body.empty());
  }
  EXPECT_FALSE(monitor.status().pairs.front().breached);
}

TEST(MonitorBreach, isOneWhereAPairStandsAtTheMargin) {
  Monitor monitor = handover();
  for (int i = 1; i <= 20; ++i) stand(monitor, leftAt(0.020 + (i % 2 == 0 ? kTiny : -kTiny)), kT1, at(i));
  EXPECT_EQ(monitor.takeActions().size(), 1u);
  EXPECT_EQ(monitor.breaches().size(), 1u);
}

TEST(MonitorBreach, keepsTheNewestOfManyRecords) {
  Monitor monitor = handover();
  const arm::JointVector close = leftAt(0.015);
  for (int i = 0; i < 1003; ++i) {
    stand(monitor, close, kT1, at(2 * i + 1));
    stand(monitor, kHome, kT1, at(2 * i + 2));
  }
  EXPECT_EQ(monitor.breaches().size(), 1000u);
  EXPECT_EQ(monitor.breaches().front().start, at(7));
  EXPECT_EQ(monitor.status().counts.lost_breaches, 3u);
}

TEST(MonitorLatch, lastsUntilItIsResetAndThatIsRefusedWhileItsCauseLasts) {
  Monitor monitor = handover();
  stand(monitor, kT1, kT1, at(1));
  EXPECT_TRUE(monitor.status().latched);
  EXPECT_NE(monitor.status().diagnosis.find("until the monitor is reset"), std::string::npos);
  const ResetAnswer refused = monitor.reset(at(2));
  EXPECT_FALSE(refused.success);
  EXPECT_NE(refused.message.find("below the stop distance"), std::string::npos);
  stand(monitor, kHome, kHome, at(3));
  EXPECT_TRUE(monitor.latched());
  EXPECT_TRUE(monitor.reset(at(4)).success);
  EXPECT_FALSE(monitor.latched());
  EXPECT_NE(monitor.status().diagnosis.find("The closest are left and right: 6"), std::string::npos);
  EXPECT_TRUE(monitor.reset(at(5)).success);
  static_cast<void>(monitor.takeActions());
  stand(monitor, kT1, kT1, at(6));
  EXPECT_EQ(only<StopAll>(monitor.takeActions()).size(), 1u);
}

TEST(MonitorLatch, looksAnewWhenItIsToBeReset) {
  Monitor monitor = handover();
  stand(monitor, kT1, kT1, at(1));
  monitor.take("left", kHome, kStanding, Duration(0), at(2));
  monitor.take("right", kHome, kStanding, Duration(0), at(2));
  EXPECT_TRUE(monitor.reset(at(2.001)).success);
}

TEST(MonitorLatch, stopsAgainWhatMovesNevertheless) {
  Monitor monitor = handover();
  stand(monitor, kT1, kT1, at(1));
  EXPECT_EQ(only<StopAll>(monitor.takeActions()).size(), 1u);
  for (int i = 0; i < 90; ++i) {
    const Instant now = at(1.01 + 0.01 * i);
    monitor.take("left", kT1, 0.1 * arm::JointVector::Unit(0), Duration(0), now);
    monitor.tick(now);
  }
  EXPECT_EQ(only<StopAll>(monitor.takeActions()).size(), 1u);
  for (int i = 0; i < 200; ++i) stand(monitor, kT1, kT1, at(3 + 0.01 * i));
  EXPECT_TRUE(only<StopAll>(monitor.takeActions()).empty());
}

TEST(MonitorLatch, isNoneWhereItOnlyWarns) {
  MonitorSettings settings;
  settings.mode = MonitorSettings::Mode::Warn;
  Monitor monitor = handover(settings);
  stand(monitor, kT1, kT1, at(1));
  monitor.take("left", kT1, arm::JointVector::Unit(0), Duration(0), at(2));
  monitor.tick(at(3));
  const auto actions = monitor.takeActions();
  EXPECT_TRUE(only<StopAll>(actions).empty());
  EXPECT_EQ(only<Warning>(actions).size(), 3u);
  EXPECT_FALSE(monitor.latched());
}

}  // namespace
}  // namespace cobot_command::cell
