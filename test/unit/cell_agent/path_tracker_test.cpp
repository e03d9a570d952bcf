// How far a robot is on its path, by its joints and by what was sent.
#include "agent/path_tracker.h"

#include "made_path.h"
#include <gtest/gtest.h>

namespace cobot_command::cell {
namespace {

using std::chrono::seconds;

const double kTracking = degToRad(0.1);

class PathTrackerTest : public testing::Test {
 protected:
  bool see(double degrees) { return tracker.see(turned(degrees)); }
  [[nodiscard]] std::optional<PathTracker> located(std::size_t behind, double degrees) const {
    return PathTracker::located(path, programOfTurn(), turned(0), kTracking, behind, turned(degrees));
  }

  ArtifactPath path = quarterTurn();
  PathTracker tracker{path, turned(0), kTracking};
};

TEST_F(PathTrackerTest, isAtItsBeginningUntilAFrameIsSent) {
  EXPECT_TRUE(see(0));
  EXPECT_TRUE(see(0.09));
  EXPECT_FALSE(see(0.11));
  EXPECT_EQ(tracker.piece(), std::nullopt);
  EXPECT_TRUE(tracker.isAtEnd(turned(0)));
  EXPECT_FALSE(tracker.allSent());
  EXPECT_TRUE(tracker.willTouch(0)) << "nothing is known of it yet";
  EXPECT_EQ(tracker.remaining(), Duration::zero());
}

TEST_F(PathTrackerTest, followsTheJointsAlongTheFramesThatWereSent) {
  tracker.sent();
  EXPECT_TRUE(see(10));
  EXPECT_EQ(tracker.piece(), 0U);
  EXPECT_TRUE(see(30));
  EXPECT_EQ(tracker.piece(), 1U);
  EXPECT_FALSE(tracker.isAtEnd(turned(30)));
  EXPECT_TRUE(see(45));
  EXPECT_TRUE(tracker.isAtEnd(turned(45)));
  EXPECT_FALSE(see(50)) << "that frame was not sent";
  tracker.sent();
  EXPECT_TRUE(tracker.allSent());
  EXPECT_TRUE(see(50));
  EXPECT_EQ(tracker.piece(), 3U);
}

TEST_F(PathTrackerTest, neverGoesBack) {
  tracker.sent();
  EXPECT_TRUE(see(30));
  EXPECT_FALSE(see(10));
  EXPECT_EQ(tracker.piece(), 1U);
}

TEST_F(PathTrackerTest, knowsAnyJointThatIsOff) {
  tracker.sent();
  for (Eigen::Index joint = 0; joint < 6; ++joint) {
    arm::JointVector joints = turned(10);
    joints[joint] += joint == 0 ? degToRad(40) : degToRad(0.2);
    EXPECT_FALSE(tracker.see(joints)) << joint;
    joints = turned(10);
    joints[joint] -= degToRad(0.09);
    EXPECT_TRUE(tracker.see(joints)) << joint;
  }
}

TEST_F(PathTrackerTest, touchesWhatIsAheadInTheFramesThatWereSent) {
  tracker.sent();
  see(10);
  EXPECT_TRUE(tracker.willTouch(0));
  EXPECT_FALSE(tracker.willTouch(1)) << "that frame was not sent";
  tracker.sent();
  EXPECT_TRUE(tracker.willTouch(1));
  see(60);
  EXPECT_TRUE(tracker.willTouch(0));
  see(80);
  EXPECT_FALSE(tracker.willTouch(0));
  EXPECT_TRUE(tracker.willTouch(1));
}

TEST_F(PathTrackerTest, isInTheRestWhereAMotionEnds) {
  tracker.sent();
  see(44);
  EXPECT_EQ(tracker.piece(), 1U);
  see(45);
  EXPECT_EQ(tracker.piece(), 2U);
  tracker.sent();
  EXPECT_EQ(tracker.piece(), 1U) << "now there is something behind it";
  see(45);
  EXPECT_EQ(tracker.piece(), 1U);
}

TEST_F(PathTrackerTest, isInItsLastRestOnceAllOfItsFrameIsDone) {
  ArtifactPiece without_its_part = path.pieces[2];
  without_its_part.zones.clear();
  path.pieces.insert(path.pieces.begin() + 3, without_its_part);
  tracker.sent();
  see(45);
  EXPECT_EQ(tracker.piece(), 2U);
  EXPECT_TRUE(tracker.willTouch(0)) << "with what it has not set down yet";
  tracker.done();
  EXPECT_EQ(tracker.piece(), 3U);
  EXPECT_FALSE(tracker.willTouch(0));
  tracker.sent();
  EXPECT_TRUE(tracker.willTouch(0)) << "on the way that is behind it";
}

TEST_F(PathTrackerTest, isNotAtTheEndWhereItOnlyComesByThere) {
  // The way out ends where it has begun, and comes by the zone in between.
  path.pieces[3].range = between(22.5, 45);
  path.pieces[4].range = between(0, 22.5);
  path.pieces[5].range = between(0, 0);
  tracker.sent();
  tracker.sent();
  see(0);
  EXPECT_TRUE(tracker.isAtEnd(turned(0)));
  EXPECT_EQ(tracker.piece(), 0U);
  EXPECT_TRUE(tracker.willTouch(0));
}

TEST_F(PathTrackerTest, hasTheTimeLeftOfTheFrameThatWasSentLast) {
  tracker.sent();
  see(10);
  EXPECT_EQ(tracker.remaining(), seconds(2));
  see(30);
  EXPECT_EQ(tracker.remaining(), seconds(0));
  tracker.sent();
  EXPECT_EQ(tracker.remaining(), seconds(4)) << "all of the second one";
}

TEST_F(PathTrackerTest, isLocatedWhereAFrameEnds) {
  const auto at_start = located(1, 0);
  ASSERT_TRUE(at_start);
  EXPECT_EQ(at_start->nextFrame(), 0U);
  EXPECT_EQ(at_start->resumesWithin(), std::nullopt);
  const auto at_middle = located(1, 45);
  ASSERT_TRUE(at_middle);
  EXPECT_EQ(at_middle->nextFrame(), 1U);
  EXPECT_TRUE(at_middle->isAtEnd(turned(45)));
  const auto at_end = located(3, 90);
  ASSERT_TRUE(at_end);
  EXPECT_TRUE(at_end->allSent());
}

TEST_F(PathTrackerTest, goesOnFromWithinAMotionThatIsStraightInJoints) {
  auto resumed = located(1, 30);
  ASSERT_TRUE(resumed);
  EXPECT_EQ(resumed->nextFrame(), 0U) << "it is sent once more";
  ASSERT_TRUE(resumed->resumesWithin());
  EXPECT_TRUE(resumed->see(turned(30)));
  EXPECT_FALSE(resumed->see(turned(10)));
  EXPECT_FALSE(resumed->isAtEnd(turned(45)));
  EXPECT_TRUE(resumed->willTouch(0));
  resumed->sent();
  EXPECT_EQ(resumed->resumesWithin(), std::nullopt);
  EXPECT_TRUE(resumed->see(turned(40)));
}

TEST_F(PathTrackerTest, doesNotGoOnFromWithinOtherMotions) {
  path.frames[0].lines = {"Line(\"CPP\",45,0,0,0,0,0,30,200,0,false)"};
  EXPECT_FALSE(located(1, 30));
  path.frames[0].lines = {"PTP(\"CPP\",45,0,0,0,0,0,30,200,0,false)"};
  EXPECT_FALSE(located(1, 30));
  path.frames[0].lines = {"PTP(\"JPP\",45,0,0,0,0,0,30,200,0,false)", "ChangeLoad(2)"};
  EXPECT_FALSE(located(1, 30));
}

TEST_F(PathTrackerTest, isNotLocatedWhereThePlaceOfTheProgramCannotBe) {
  EXPECT_FALSE(located(1, 60)) << "zone 1 was not booked";
  EXPECT_TRUE(located(2, 60));
  EXPECT_FALSE(located(3, 60)) << "zone 0 was released, and this touches it";
  EXPECT_FALSE(located(2, 95));
}

}  // namespace
}  // namespace cobot_command::cell
