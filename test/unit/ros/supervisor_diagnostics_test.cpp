#include "supervision/supervisor_diagnostics.h"

#include <gmock/gmock.h>

namespace cobot_command::ros_adapter {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using ::testing::HasSubstr;

CellView allWell() {
  CellView view;
  view.status.mode = cell::SupervisorMode::Running;
  cell::RobotStatus robot;
  robot.name = "RA";
  robot.state = cell::RobotState::Moving;
  robot.place = "HOME";
  view.status.robots = {robot};
  view.status.zones = {{"Z1", {"RA", "RB"}, cell::ZoneState::Held, "RA", fromSeconds(1), {}}};
  view.wait_timeout = fromSeconds(60);
  return view;
}

diagnostic_updater::DiagnosticStatusWrapper said(
    void (*describe)(diagnostic_updater::DiagnosticStatusWrapper&, const CellView&), const CellView& view) {
  diagnostic_updater::DiagnosticStatusWrapper status;
  describe(status, view);
  return status;
}

TEST(SupervisorDiagnostics, allIsFineWhileTheCellRuns) {
  for (const auto describe : {describeMode, describeRobots, describeZones, describeReports}) {
    EXPECT_EQ(said(describe, allWell()).level, DiagnosticStatus::OK) << said(describe, allWell()).message;
  }
}

TEST(SupervisorDiagnostics, aModeThatGrantsNothingIsAWarningAndAFaultAnError) {
  CellView view = allWell();
  view.status.mode = cell::SupervisorMode::Holding;
  view.status.diagnosis = "hold was requested";
  EXPECT_EQ(said(describeMode, view).level, DiagnosticStatus::WARN);
  EXPECT_EQ(said(describeMode, view).message, "HOLDING: hold was requested");
  view.status.mode = cell::SupervisorMode::Fault;
  EXPECT_EQ(said(describeMode, view).level, DiagnosticStatus::ERROR);
}

TEST(SupervisorDiagnostics, aLostRobotIsAnErrorThatNamesIt) {
  CellView view = allWell();
  view.status.robots.front().state = cell::RobotState::Lost;
  view.status.robots.front().text = "it is silent";
  EXPECT_EQ(said(describeRobots, view).level, DiagnosticStatus::ERROR);
  EXPECT_THAT(said(describeRobots, view).message, HasSubstr("RA is LOST: it is silent"));
}

TEST(SupervisorDiagnostics, aZoneThatIsHeldForLongWhileAnotherWaitsIsAWarning) {
  CellView view = allWell();
  view.status.zones.front().since = fromSeconds(61);
  EXPECT_EQ(said(describeZones, view).level, DiagnosticStatus::OK) << "nobody waits";
  view.status.zones.front().waiting = {"RB"};
  EXPECT_EQ(said(describeZones, view).level, DiagnosticStatus::WARN);
  EXPECT_THAT(said(describeZones, view).message, HasSubstr("Z1 is HELD by RA for 61 s, and RB waits"));
}

TEST(SupervisorDiagnostics, anotherSupervisorIsAnErrorThatNamesItsNode) {
  CellView view = allWell();
  view.counts.malformed = 1;
  EXPECT_EQ(said(describeReports, view).level, DiagnosticStatus::WARN);
  view.other = "/cell/second";
  EXPECT_EQ(said(describeReports, view).level, DiagnosticStatus::ERROR);
  EXPECT_THAT(said(describeReports, view).message, HasSubstr("/cell/second"));
}

TEST(SupervisorDiagnostics, the99thOfAHundredIsTold) {
  Latencies latencies;
  EXPECT_EQ(latencies.p99(), Duration::zero());
  for (int i = 100; i >= 1; --i) latencies.take(std::chrono::milliseconds(i));
  EXPECT_EQ(latencies.p99(), std::chrono::milliseconds(99));
  for (int i = 0; i < 1000; ++i) latencies.take(std::chrono::milliseconds(1));
  EXPECT_EQ(latencies.p99(), std::chrono::milliseconds(1)) << "only the last thousand count";
}

}  // namespace
}  // namespace cobot_command::ros_adapter
