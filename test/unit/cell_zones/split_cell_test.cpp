// The demos with motions that are cut before they enter a zone (cell.md, M14; oracle 31).
#include "cobot_command/cell/splitting/split_cell.h"

#include "zoned_cell.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/cell/model/supervisors.h"
#include "cobot_command/cell/program/canonical.h"
#include "cobot_command/cell/zones/soundness.h"

namespace cobot_command::cell {
namespace {

using ::testing::IsEmpty;

constexpr std::array<const char*, 3> kDemos{"handover", "head_on", "iris"};

/// All moves at `percent` of their speed; 0: as the file has them.
Cell cellToCut(const std::string& name, double percent = 0) {
  Cell cell = cellOf(name);
  cell.parameters.split = Split::Auto;
  if (percent <= 0) return cell;
  for (Robot& robot : cell.robots) {
    for (Path& path : robot.program) {
      for (Step& step : path.steps) std::get<blocks::MoveAbsoluteGoal>(step.goal).speed = percent;
    }
  }
  return cell;
}

SplitCell splitOf(const Cell& cell) {
  SplitCell split = orThrow(splitCell(cell));
  for (const CutReport& cut : split.cuts) {
    fmt::print(
        "{}: {} {} step {} before {} at {:.3f}: saves {:.2f} s, {:.1e} m, {:.1e} rad, {:.3f} ms longer, "
        "corner {:.3f} mm\n",
        cell.name, cut.robot, cut.path, cut.step + 1, fmt::join(cut.zones, " and "), cut.progress,
        toSeconds(cut.saved), cut.measure.deviation, cut.measure.turn, 1000 * toSeconds(cut.measure.longer),
        1000 * cut.measure.corner);
  }
  return split;
}

using Counts = std::pair<std::size_t, std::size_t>;
Counts supervisorOf(const CellProgram& program) {
  const CellModel model = orThrow(modelOf(program));
  const auto parts = orThrow(synthesizeParts(model, Policy::Supervisor, 100000));
  return {parts.front().counts.states, parts.front().counts.transitions};
}

/// Bookings and releases in their order; with the zones' own names.
std::string eventsOf(const CellProgram& program) {
  std::string events;
  for (const RobotProgram& robot : program.robots) {
    for (const PathProgram& path : robot.paths) {
      events += fmt::format("\n{} {}:", robot.name, path.name);
      for (const ZoneStep& step : path.steps) {
        events += step.books ? " b" : " u";
        for (const ZoneIndex zone : step.zones) events += program.zones[zone];
      }
    }
  }
  return events;
}

TEST(TheHeadOn, booksItsNearZonesOnTheWayToThem) {
  const SplitCell split = splitOf(cellToCut("head_on"));
  ASSERT_FALSE(split.cuts.empty());
  for (const RobotIndex robot : {0U, 1U}) {
    const Path& path = split.cell.robots[robot].program[0];
    ASSERT_GE(path.steps.size(), 3U);
    EXPECT_EQ(path.steps[0].name, fmt::format("step 1 (before Z{})", robot + 1));
    EXPECT_EQ(split.held.robots[robot].paths[0].places.front().frame, 1U) << "without the cut it was 0";
  }
  for (const CutReport& cut : split.cuts) {
    EXPECT_GE(cut.saved, kLeastSaved);
    EXPECT_LE(cut.measure.deviation, kMostDeviation);
    EXPECT_LE(cut.measure.turn, kMostTurn);
    EXPECT_GT(cut.progress, 0.0);
    EXPECT_LT(cut.progress, 1.0);
  }
}

TEST(TheDemos, bookLaterWhereverTheyAreSlowEnough) {
  for (const char* name : kDemos) {
    const SplitCell split = splitOf(cellToCut(name, 15));
    EXPECT_GE(split.cuts.size(), split.cell.robots.size()) << name;
    for (RobotIndex robot = 0; robot < split.cell.robots.size(); ++robot) {
      EXPECT_GE(split.held.robots[robot].paths[0].places.front().frame, 1U) << name;
    }
  }
}

TEST(TheDemosThatAreCut, areSoundAndHaveTheModelsOfTheData) {
  const std::array<Counts, 3> expected{{{27, 48}, {41, 72}, {258, 672}}};
  for (std::size_t demo = 0; demo < kDemos.size(); ++demo) {
    for (const double percent : {0.0, 15.0}) {
      const SplitCell split = orThrow(splitCell(cellToCut(kDemos[demo], percent)));
      EXPECT_EQ(supervisorOf(split.held.program), expected[demo]) << kDemos[demo];
      const ZonedCell whole(cellToCut(kDemos[demo], percent));
      EXPECT_EQ(eventsOf(split.held.program), eventsOf(whole.held.program));
      const Soundness found = checkSoundness(split.cell, split.claims, split.held);
      EXPECT_THAT(found.faults, IsEmpty()) << kDemos[demo];
      EXPECT_GE(found.least, split.cell.parameters.margin);
    }
  }
}

TEST(ACellThatIsCut, hasTheStagesThatItsProgramsGive) {
  const SplitCell split = orThrow(splitCell(cellToCut("iris", 15)));
  const ZonedCell anew(split.cell);
  ASSERT_EQ(anew.claims.size(), split.claims.size());
  for (RobotIndex robot = 0; robot < anew.claims.size(); ++robot) {
    EXPECT_EQ(anew.claims[robot].all, split.claims[robot].all);
    EXPECT_EQ(anew.claims[robot].pieces(), split.claims[robot].pieces());
    EXPECT_EQ(anew.planned[robot].paths[0].duration, split.planned[robot].paths[0].duration);
  }
  EXPECT_EQ(eventsOf(anew.held.program), eventsOf(split.held.program));
}

TEST(ACellThatIsCut, isTheSameEachTimeAndOnAnyNumberOfThreads) {
  const Cell cell = cellToCut("head_on");
  const std::string once = canonicalText(orThrow(splitCell(cell)).cell);
  EXPECT_EQ(canonicalText(orThrow(splitCell(cell, 2)).cell), once);
  EXPECT_NE(canonicalText(cell), once);
}

TEST(ACellThatIsCut, isNotCutAgain) {
  const SplitCell split = orThrow(splitCell(cellToCut("head_on")));
  EXPECT_THAT(orThrow(splitCell(split.cell)).cuts, IsEmpty());
}

TEST(ACell, isLeftAsItIsWhereLessThanHalfASecondIsToBeGained) {
  for (const char* name : {"handover", "iris"}) {
    const Cell cell = cellToCut(name);
    const SplitCell split = splitOf(cell);
    EXPECT_THAT(split.cuts, IsEmpty()) << name << ": the cut would be booked 0.4 s after its beginning";
    EXPECT_EQ(canonicalText(split.cell), canonicalText(cell));
  }
}

TEST(ACell, isLeftAsItIsWhereItsMotionsAreNotToBeCut) {
  Cell cell = cellToCut("head_on");
  cell.parameters.split = Split::Never;
  const SplitCell split = orThrow(splitCell(cell));
  EXPECT_THAT(split.cuts, IsEmpty());
  EXPECT_EQ(canonicalText(split.cell), canonicalText(cell));
}

/// One motion where the demo has two.
void goStraightToW(Cell& cell) {
  for (Robot& robot : cell.robots) robot.program[0].steps.erase(robot.program[0].steps.begin());
}

TEST(AMotionThatEntersTwoZones, isCutBeforeEachOfThem) {
  Cell cell = cellToCut("iris", 5);
  goStraightToW(cell);
  const ZonedCell whole(cell);
  const SplitCell split = splitOf(cell);
  EXPECT_EQ(split.cuts.size(), 6U);
  EXPECT_THAT(checkSoundness(split.cell, split.claims, split.held).faults, IsEmpty());
  for (const RobotIndex robot : {0U, 1U, 2U}) {
    ASSERT_EQ(whole.held.program.robots[robot].paths[0].steps.front().zones.size(), 2U) << "at once";
    const auto& steps = split.held.program.robots[robot].paths[0].steps;
    const auto& places = split.held.robots[robot].paths[0].places;
    ASSERT_GE(steps.size(), 2U);
    for (const std::size_t booking : {0U, 1U}) {
      ASSERT_EQ(steps[booking].zones.size(), 1U);
      EXPECT_EQ(places[booking].frame, booking + 1);
      EXPECT_EQ(split.cell.robots[robot].program[0].steps[booking].name,
                fmt::format("step 1 (before {})", split.held.program.zones[steps[booking].zones[0]]));
    }
  }
}

TEST(ACut, isMadeFartherBackWhereAHalfOrAChangedZoneTouchesIt) {
  // Slow enough, and with voxels small enough, that some pieces of the halves touch what those of the whole
  // do not; and that a zone grows by what was cut, so that one path is cut anew.
  Cell cell = cellToCut("iris", 4);
  goStraightToW(cell);
  cell.parameters.voxel = 0.016;
  cell.parameters.tracking = 0.002;
  const SplitCell split = splitOf(cell);
  EXPECT_EQ(split.cuts.size(), 6U);
  for (const CutReport& cut : split.cuts) {
    EXPECT_GE(cut.saved, kLeastSaved);
    EXPECT_FALSE(cut.zones.empty());
  }
  EXPECT_THAT(checkSoundness(split.cell, split.claims, split.held).faults, IsEmpty());
}

/// The way in of the handover as a line of the TCP at so many mm/s.
Cell handoverByLines(double speed) {
  Cell cell = cellToCut("handover");
  for (Robot& robot : cell.robots) {
    Step& step = robot.program[0].steps[0];
    auto goal = std::get<blocks::MoveAbsoluteGoal>(step.goal);
    const arm::ArmModel arm = *arm::ArmModel::named(robot.model);
    goal.movement_command = static_cast<int>(blocks::Movement::Line);
    goal.data_format = static_cast<int>(blocks::AbsoluteFormat::Cap);
    goal.target =
        arm::toControllerPose(arm::forwardKinematics(arm, find(robot.stations, robot.program[0].to)->joints) *
                              arm::toPose(robot.tcp));
    goal.speed = speed;
    step.goal = goal;
    step.name = "to the other one";
  }
  return cell;
}

TEST(ALineThatEntersAZone, isCutBeforeIt) {
  const SplitCell split = splitOf(handoverByLines(100));
  ASSERT_EQ(split.cuts.size(), 2U);
  for (const CutReport& cut : split.cuts) {
    EXPECT_LE(cut.measure.longer, std::chrono::milliseconds(1));
    EXPECT_EQ(split.cell.robots[0].program[0].steps[0].name, "to the other one (before Z1)");
    EXPECT_EQ(split.cell.robots[0].program[0].steps[1].name, "to the other one");
  }
  EXPECT_EQ(supervisorOf(split.held.program), Counts(27, 48));
  EXPECT_THAT(checkSoundness(split.cell, split.claims, split.held).faults, IsEmpty());
}

}  // namespace
}  // namespace cobot_command::cell
