// In which zones the bodies of a robot are, and when it has left one.
#include "agent/whereabouts.h"

#include "made_path.h"
#include <gmock/gmock.h>

namespace cobot_command::cell {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

/// Of that path, in the middle: the robot is in it neither at its beginning nor at its end.
std::shared_ptr<Artifact> artifactWithZone() {
  auto artifact = artifactOfTurn();
  VoxelSet middle = claimAt(45, *artifact);
  VoxelSet end = claimAt(90, *artifact);
  for (int degrees = 0; degrees <= 10; ++degrees) {
    middle -= claimAt(degrees, *artifact);
    middle -= claimAt(90 - degrees, *artifact);
    end -= claimAt(5 * degrees, *artifact);
  }
  artifact->zones = {{"Z1", {0}, middle}, {"Z2", {0}, end}};
  return artifact;
}

class ZoneWatchTest : public testing::Test {
 protected:
  const std::vector<ZoneIndex>& see(double degrees, ZoneWatch::Of whose = ZoneWatch::Of::Users) {
    watch.see(turned(degrees), carried, whose);
    return watch.touched();
  }

  std::shared_ptr<Artifact> artifact = artifactWithZone();
  ZoneWatch watch = *ZoneWatch::of(*artifact, 0);
  std::vector<std::string> carried;
};

TEST_F(ZoneWatchTest, isInAZoneWhereItsBodiesAre) {
  EXPECT_THAT(see(0), IsEmpty());
  EXPECT_THAT(see(45), ElementsAre(0));
  EXPECT_TRUE(watch.touches(0));
  EXPECT_FALSE(watch.touches(1));
  EXPECT_THAT(see(90), ElementsAre(1));
}

TEST_F(ZoneWatchTest, isInZonesOfOthersOnlyWhenItIsAsked) {
  artifact->zones[0].users = {1, 2};
  EXPECT_THAT(see(45), IsEmpty());
  EXPECT_THAT(see(45, ZoneWatch::Of::Everyone), ElementsAre(0));
}

TEST_F(ZoneWatchTest, growsByTheMarginAndTheTolerance) {
  double first = 45;
  while (!see(first).empty()) first -= 0.5;
  EXPECT_THAT(see(first), IsEmpty());
  artifact->parameters.margin += 0.06;
  EXPECT_THAT(see(first), Contains(0));
  artifact->parameters.margin -= 0.06;
  artifact->parameters.body_tolerance += 0.03;
  EXPECT_THAT(see(first), Contains(0));
}

TEST_F(ZoneWatchTest, countsWhatTheRobotCarries) {
  // A ball with which it reaches everything around.
  artifact->robots[0].parts = {{"ball", {{{0.0, 0.0, 0.1}, {0.0, 0.0, 0.1}, 0.8}}}};
  EXPECT_THAT(see(0), IsEmpty());
  carried = {"ball"};
  EXPECT_THAT(see(0), Contains(0));
  carried = {"another"};
  EXPECT_THAT(see(0), IsEmpty());
}

TEST_F(ZoneWatchTest, isOfNoArmThatIsUnknown) {
  artifact->robots[0].model = "tm5-901";
  const auto none = ZoneWatch::of(*artifact, 0);
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error(), testing::HasSubstr("tm5-901"));
}

class WhereaboutsTest : public testing::Test {
 protected:
  /// A frame of the status stream.
  bool see(double degrees) {
    where.lookAtZones(place, turned(degrees), ZoneWatch::Of::Users);
    return where.see(place, turned(degrees));
  }
  void setOut() {
    place = CellPlace{};
    place.path = 0;
    where.setOut(0);
  }

  std::shared_ptr<Artifact> artifact = artifactWithZone();
  Whereabouts where{artifact, 0, *ZoneWatch::of(*artifact, 0)};
  CellPlace place = [] {
    CellPlace home;
    home.station = 0;
    return home;
  }();
};

