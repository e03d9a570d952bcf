// What the monitor has found, as it is told.
#include "cell_watch/distance_messages.h"

#include "cell_watch/pictures/watch_view.h"
#include <gmock/gmock.h>

namespace cobot_command::ros_adapter {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Level = diagnostic_msgs::DiagnosticStatus;
using Mode = cell::MonitorSettings::Mode;

cell::PairStatus pairAt(double distance) {
  cell::PairStatus pair;
  pair.first = "RA";
  pair.second = "RB";
  pair.known = true;
  pair.distance = distance;
  pair.uncertainty = 0.003;
  pair.first_body = "tool";
  pair.second_body = "link_3";
  pair.least = 0.04;
  return pair;
}

WatchView viewOf(const cell::PairStatus& pair) {
  WatchView view;
  view.status.pairs = {pair};
  view.status.diagnosis = "how it stands";
  view.movers = {{"RA", "/RA", "/RA/joint_states", true, true, "sheet"},
                 {"RB", "/RB", "/RB/joint_states", true, true, ""},
                 {"PALLET", "/plc", "/plc/position", true, true, ""}};
  return view;
}

diagnostic_updater::DiagnosticStatusWrapper described(const WatchView& view) {
  diagnostic_updater::DiagnosticStatusWrapper status;
  describeMonitor(status, view, Mode::Stop);
  return status;
}

TEST(DistanceMessages, takeWhatIsUncertainOffTheDistance) {
  cell::MonitorStatus status;
  status.pairs = {pairAt(0.05)};
  status.diagnosis = "how it stands";
  const auto message = toMessage(status);
  ASSERT_EQ(message.pairs.size(), 1U);
  const auto& pair = message.pairs.front();
  EXPECT_EQ(pair.robot, "RA");
  EXPECT_EQ(pair.other, "RB");
  EXPECT_TRUE(pair.known);
  EXPECT_TRUE(pair.exact);
  EXPECT_DOUBLE_EQ(pair.now, 0.047);
  EXPECT_DOUBLE_EQ(pair.uncertainty, 0.003);
  EXPECT_DOUBLE_EQ(pair.least, 0.04);
  EXPECT_EQ(pair.robot_body, "tool");
  EXPECT_EQ(pair.other_body, "link_3");
  EXPECT_FALSE(pair.breached);
  EXPECT_FALSE(message.alarmed);
  EXPECT_EQ(message.text, "how it stands");
}

TEST(DistanceMessages, sayThatAPairIsNotKnown) {
  cell::MonitorStatus status;
  status.pairs = {pairAt(0.05)};
  status.pairs.front().known = false;
  status.latched = true;
  const auto message = toMessage(status);
  EXPECT_FALSE(message.pairs.front().known);
  EXPECT_EQ(message.pairs.front().now, 0);
  EXPECT_TRUE(message.alarmed);
}

TEST(DistanceMessages, tellOfABreachHowLongAndHowClose) {
  cell::Breach breach;
  breach.first = "RA";
  breach.second = "RB";
  breach.first_body = "tool";
  breach.second_body = "link_3";
  breach.start = Instant(std::chrono::seconds(10));
  breach.end = Instant(std::chrono::milliseconds(11500));
  breach.distance = 0.015;
  breach.least = 0.012;
  EXPECT_THAT(sentenceOf(breach), HasSubstr("for 1.50 s: minimum 15.0 mm, 12.0 mm"));
}

TEST(DiagnosticsOfTheMonitor, areAnErrorWhileAllAreStopped) {
  WatchView view = viewOf(pairAt(0.05));
  view.status.latched = true;
  EXPECT_EQ(described(view).level, Level::ERROR);
  EXPECT_EQ(described(view).message, "how it stands");
}

TEST(DiagnosticsOfTheMonitor, warnOfABreachAndOfRobotsThatItCannotHearOrStop) {
  cell::PairStatus breached = pairAt(0.015);
  breached.breached = true;
  EXPECT_EQ(described(viewOf(breached)).level, Level::WARN);
  WatchView unheard = viewOf(pairAt(0.05));
  unheard.movers[1].is_heard = false;
  EXPECT_EQ(described(unheard).level, Level::WARN);
  EXPECT_THAT(described(unheard).message, HasSubstr("RB has not reported yet on /RB/joint_states"));
  WatchView silent = viewOf(pairAt(0.05));
  silent.movers[2].is_heard = false;
  EXPECT_THAT(described(silent).message, HasSubstr("PALLET has not reported yet on /plc/position"));
  WatchView deaf = viewOf(pairAt(0.05));
  deaf.movers[0].takes_stops = false;
  EXPECT_EQ(described(deaf).level, Level::WARN);
  EXPECT_THAT(described(deaf).message, HasSubstr("no node in /RA/ accepts stop goals of RA"));
}

TEST(DiagnosticsOfTheMonitor, areFineOtherwiseAndHaveTheDistances) {
  const auto status = described(viewOf(pairAt(0.05)));
  EXPECT_EQ(status.level, Level::OK);
  std::string all;
  for (const auto& value : status.values) all += value.key + "=" + value.value + "\n";
  EXPECT_THAT(all, HasSubstr("RA and RB=50.0 mm, minimum 40.0 mm"));
  EXPECT_THAT(all, HasSubstr("mode=stop"));
  EXPECT_THAT(all, HasSubstr("carried by RA=sheet"));
  EXPECT_THAT(all, Not(HasSubstr("carried by RB"))) << "it never carries anything";
}

}  // namespace
}  // namespace cobot_command::ros_adapter
