// By what the controller is told, and what it is told.

#include <algorithm>

#include "jog_cell.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(JogMeansTest, areVelocitiesWhereTheyAreLicensed) {
  JogCell cell(true);
  const GoalId id = cell.cell.submit(jog(JogMode::Axes, 0, 1, 10));
  cell.hold(500ms);
  static_cast<void>(cell.timeToStandstill());
  EXPECT_EQ(reportOf(cell.cell.endOf(id)).means, JogMeans::Velocity);
  const auto& scripts = cell.cell.scripts();
  ASSERT_GE(scripts.size(), 3U);
  EXPECT_THAT(scripts[0], HasSubstr("ContinueVJog()\r\nSetContinueVJog(18,0,0,0,0,0)\r\nQueueTag("));
  EXPECT_EQ(scripts[1], "SetContinueVJog(0,0,0,0,0,0)");
  EXPECT_EQ(scripts[2], "StopContinueVmode()");
}

TEST(JogMeansTest, areMovesUnlessVelocitiesWereAskedForByName) {
  JogCell cell(true, {}, {}, {});
  for (const auto mode : {JogMode::Axes, JogMode::Frame, JogMode::Tool}) {
    const GoalId id = cell.cell.submit(jog(mode, 1, 1, 10));
    cell.hold(300ms);
    static_cast<void>(cell.timeToStandstill());
    EXPECT_EQ(reportOf(cell.cell.endOf(id)).means, JogMeans::Moves);
  }
  EXPECT_THAT(cell.cell.scripts(), Each(Not(HasSubstr("ContinueV"))));
}

TEST(JogMeansTest, areVelocitiesForJointsOrForTheTcpAsEachWasAskedFor) {
  link::LinkSettings only_joints;
  only_joints.velocities.joints = true;
  JogCell cell(true, {}, {}, only_joints);
  const GoalId of_tcp = cell.cell.submit(jog(JogMode::Frame, 1, 1, 10));
  cell.hold(100ms);
  EXPECT_EQ(reportOf(cell.cell.endOf(of_tcp)).means, JogMeans::Moves);
  EXPECT_THAT(cell.cell.scripts(), Each(Not(HasSubstr("ContinueV"))));
  const GoalId of_joints = cell.cell.submit(jog(JogMode::Axes, 0, 1, 10));
  cell.hold(100ms);
  EXPECT_THAT(cell.cell.scripts(), Contains(HasSubstr("ContinueVJog()")));
  const auto& told = cell.cell.progress(of_joints);
  EXPECT_TRUE(std::any_of(told.begin(), told.end(), [](const Progress& progress) {
    return progress.text.find("the joints are not stopped") != std::string::npos;
  }));
}

TEST(JogMeansTest, areVelocitiesOfTheTcpInTheUnitThatWasAskedFor) {
  link::LinkSettings in_metres;
  in_metres.velocities.line = VelocityModes::Line::Metres;
  JogCell metres(true, {}, {}, in_metres);
  JogCell millimetres(true);
  for (JogCell* cell : {&metres, &millimetres}) {
    cell->cell.submit(jog(JogMode::Frame, 1, 1, 10));
    cell->hold(100ms);
  }
  const double typical_mm_s = mToMm(arm::ArmModel::named("tm5-900")->ratings().max_tcp_speed);
  EXPECT_THAT(millimetres.cell.scripts().front(),
              HasSubstr(fmt::format("SetContinueVLine(0,{},0,0,0,0)", 0.1 * typical_mm_s)));
  EXPECT_THAT(metres.cell.scripts().front(),
              HasSubstr(fmt::format("SetContinueVLine(0,{},0,0,0,0)", 0.0001 * typical_mm_s)));
}

TEST(JogMeansTest, keepVelocitiesOfTheTcpAliveAtTheController) {
  JogCell cell(true);
  cell.cell.submit(jog(JogMode::Frame, 1, 1, 10));
  cell.hold(1s);
  EXPECT_THAT(cell.cell.scripts().front(), HasSubstr("ContinueVLine(300,3000)"));
  EXPECT_NEAR(static_cast<double>(cell.cell.scripts().size()), 10, 2);
}

