// What a robot carries at the places of its program.
#include "cobot_command/cell/artifact/place_parts.h"

#include "../cell_zones/zoned_cell.h"
#include <gmock/gmock.h>

#include "cobot_command/cell/artifact/cell_build.h"

namespace cobot_command::cell {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A robot that goes OUT in four frames, of which it takes "cup" at the end of the second one, and "lid" at
/// the end of the last one; it books a zone before the third frame, and gives it back at the end of that.
Artifact twoParts() {
  Artifact artifact;
  artifact.program.robots = {{"RA", {"HERE", "THERE"}, 0, {}, {}}};
  PathProgram out{"OUT", 0, 1, {}, false};
  out.steps = {{true, {0}, false}, {false, {0}, false}};
  artifact.program.robots.front().paths = {out};
  ArtifactRobot robot;
  robot.stations.resize(2);
  robot.stations[1].carried = {"cup", "lid"};
  ArtifactPath path;
  path.frames.resize(4);
  path.frames[2].carried = path.frames[3].carried = {"cup"};
  path.pieces.resize(8);
  for (std::size_t i = 0; i < path.pieces.size(); ++i) path.pieces[i].frame = i / 2;
  path.places.resize(2);
  path.places[0].frame = 2;
  path.places[0].piece = 4;
  path.places[1].frame = 2;
  path.places[1].piece = 5;
  robot.paths = {path};
  artifact.robots = {robot};
  return artifact;
}

CellPlace on(std::size_t behind) {
  CellPlace place;
  place.behind = behind;
  return place;
}

TEST(CarriedParts, atAStationAreThoseOfTheStation) {
  CellPlace there;
  there.station = 0;
  EXPECT_THAT(carriedAt(twoParts(), 0, there), IsEmpty());
  there.station = 1;
  EXPECT_THAT(carriedAt(twoParts(), 0, there), ElementsAre("cup", "lid"));
}

TEST(CarriedParts, onAPathAreThoseThatItMayHaveTakenBeforeTheNextBooking) {
  EXPECT_THAT(carriedAt(twoParts(), 0, on(0)), ElementsAre("cup")) << "at the end of the second frame";
}

TEST(CarriedParts, beforeABookingWithWhichItSetsOutAreThoseOfItsStation) {
  Artifact artifact = twoParts();
  artifact.robots[0].paths[0].places[0].frame = 0;
  EXPECT_THAT(carriedAt(artifact, 0, on(0)), IsEmpty());
}

TEST(CarriedParts, betweenAReleaseAndABookingAreThoseWhereItStands) {
  Artifact artifact = twoParts();
  artifact.program.robots[0].paths[0].steps = {{false, {0}, false}, {true, {0}, false}};
  artifact.robots[0].paths[0].places[0].piece = 3;
  artifact.robots[0].paths[0].places[1].frame = 2;
  EXPECT_THAT(carriedAt(artifact, 0, on(1)), ElementsAre("cup"));
}

TEST(CarriedParts, behindABookingAreThoseOfAllThatFollows) {
  EXPECT_THAT(carriedAt(twoParts(), 0, on(1)), ElementsAre("cup", "lid"));
}

TEST(CarriedParts, behindAReleaseAreNotThoseThatItHadBeforeThat) {
  Artifact artifact = twoParts();
  artifact.robots[0].stations[0].carried = {"old"};
  artifact.robots[0].paths[0].frames[0].carried = {"old"};
  EXPECT_THAT(carriedAt(artifact, 0, on(0)), ElementsAre("cup", "old"));
  EXPECT_THAT(carriedAt(artifact, 0, on(2)), ElementsAre("cup", "lid"));
}

TEST(CarriedParts, behindTheLastPieceAreThoseOfItsEnd) {
  Artifact artifact = twoParts();
  artifact.robots[0].paths[0].places[1].piece = 7;
  EXPECT_THAT(carriedAt(artifact, 0, on(2)), ElementsAre("cup", "lid"));
}

TEST(CarriedParts, ofThePalletAreTheSheetFromWhereItMayBeTakenToHome) {
  CellBuild build(cellOf("pallet"), Policy::Supervisor, 1);
  for (const BuildStage stage : kBuildStages) ASSERT_THAT(build.run(stage), IsEmpty());
  const Artifact artifact = *fromBytes(build.bytes());
  const CellModel model = *modelOf(artifact.program);
  std::map<std::string, std::string> carried;
  for (const CellPlace& place : model.places[0]) {
    for (const std::string& part : carriedAt(artifact, 0, place)) carried[place.name] += part;
  }
  for (const CellPlace& place : model.places[0]) {
    if (place.station) continue;
    const bool stays_at_home =
        artifact.program.robots[0].paths[place.path].name == "FETCH" && place.behind == 0;
    EXPECT_EQ(carried[place.name], stays_at_home ? "" : "sheet") << place.name;
  }
  EXPECT_EQ(carried["HOME"], "");
  EXPECT_EQ(carried["T1"], "sheet");
}

}  // namespace
}  // namespace cobot_command::cell
