// The cells of the demos, against what was found of them otherwise (oracles 24 to 27).
#include "cell_programs.h"
#include "zoned_cell.h"
#include <gmock/gmock.h>

#include "cobot_command/automata/formats.h"
#include "cobot_command/cell/model/supervisors.h"
#include "cobot_command/cell/zones/soundness.h"

namespace cobot_command::cell {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr const char* kDemos[] = {"handover", "head_on", "iris", "corridor"};

MATCHER_P2(isWithin, lower, upper, "") {
  return arg >= lower && arg <= upper;
}

/// Where the first piece begins, or the last one ends, that touches a zone on a frame of a path; 0..1 of its
/// way.
struct Touched {
  double first = 2.0;
  double last = -1.0;
};
Touched touchedOn(const ZonedCell& cell, RobotIndex robot, std::size_t path, std::size_t frame,
                  ZoneIndex zone) {
  Touched touched;
  for (const Piece& piece : cell.claims[robot].paths[path].pieces) {
    if (piece.frame != frame || piece.kind != Piece::Kind::Motion ||
        !piece.claim.touches(cell.zones[zone].voxels)) {
      continue;
    }
    touched.first = std::min(touched.first, cell.progress(robot, path, piece, piece.from));
    touched.last = std::max(touched.last, cell.progress(robot, path, piece, piece.to));
  }
  return touched;
}

TEST(TheHandover, hasTheZoneOfOracle24) {
  const ZonedCell cell(cellOf("handover"));
  ASSERT_EQ(cell.zones.size(), 1U);
  EXPECT_THAT(cell.zones[0].users, ElementsAre(0, 1));
  for (const RobotClaim& claim : cell.claims) EXPECT_THAT(cell.volume(claim.all), isWithin(79.0, 112.0));
  EXPECT_THAT(cell.volume(cell.zones[0].voxels), isWithin(9.5, 17.5));
  for (RobotIndex robot : {0U, 1U}) {
    EXPECT_THAT(touchedOn(cell, robot, 0, 0, 0).first, isWithin(0.26, 0.36));
    EXPECT_THAT(touchedOn(cell, robot, 1, 0, 0).last, isWithin(0.64, 0.74));
  }
}

TEST(TheHeadOn, hasTheZonesOfOracle25) {
  const ZonedCell cell(cellOf("head_on"));
  ASSERT_EQ(cell.zones.size(), 2U);
  for (const Zone& zone : cell.zones) EXPECT_THAT(cell.volume(zone.voxels), isWithin(5.4, 10.9));
  EXPECT_EQ(cell.zones[0].voxels.bounds()->upper[0], -1) << "cut at x = 0";
  EXPECT_EQ(cell.zones[1].voxels.bounds()->lower[0], 0);
  for (RobotIndex robot : {0U, 1U}) {
    const ZoneIndex near = robot;
    EXPECT_THAT(touchedOn(cell, robot, 0, 0, near).first, isWithin(0.78, 0.87));
    EXPECT_THAT(touchedOn(cell, robot, 0, 1, 1 - near).first, isWithin(0.13, 0.20));
  }
}

TEST(TheIris, hasTheZonesOfOracle26) {
  const ZonedCell cell(cellOf("iris"));
  ASSERT_EQ(cell.zones.size(), 3U);
  for (const Zone& zone : cell.zones) {
    EXPECT_EQ(zone.users.size(), 2U);
    EXPECT_THAT(cell.volume(zone.voxels), isWithin(4.5, 10.9));
  }
  for (RobotIndex robot = 0; robot < 3; ++robot) {
    double first = 2.0;
    double second = 2.0;
    for (ZoneIndex zone = 0; zone < 3; ++zone) {
      first = std::min(first, touchedOn(cell, robot, 0, 0, zone).first);
      if (touchedOn(cell, robot, 0, 0, zone).last < 0) {
        second = std::min(second, touchedOn(cell, robot, 0, 1, zone).first);
      }
    }
    EXPECT_THAT(first, isWithin(0.27, 0.39));
    EXPECT_THAT(second, isWithin(0.11, 0.25));
  }
}

TEST(TheCorridor, isARowOfFourZones) {
  const ZonedCell cell(cellOf("corridor"));
  ASSERT_EQ(cell.zones.size(), 4U);
  for (ZoneIndex zone = 0; zone < 4; ++zone) {
    EXPECT_THAT(cell.zones[zone].users, ElementsAre(0, 1));
    EXPECT_THAT(cell.volume(cell.zones[zone].voxels), isWithin(3.0, 5.0));
    if (zone > 0) {
      EXPECT_EQ(cell.zones[zone].voxels.bounds()->lower[1],
                cell.zones[zone - 1].voxels.bounds()->upper[1] + 1);
    }
  }
}

struct Counts {
  std::size_t states;
  std::size_t transitions;
  bool operator==(const Counts& other) const {
    return states == other.states && transitions == other.transitions;
  }
};
Counts supervisorOf(const CellProgram& program) {
  const CellModel model = orThrow(modelOf(program));
  const auto parts = orThrow(synthesizeParts(model, Policy::Supervisor, 100000));
  return {parts.front().counts.states, parts.front().counts.transitions};
}

TEST(TheModelsOfTheDemos, areThoseOfTheData) {
  EXPECT_EQ(supervisorOf(ZonedCell(cellOf("handover")).held.program), (Counts{27, 48}));
  EXPECT_EQ(supervisorOf(ZonedCell(cellOf("head_on")).held.program), (Counts{41, 72}));
  EXPECT_EQ(supervisorOf(ZonedCell(cellOf("iris")).held.program), (Counts{258, 672}));
}

/// "b Z1", "u Z1" ... of each path of each robot.
std::vector<std::string> eventsOf(const CellProgram& program) {
  std::vector<std::string> events;
  for (const RobotProgram& robot : program.robots) {
    for (const PathProgram& path : robot.paths) {
      for (const ZoneStep& step : path.steps) {
        std::string event = robot.name + " " + path.name + (step.books ? " b" : " u");
        for (const ZoneIndex zone : step.zones) event += " " + program.zones[zone];
        events.push_back(event);
      }
    }
  }
  return events;
}

TEST(TheCorridor, isBookedZoneByZoneInOppositeDirections) {
  EXPECT_THAT(eventsOf(ZonedCell(cellOf("corridor")).held.program),
              ElementsAre("RA S1 b Z1", "RA S2 b Z2 Z3", "RA S2 u Z1", "RA S3 b Z4", "RA S3 u Z2",
                          "RA S3 u Z3", "RA HOME u Z4", "RB S1 b Z4", "RB S2 b Z2 Z3", "RB S2 u Z4",
                          "RB S3 b Z1", "RB S3 u Z3", "RB S3 u Z2", "RB HOME u Z1"));
}

TEST(TheCorridor, needsMoreThanMutualExclusion) {
  const CellModel model = orThrow(modelOf(ZonedCell(cellOf("corridor")).held.program));
  const auto parts = orThrow(synthesizeParts(model, Policy::Supervisor, 100000));
  const automata::Verification found = verifyParts(model, parts, 100000).front();
  EXPECT_THAT(found.faults, IsEmpty());
  EXPECT_EQ(found.counts.plant_and_spec, 114U);
  EXPECT_EQ(found.counts.dead, 2U) << "who only looks at zones stands there for ever";
  EXPECT_EQ(found.counts.blocking, 33U);
  EXPECT_EQ(found.counts.states, 81U);
  EXPECT_EQ(found.counts.transitions, 138U);
  EXPECT_EQ(found.counts.refused_by_spec, 10U);
  EXPECT_EQ(found.counts.refused_beyond_spec, 14U);
}

TEST(TheZonesOfTheDemos, areTheSameWithOtherParameters) {
  for (const char* name : {"handover", "head_on", "iris"}) {
    const auto usual = eventsOf(ZonedCell(cellOf(name)).held.program);
    Cell coarse = cellOf(name);
    coarse.parameters.voxel = 0.040;
    coarse.parameters.step_bound = 0.020;
    EXPECT_EQ(eventsOf(ZonedCell(coarse).held.program), usual) << name;
    Cell wide = cellOf(name);
    wide.parameters.margin = 0.060;
    EXPECT_EQ(eventsOf(ZonedCell(wide).held.program), usual) << name;
  }
}

TEST(TheDemos, areSound) {
  for (const char* name : kDemos) {
    const ZonedCell cell(cellOf(name));
    const Soundness found = checkSoundness(cell.cell, cell.claims, cell.held);
    EXPECT_THAT(found.faults, IsEmpty()) << name;
    EXPECT_GE(found.least, cell.cell.parameters.margin);
    EXPECT_GT(found.pairs, 1000U);
  }
}

TEST(TheSoundnessOfTheDemos, isLostWithAnyZone) {
  for (const char* name : kDemos) {
    const ZonedCell cell(cellOf(name));
    for (ZoneIndex zone = 0; zone < cell.zones.size(); ++zone) {
      HeldCell held = cell.held;
      for (HeldRobot& robot : held.robots) {
        for (HeldPath& path : robot.paths) {
          path.holds.erase(std::remove_if(path.holds.begin(), path.holds.end(),
                                          [&](const Hold& hold) { return hold.zone == zone; }),
                           path.holds.end());
        }
        for (auto& zones : robot.at_stations) {
          zones.erase(std::remove(zones.begin(), zones.end(), zone), zones.end());
        }
      }
      const Soundness found = checkSoundness(cell.cell, cell.claims, held);
      ASSERT_FALSE(found.faults.empty()) << name << " without " << cell.zones[zone].name;
      EXPECT_THAT(found.faults, ::testing::Contains(::testing::HasSubstr("step")));
    }
  }
}

}  // namespace
}  // namespace cobot_command::cell