TEST(JogMeansTest, areMovesForALinkThatHasRefusedVelocities) {
  JogCell cell(false);
  const GoalId first = cell.cell.submit(jog(JogMode::Axes, 0, 1, 10));
  cell.hold(500ms);
  static_cast<void>(cell.timeToStandstill());
  EXPECT_EQ(reportOf(cell.cell.endOf(first)).means, JogMeans::Moves);
  EXPECT_GT(cell.jointDeg(0), 8);
  const auto& told = cell.cell.progress(first);
  EXPECT_TRUE(std::any_of(told.begin(), told.end(), [](const Progress& progress) {
    return progress.text.find("accepts no velocities") != std::string::npos;
  }));
  const auto tried = cell.cell.scripts().size();
  cell.cell.submit(jog(JogMode::Axes, 0, -1, 10));
  cell.hold(500ms);
  const auto& scripts = cell.cell.scripts();
  EXPECT_THAT(std::vector<std::string>(scripts.begin() + static_cast<std::ptrdiff_t>(tried), scripts.end()),
              Each(Not(HasSubstr("ContinueV"))));
}

TEST(JogMeansTest, areTriedAnewWithANewLink) {
  JogCell cell(false);
  cell.cell.submit(jog(JogMode::Axes, 0, 1, 10));
  cell.hold(300ms);
  cell.cell.dropConnections();
  cell.cell.pass(1s);
  cell.cell.connect();
  cell.cell.submit(jog(JogMode::Axes, 0, 1, 10));
  cell.hold(50ms);
  EXPECT_THAT(cell.cell.scripts(), Contains(HasSubstr("ContinueVJog()")));
}

TEST(JogMeansTest, haveMovesOfFiftiethsOfASecondAhead) {
  JogCell cell(false);
  cell.cell.submit(jog(JogMode::Axes, 0, 1, 10));
  cell.hold(1s);
  const double at = cell.jointDeg(0);
  static_cast<void>(cell.timeToStandstill());
  EXPECT_LE(cell.jointDeg(0) - at, 18 * 0.2) << "0.2 s ahead at most";
}

TEST(JogGate, isAskedForEveryFrameThatMayMoveTheArm) {
  for (const bool licence : {true, false}) {
    JogCell cell(licence);
    std::vector<std::string> asked;
    bool planned = true;
    cell.cell.setGate([&](const command::Departure& departure, Instant /*now*/) {
      asked.push_back(departure.lines.back());
      planned = departure.planned;
      return std::nullopt;
    });
    cell.cell.submit(jog(JogMode::Frame, 1, 1, 10));
    cell.hold(1s);
    static_cast<void>(cell.timeToStandstill());
    cell.cell.pass(200ms);
    EXPECT_EQ(planned, !licence);
    const auto& scripts = cell.cell.scripts();
    const auto moving = std::count_if(scripts.begin(), scripts.end(), [](const std::string& script) {
      return script.find("Move_Line") != std::string::npos ||
             (script.find("SetContinueVLine") != std::string::npos &&
              script != "SetContinueVLine(0,0,0,0,0,0)");
    });
    EXPECT_EQ(static_cast<std::size_t>(moving), asked.size()) << licence;
  }
}

TEST(JogGate, keepsAJogBack) {
  for (const bool licence : {true, false}) {
    JogCell cell(licence);
    cell.cell.setGate([](const command::Departure&, Instant) {
      return Failure{own_error::kRobotError, "the gate is closed", ""};
    });
    const Outcome outcome = cell.cell.endOf(cell.cell.submit(jog(JogMode::Axes, 0, 1, 10)));
    EXPECT_EQ(outcome.ending, Ending::Aborted);
    EXPECT_THAT(outcome.error_description, HasSubstr("the gate is closed"));
    EXPECT_TRUE(cell.cell.scripts().empty());
  }
}

}  // namespace
}  // namespace cobot_command::testing