TEST_F(WhereaboutsTest, isWhereItsStationIs) {
  EXPECT_TRUE(see(0.4));
  EXPECT_FALSE(see(0.6));
  EXPECT_FALSE(see(45));
}

TEST_F(WhereaboutsTest, tellsWhenItsZonesAreOthers) {
  EXPECT_FALSE(where.lookAtZones(place, turned(0), ZoneWatch::Of::Users));
  EXPECT_TRUE(where.lookAtZones(place, turned(45), ZoneWatch::Of::Users));
  EXPECT_FALSE(where.lookAtZones(place, turned(45), ZoneWatch::Of::Users));
  EXPECT_TRUE(where.lookAtZones(place, turned(0), ZoneWatch::Of::Users));
}

TEST_F(WhereaboutsTest, hasLeftAZoneByTwoFramesBehindItsLastPiece) {
  setOut();
  where.sent();
  where.sent();
  for (const double degrees : {10.0, 30.0, 45.0, 60.0}) {
    EXPECT_TRUE(see(degrees));
    EXPECT_TRUE(see(degrees));
    EXPECT_FALSE(where.isReleased(0, 3)) << degrees;
  }
  EXPECT_TRUE(see(88));
  EXPECT_FALSE(where.isReleased(0, 3)) << "one frame is none";
  EXPECT_TRUE(see(89));
  EXPECT_TRUE(where.isReleased(0, 3));
}

TEST_F(WhereaboutsTest, hasLeftAZoneOfItsLastMotionOnceItRestsAtTheEnd) {
  artifact->robots[0].paths[0].pieces[4].zones = {0};
  artifact->robots[0].paths[0].pieces[5].zones = {};
  setOut();
  where.sent();
  where.sent();
  for (const double degrees : {10.0, 30.0, 60.0, 80.0, 88.0, 89.0}) {
    EXPECT_TRUE(see(degrees));
    EXPECT_FALSE(where.isReleased(0, 4)) << degrees;
  }
  EXPECT_TRUE(see(90));
  EXPECT_TRUE(see(90));
  EXPECT_TRUE(where.isReleased(0, 4));
}

TEST_F(WhereaboutsTest, hasNotLeftAZoneThatAFrameThatIsToComeGoesInto) {
  setOut();
  where.sent();
  see(0);
  see(0);
  see(0);
  EXPECT_FALSE(where.isReleased(0, 3)) << "it is not in the zone, but will be";
}

TEST_F(WhereaboutsTest, hasNotLeftAZoneInWhichItsBodiesAre) {
  // By its path it is out, and by its bodies not.
  artifact->zones[0].voxels = claimAt(90, *artifact);
  setOut();
  where.sent();
  where.sent();
  for (const double degrees : {10.0, 30.0, 60.0, 88.0, 89.0, 90.0, 90.0}) EXPECT_TRUE(see(degrees));
  EXPECT_FALSE(where.isReleased(0, 3));
}

TEST_F(WhereaboutsTest, beginsToCountAnewWhenItIsOffItsPath) {
  setOut();
  where.sent();
  where.sent();
  EXPECT_TRUE(see(60));
  EXPECT_TRUE(see(88));
  EXPECT_FALSE(see(95));
  EXPECT_TRUE(see(89));
  EXPECT_FALSE(where.isReleased(0, 3));
  EXPECT_TRUE(see(89));
  EXPECT_TRUE(where.isReleased(0, 3));
}

TEST_F(WhereaboutsTest, isLocatedOnAPathByItsJoints) {
  place = CellPlace{};
  place.behind = 1;
  EXPECT_FALSE(where.locate(place, turned(60)));
  EXPECT_FALSE(where.tracker());
  EXPECT_TRUE(where.locate(place, turned(45)));
  EXPECT_TRUE(where.tracker());
  where.startAnew();
  EXPECT_FALSE(where.tracker());
}

}  // namespace
}  // namespace cobot_command::cell
