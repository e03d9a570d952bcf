// Whether a robot can be at a place of its program, by its joints.
#include "cobot_command/cell/artifact/place_fit.h"

#include "made_path.h"
#include <gtest/gtest.h>

namespace cobot_command::cell {
namespace {

CellPlace station(std::size_t index) {
  CellPlace place;
  place.station = index;
  return place;
}
CellPlace onPath(std::size_t behind) {
  CellPlace place;
  place.behind = behind;
  return place;
}

class PlaceFit : public testing::Test {
 protected:
  [[nodiscard]] bool fits(const CellPlace& place, double degrees) const {
    return placeFits(*artifact, 0, place, turned(degrees));
  }

  std::shared_ptr<Artifact> artifact = artifactOfTurn();
};

TEST_F(PlaceFit, ofAStationIsWithinHalfADegree) {
  EXPECT_TRUE(fits(station(0), 0.49));
  EXPECT_FALSE(fits(station(0), 0.51));
  EXPECT_TRUE(fits(station(1), 89.51));
  EXPECT_FALSE(fits(station(1), 0));
  artifact->parameters.tracking = degToRad(1.5);
  EXPECT_TRUE(fits(station(0), 1.4));
}

TEST_F(PlaceFit, ofAPathIsAtItsPiecesWithinTracking) {
  EXPECT_TRUE(fits(onPath(2), 30));
  EXPECT_TRUE(fits(onPath(2), 90.09));
  EXPECT_FALSE(fits(onPath(2), 90.11));
  arm::JointVector joints = turned(30);
  joints[4] = degToRad(0.11);
  EXPECT_FALSE(placeFits(*artifact, 0, onPath(2), joints));
}

TEST_F(PlaceFit, ofAPathIsInNoFrameOfABookingThatIsToCome) {
  EXPECT_TRUE(fits(onPath(0), 0.49)) << "it stands where it set out, as near as at the station";
  EXPECT_FALSE(fits(onPath(0), 10));
  EXPECT_TRUE(fits(onPath(1), 10));
  EXPECT_TRUE(fits(onPath(1), 45));
  EXPECT_FALSE(fits(onPath(1), 50));
  EXPECT_TRUE(fits(onPath(2), 50));
}

TEST_F(PlaceFit, ofAPathIsBehindItsLastRelease) {
  EXPECT_TRUE(fits(onPath(2), 60));
  EXPECT_FALSE(fits(onPath(3), 60));
  EXPECT_FALSE(fits(onPath(3), 0)) << "it is on its way for long";
  EXPECT_TRUE(fits(onPath(3), 70));
}

TEST(PiecesBehind, areThoseBetweenTheLastReleaseAndTheNextBooking) {
  const ArtifactPath path = quarterTurn();
  const PathProgram program = programOfTurn();
  const auto expect = [&](std::size_t behind, std::size_t first, std::size_t end) {
    const PieceSpan span = piecesBehind(path, program, behind);
    EXPECT_EQ(span.first, first) << behind;
    EXPECT_EQ(span.end, end) << behind;
  };
  expect(0, 0, 0);
  expect(1, 0, 3);
  expect(2, 0, 6);
  expect(3, 4, 6);
}

}  // namespace
}  // namespace cobot_command::cell
