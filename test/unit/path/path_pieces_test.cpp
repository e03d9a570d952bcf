// A path in pieces from rest to rest: what is found good is taken by whoever makes it, all else is named.
#include "cobot_command/path/path_pieces.h"

#include "path_support.h"
#include <gmock/gmock.h>

#include "cobot_command/planning/script_planner.h"

namespace cobot_command::path {
namespace {

using std::chrono::milliseconds;
using ::testing::HasSubstr;

class PiecesOfPaths : public Paths {
 protected:
  [[nodiscard]] std::vector<PathPiece> piecesOf(const PathPlan& plan, const PieceLimits& limits = {}) const {
    auto pieces = path::piecesOf(plan, scene, limits);
    EXPECT_TRUE(pieces) << pieces.error().found;
    return pieces ? *std::move(pieces) : std::vector<PathPiece>();
  }
  [[nodiscard]] static PathPoint line(double y, double z = 0) {
    return incremental(toPose({0, y, z, 0, 0, 0}));
  }
  /// To J1 [deg], the other joints as they are.
  [[nodiscard]] static PathPoint turn(double j1, double speed, double acceleration) {
    PathPoint point = incremental(toJoints({j1, 0, 0, 0, 0, 0}));
    point.speed = speed;
    point.acceleration = point.deceleration = acceleration;
    return point;
  }
};

TEST_F(PiecesOfPaths, goFromRestToRestEachFromTime0) {
  const PathPlan plan = planned({blending(line(40), 5), line(0, 40), line(-30), blending(line(0, 20), 2)});
  const auto pieces = piecesOf(plan);
  ASSERT_EQ(pieces.size(), 3U);
  Duration begin{};
  std::size_t point = 0;
  for (const PathPiece& piece : pieces) {
    EXPECT_EQ(piece.block.start, Duration::zero());
    EXPECT_EQ(piece.block.first, 0U);
    EXPECT_EQ(piece.block.last, piece.plan.points().size() - 1);
    EXPECT_EQ(piece.block.ends.rbegin()->second, piece.block.points.size());
    for (const PlannedPoint& one : piece.plan.points()) {
      EXPECT_EQ(one.index, plan.points()[point].index);
      EXPECT_EQ(begin + one.start, plan.points()[point++].start);
    }
    begin += piece.plan.duration();
  }
  EXPECT_EQ(begin, plan.duration());
  EXPECT_EQ(point, 4U);
}

TEST_F(PiecesOfPaths, areThePvtsOfTheWholePlan) {
  const PathPlan plan = planned({blending(line(40), 5), line(0, 40), line(-30)});
  const auto pieces = piecesOf(plan);
  for (std::size_t i = 0, first = 0; i < pieces.size(); ++i) {
    const std::size_t last = endOfBlock(plan, first);
    EXPECT_EQ(script::toText(scriptOf(sampleBlock(plan, first, last), {})),
              script::toText(scriptOf(pieces[i].block, {})));
    first = last + 1;
  }
}

TEST_F(PiecesOfPaths, areReadAsTheyWereWritten) {
  const PathPlan plan = planned({blending(line(33.3), 5), line(0, 17.1)});
  const PvtBlock block = piecesOf(plan).front().block;
  planning::PvtBlock read;
  for (const auto& command : scriptOf(block, {})) {
    if (const auto* point = std::get_if<script::PvtPoint>(&command)) read.points.push_back(*point);
  }
  const auto made = planning::toMotion(read);
  ASSERT_TRUE(made);
  const auto& points = std::get<std::vector<motion::PvtJointPoint>>(std::get<motion::Pvt>(*made).points);
  ASSERT_EQ(points.size(), block.points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_LT((points[i].position - block.points[i].position).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_LT((points[i].velocity - block.points[i].velocity).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_EQ(points[i].duration, block.points[i].duration);
  }
}

TEST_F(PiecesOfPaths, withoutAWayHaveOnlyTheirTags) {
  const auto pieces = piecesOf(planned({toJoints({0, 0, 90, 0, 90, 0}), line(10)}));
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_TRUE(pieces[0].block.points.empty());
  EXPECT_EQ(pieces[0].block.ends.at(0), 0U);
}

TEST_F(PiecesOfPaths, ofAnEmptyPlanAreNone) {
  EXPECT_TRUE(piecesOf(PathPlan(scene.start)).empty());
}

TEST_F(PiecesOfPaths, thatAreTooLongNameThePointAndHowManyThereAre) {
  const PathPlan plan = planned({line(10), blending(line(40), 5), blending(line(0, 40), 5), line(-30)});
  const std::size_t count = piecesOf(plan)[1].block.points.size();
  EXPECT_EQ(piecesOf(plan, {milliseconds(25), count}).size(), 2U);
  const auto refused = path::piecesOf(plan, scene, {milliseconds(25), count - 1});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().error_id, 0x277);
  EXPECT_EQ(refused.error().index, 3);
  EXPECT_THAT(refused.error().found, HasSubstr(std::to_string(count) + " points, allowed " +
                                               std::to_string(count - 1) + ": stop the arm"));
  EXPECT_EQ(path::piecesOf(plan, scene, {milliseconds(25), 20}).error().index, 1);
}

TEST_F(PiecesOfPaths, ofHoursAreRefusedWithoutBeingSampled) {
  PathPoint slow = turn(90, 0.01, 1);
  const PathPlan plan = planned({slow});
  EXPECT_GT(plan.duration(), std::chrono::hours(2));
  EXPECT_EQ(path::piecesOf(plan, scene).error().error_id, path_error::kTooLong);
}

TEST_F(PiecesOfPaths, thatAJointIsTooFastForNameThePointTheJointAndWhatToDo) {
  // The cubics of segments that are longer than a ramp are faster than the plan is anywhere.
  PathPoint fast = turn(60, 180, 7200);
  fast.profile_type = number(ProfileType::SineSquared);
  fast.acceleration_jerk = fast.deceleration_jerk = 100;
  const PathPlan plan = planned({line(10), fast});
  EXPECT_EQ(piecesOf(plan).size(), 2U);
  const auto refused = path::piecesOf(plan, scene, {milliseconds(100)});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().error_id, path_error::kJointSpeed);
  EXPECT_EQ(refused.error().index, 1);
  EXPECT_EQ(refused.error().joint, 0);
  EXPECT_TRUE(refused.error().where);
  EXPECT_THAT(refused.error().found, HasSubstr("rated 180.0 deg/s: choose a lower speed"));
}

/// Half of a ramp of 50 ms that ends so softly: a cubic with its speeds and places alone is faster than its
/// end.
TEST_F(PiecesOfPaths, atTheRatedSpeedAreTakenHoweverSoftlyTheirRampsEnd) {
  PathPoint point = turn(60, 180, 2 * 180 / 0.05);
  point.acceleration_jerk = point.deceleration_jerk = 100;
  for (int profile = 0; profile < 4; ++profile) {
    point.profile_type = profile;
    EXPECT_EQ(piecesOf(planned({line(10), point})).size(), 2U) << profile;
  }
}

TEST_F(PiecesOfPaths, haveNoSegmentsThatCannotBeSent) {
  const auto pieces = piecesOf(planned({line(40)}), {std::chrono::microseconds(100)});
  for (const motion::PvtJointPoint& point : pieces[0].block.points) EXPECT_GE(point.duration, 0.025);
}

TEST_F(PiecesOfPaths, beginWhereTheRobotStandsAlsoOutsideItsLimits) {
  scene.start = degrees(0, 0, 158, 0, 90, 0);  // allowed: 155
  PathPoint back = toJoints({10, 0, 150, 0, 90, 0});
  const PathPlan plan = planned({back, line(5)});
  const auto pieces = piecesOf(plan);
  ASSERT_EQ(pieces.size(), 2U);
  planning::ScriptPlanner maker(scene.arm, scene.start, {});
  for (const PathPiece& piece : pieces) {
    for (const auto& command : scriptOf(piece.block, {})) EXPECT_TRUE(maker.append(command));
  }
}

}  // namespace
}  // namespace cobot_command::path
