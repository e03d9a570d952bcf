// Increments: exact, without anybody who holds them.

#include "jog_cell.h"
#include <gmock/gmock.h>

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using ::testing::HasSubstr;

class JogIncrements : public ::testing::Test {
 protected:
  JogReport done(const JogGoal& goal) {
    JogReport report = reportOf(cell.cell.endOf(cell.cell.submit(goal)));
    EXPECT_EQ(report.ended_by, JogEnd::IncrementDone) << report.why;
    EXPECT_EQ(report.means, JogMeans::Moves);
    cell.cell.pass(100ms);
    return report;
  }
  JogCell cell{true};
};

TEST_F(JogIncrements, goAlongAnAxisOfTheBaseToAHundredthOfAMillimetre) {
  const arm::Pose before = cell.tcp();
  JogGoal goal = jog(JogMode::Frame, 2, 1, 20);
  goal.increment_mm = 12.34;
  const JogReport report = done(goal);
  const Eigen::Vector3d way = cell.tcp().translation() - before.translation();
  EXPECT_NEAR(mToMm(way.z()), 12.34, 0.01);
  EXPECT_NEAR(mToMm(way.head<2>().norm()), 0, 0.01);
  EXPECT_NEAR(report.way_mm, 12.34, 0.05);
}

TEST_F(JogIncrements, goAlongEachOfTheAxesThatAreUsed) {
  const arm::Pose before = cell.tcp();
  JogGoal goal = jog(JogMode::Frame, 2, 1, 20);
  goal.directions[1] = -1;
  goal.increment_mm = 5;
  done(goal);
  const Eigen::Vector3d way = cell.tcp().translation() - before.translation();
  EXPECT_NEAR(mToMm(way.z()), 5, 0.01);
  EXPECT_NEAR(mToMm(way.y()), -5, 0.01);
}

TEST_F(JogIncrements, goAlongTheToolAndAboutIt) {
  const arm::Pose before = cell.tcp();
  JogGoal along = jog(JogMode::Tool, 2, -1, 20);
  along.increment_mm = 7;
  done(along);
  EXPECT_NEAR(mToMm((before.inverse() * cell.tcp()).translation().z()), -7, 0.01);
  JogGoal about = jog(JogMode::Tool, 5, 1, 20);
  about.increment_deg = 15;
  done(about);
  const Eigen::AngleAxisd turn((before.inverse() * cell.tcp()).linear());
  EXPECT_NEAR(radToDeg(turn.angle()) * turn.axis().z(), 15, 0.001);
}

TEST_F(JogIncrements, thatAreCancelledWereNotMade) {
  JogGoal goal = jog(JogMode::Axes, 0, 1, 10);
  goal.increment_deg = 20;
  const GoalId id = cell.cell.submit(goal);
  cell.cell.pass(500ms);
  cell.cell.cancel(id);
  EXPECT_EQ(cell.cell.endOf(id).ending, Ending::CommandAborted);
  const auto report = cell.cell.endOf(id).detail.as<JogReport>();
  EXPECT_EQ(report.ended_by, JogEnd::None);
  EXPECT_EQ(report.why, "");
}

TEST_F(JogIncrements, tellHowFarTheyAreAndNotThatTheyComeToRest) {
  JogGoal goal = jog(JogMode::Axes, 0, 1, 10);
  goal.increment_deg = 20;
  const GoalId id = cell.cell.submit(goal);
  cell.cell.pass(500ms);
  const Progress& progress = cell.cell.progress(id).back();
  EXPECT_EQ(progress.phase, Phase::Active) << progress.text;
  EXPECT_GT(progress.fraction, 0.1);
  EXPECT_NEAR(progress.detail.as<JogPlace>().way_deg + progress.detail.as<JogPlace>().room_deg, 20, 0.01);
  EXPECT_EQ(reportOf(cell.cell.endOf(id)).ended_by, JogEnd::IncrementDone);
}

TEST_F(JogIncrements, turnJointsByTheSameAngle) {
  JogGoal goal = jog(JogMode::Axes, 0, 1, 20);
  goal.directions[4] = -1;
  goal.increment_deg = 6.5;
  done(goal);
  EXPECT_NEAR(cell.jointDeg(0), 6.5, 0.001);
  EXPECT_NEAR(cell.jointDeg(4), 83.5, 0.001);
}

TEST_F(JogIncrements, takeTheAxesOfAFrameOfTheTables) {
  tables::Frame frame;
  frame.pose = arm::Pose::Identity();
  frame.pose->rotate(Eigen::AngleAxisd(kPi / 2, Eigen::Vector3d::UnitZ()));
  ASSERT_TRUE(cell.cell.write({3, std::optional(frame)}));
  const arm::Pose before = cell.tcp();
  JogGoal goal = jog(JogMode::Frame, 0, 1, 20);
  goal.frame = 3;
  goal.increment_mm = 10;
  done(goal);
  EXPECT_NEAR(mToMm(cell.tcp().translation().y() - before.translation().y()), 10, 0.01);
}

TEST_F(JogIncrements, areRefusedWhereALimitIsInTheWay) {
  JogGoal goal = jog(JogMode::Axes, 2, 1, 20);
  goal.increment_deg = 170;
  const Outcome outcome = cell.cell.endOf(cell.cell.submit(goal));
  EXPECT_EQ(outcome.ending, Ending::Rejected);
  EXPECT_EQ(outcome.error_id, own_error::kJointLimit);
  EXPECT_THAT(outcome.error_description, HasSubstr("J3"));
  EXPECT_TRUE(cell.cell.scripts().empty());
}

TEST_F(JogIncrements, turnOnlyAboutTheActiveTcp) {
  tables::Tool tool;
  tool.pose = arm::Pose(Eigen::Translation3d(0, 0, 0.1));
  ASSERT_TRUE(cell.cell.write({2, std::optional(tool)}));
  JogGoal goal = jog(JogMode::Tool, 5, 1, 20);
  goal.tool = 2;
  goal.increment_deg = 5;
  EXPECT_EQ(cell.cell.endOf(cell.cell.submit(goal)).error_id, 0x8D35);
  goal.tool = 0;
  done(goal);
}

}  // namespace
}  // namespace cobot_command::testing
