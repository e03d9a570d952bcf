// Hold to run: the arm stands within 250 ms of the last keep-alive, whatever it is told by and however fast
// it is.

#include <tuple>

#include "jog_cell.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;

/// A licence for velocities; the speed.
class JogDeadMan : public ::testing::TestWithParam<std::tuple<bool, double>> {
 protected:
  JogCell cell{std::get<0>(GetParam())};
  double speed = std::get<1>(GetParam());

  void expectItStandsInTime(const JogGoal& goal, Duration held) {
    const GoalId id = cell.cell.submit(goal);
    cell.hold(held);
    ASSERT_FALSE(cell.stands());
    const Duration time = cell.timeToStandstill();
    EXPECT_LE(time, kJogStandsWithin) << toSeconds(time);
    const JogReport report = reportOf(cell.cell.endOf(id));
    EXPECT_EQ(report.ended_by, JogEnd::Released) << report.why;
    EXPECT_EQ(report.means, std::get<0>(GetParam()) ? JogMeans::Velocity : JogMeans::Moves);
    EXPECT_TRUE(cell.stands());
  }
};

TEST_P(JogDeadMan, letsAJointStandWithin250Ms) {
  expectItStandsInTime(jog(JogMode::Axes, 0, 1, speed), 700ms);
  EXPECT_GT(cell.jointDeg(0), 0.4 * speed);
}

TEST_P(JogDeadMan, letsTheTcpStandWithin250Ms) {
  expectItStandsInTime(jog(JogMode::Frame, 1, 1, speed), 200ms);
}

TEST_P(JogDeadMan, letsATurnOfTheToolStandWithin250Ms) {
  expectItStandsInTime(jog(JogMode::Tool, 5, 1, speed), 200ms);
}

TEST_P(JogDeadMan, countsTheGoalAsTheFirstKeepAlive) {
  const GoalId id = cell.cell.submit(jog(JogMode::Axes, 0, 1, speed));
  cell.last_kept = cell.cell.now();
  EXPECT_TRUE(cell.cell.passUntil([&] { return !cell.stands(); }, 100ms));
  EXPECT_LE(cell.timeToStandstill(), kJogStandsWithin);
  EXPECT_EQ(reportOf(cell.cell.endOf(id)).ended_by, JogEnd::Released);
}

TEST_P(JogDeadMan, goesOnWithAKeepAliveThatComesWhileItSlowsDown) {
  const GoalId id = cell.cell.submit(jog(JogMode::Axes, 0, 1, 10));
  cell.hold(2s, 90ms);
  EXPECT_EQ(cell.cell.outcome(id), nullptr);
  EXPECT_GT(cell.jointDeg(0), 10);
  EXPECT_LE(cell.timeToStandstill(), kJogStandsWithin);
  EXPECT_EQ(reportOf(cell.cell.endOf(id)).ended_by, JogEnd::Released);
}

INSTANTIATE_TEST_SUITE_P(All, JogDeadMan,
                         ::testing::Combine(::testing::Bool(), ::testing::Values(1.0, 10.0, 40.0, 100.0)));

/// Each means.
class JogPace : public ::testing::TestWithParam<bool> {};

TEST_P(JogPace, isThatOfItsSpeedWithoutPause) {
  JogCell cell(GetParam());
  cell.cell.submit(jog(JogMode::Axes, 0, 1, 10));
  cell.hold(1s);
  for (int i = 0; i < 100; ++i) {
    cell.hold(10ms);
    EXPECT_NEAR(radToDeg(cell.cell.robot().velocities[0]), 18, 0.2) << i;
  }
}

TEST_P(JogPace, staysWhenPlansTakeAFewMilliseconds) {
  JogCell cell(GetParam(), {}, 3ms);
  cell.cell.submit(jog(JogMode::Frame, 1, 1, 10));
  cell.hold(1s);
  const double before = cell.tcp().translation().y();
  cell.hold(1s);
  EXPECT_NEAR(cell.tcp().translation().y() - before, 0.14, 0.01);
}

TEST_P(JogPace, isLowerByTheProjectSpeed) {
  simulator::Settings settings;
  settings.project_speed_percent = 50;
  JogCell cell(GetParam(), settings);
  cell.cell.submit(jog(JogMode::Axes, 0, 1, 20));
  cell.hold(1s);
  const double before = cell.jointDeg(0);
  cell.hold(1s);
  EXPECT_NEAR(cell.jointDeg(0) - before, 18, 0.4);
  EXPECT_LE(cell.timeToStandstill(), kJogStandsWithin);
}

INSTANTIATE_TEST_SUITE_P(All, JogPace, ::testing::Bool());

}  // namespace
}  // namespace cobot_command::testing
