// Planned paths as RViz shows them, and which of them.
#include "paths/path_markers.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

namespace cobot_command::ros_adapter {
namespace {

using ::testing::HasSubstr;
using visualization_msgs::Marker;

const MarkerSite kSite{"left_base", ros::Time(3)};

arm::Pose at(double x, double y, double z) {
  arm::Pose pose = arm::Pose::Identity();
  pose.translation() = Eigen::Vector3d(x, y, z);
  return pose;
}

/// A corner at x = 0.1, and a stop at y = 0.2.
path::PathPreview corner() {
  path::PathPreview preview;
  preview.points = {{4, {0.1, 0, 0}, 0.02}, {5, {0.1, 0.2, 0}, 0}};
  preview.lines = {{{0, 0, 0}, {0.08, 0, 0}, {0.1, 0.02, 0}, {0.1, 0.2, 0}}};
  return preview;
}

path::PathPreview refusedBehindACorner(std::optional<arm::Pose> where) {
  path::PathPreview preview = corner();
  preview.refusal = path::PathRefusal{
      1046, 6, -1, "the target is 1.90 m from the shoulder, 0.93 m are in reach", std::move(where)};
  return preview;
}

class PathMarkers : public ::testing::Test {
 protected:
  [[nodiscard]] std::vector<Marker> named(const std::string& name) const {
    std::vector<Marker> found;
    for (const Marker& marker : toPoints(board.shown(), kSite).markers) {
      if (marker.ns == name) found.push_back(marker);
    }
    return found;
  }

  PathBoard board;
};

TEST_F(PathMarkers, ofAPlannedMotionAreALineThroughItsPointsInTheRobotBase) {
  const Marker marker = toLine({at(0.1, 0, 0), at(0.2, 0, 0), at(0.2, 0.3, 0)}, kSite);
  EXPECT_EQ(marker.header.frame_id, "left_base");
  EXPECT_EQ(marker.type, Marker::LINE_STRIP);
  EXPECT_EQ(marker.action, Marker::ADD);
  ASSERT_EQ(marker.points.size(), 3U);
  EXPECT_EQ(marker.points[2].x, 0.2);
  EXPECT_EQ(marker.points[2].y, 0.3);
  EXPECT_EQ(marker.pose.orientation.w, 1);
  EXPECT_GT(marker.scale.x, 0);
  EXPECT_GT(marker.color.a, 0);
}

TEST_F(PathMarkers, withoutALineTakeTheLastOneAway) {
  EXPECT_EQ(toLine({at(0, 0, 0)}, kSite).action, Marker::DELETE);
  EXPECT_EQ(toLine(board.shown(), kSite).action, Marker::DELETE);
}

TEST_F(PathMarkers, haveOneLineForThePathsOfAllGoals) {
  board.show(1, corner());
  path::PathPreview tool = corner();
  tool.lines.push_back({{0, 0, 1}, {0, 1, 1}});
  board.show(2, tool);
  const Marker line = toLine(board.shown(), kSite);
  EXPECT_EQ(line.type, Marker::LINE_LIST) << "nothing is drawn from the end of one to the begin of the next";
  EXPECT_EQ(line.points.size(), 2U * (3 + 3 + 1));
  EXPECT_EQ(line.ns, toLine({at(0, 0, 0)}, kSite).ns) << "each takes the place of the other";
}

TEST_F(PathMarkers, tellCornersFromPointsAtWhichTheRobotRests) {
  board.show(1, corner());
  ASSERT_EQ(named("points").size(), 1U);
  ASSERT_EQ(named("points")[0].points.size(), 1U);
  EXPECT_EQ(named("points")[0].points[0].y, 0.2);
  ASSERT_EQ(named("corners").size(), 1U);
  EXPECT_EQ(named("corners")[0].points[0].x, 0.1);
}

TEST_F(PathMarkers, haveASphereAroundACornerThatThePathIsLeftAt) {
  board.show(1, corner());
  const auto blends = named("blends");
  ASSERT_EQ(blends.size(), 1U);
  EXPECT_EQ(blends[0].pose.position.x, 0.1);
  EXPECT_EQ(blends[0].scale.x, 0.04) << "a diameter";
  EXPECT_LT(blends[0].color.a, 0.5) << "the path shows through it";
}

TEST_F(PathMarkers, takeAwayWhatWasThereBefore) {
  const auto none = toPoints(board.shown(), kSite);
  ASSERT_EQ(none.markers.size(), 1U);
  EXPECT_EQ(none.markers[0].action, Marker::DELETEALL);
  board.show(1, corner());
  EXPECT_EQ(toPoints(board.shown(), kSite).markers[0].action, Marker::DELETEALL);
}

TEST_F(PathMarkers, haveNamesAndNumbersOfTheirOwn) {
  board.show(1, refusedBehindACorner(at(2, 0, 0)));
  board.show(2, refusedBehindACorner(at(2, 1, 0)));
  std::set<std::pair<std::string, int>> known;
  for (const Marker& marker : toPoints(board.shown(), kSite).markers) {
    EXPECT_TRUE(known.emplace(marker.ns, marker.id).second) << marker.ns << " " << marker.id;
  }
}

TEST_F(PathMarkers, showThePointThatIsRefusedInRedWithItsErrorBesideIt) {
  board.show(1, refusedBehindACorner(at(2, 0, 0.5)));
  const auto refused = named("refused");
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_EQ(refused[0].pose.position.x, 2);
  EXPECT_GT(refused[0].color.r, 3 * (refused[0].color.g + refused[0].color.b));
  const auto text = named("error");
  ASSERT_EQ(text.size(), 1U);
  EXPECT_EQ(text[0].type, Marker::TEXT_VIEW_FACING);
  EXPECT_EQ(text[0].text, "point 6: the target is 1.90 m from the\nshoulder, 0.93 m are in reach");
  EXPECT_EQ(text[0].pose.position.x, 2);
  EXPECT_GT(text[0].pose.position.z, 0.5);
  EXPECT_EQ(named("points").size(), 1U) << "those in front of it are shown, too";
}

TEST_F(PathMarkers, showTheErrorWhereThePathEndsWhenNobodyKnowsTheTarget) {
  board.show(1, refusedBehindACorner(std::nullopt));
  EXPECT_TRUE(named("refused").empty());
  ASSERT_EQ(named("error").size(), 1U);
  EXPECT_EQ(named("error")[0].pose.position.y, 0.2);
}

TEST_F(PathMarkers, showTheErrorBelowTheFootOfTheArm) {
  for (const double z : {-0.3, 0.2}) {
    board.show(1, refusedBehindACorner(at(-0.1, 0, z)));
    const double below = named("error").at(0).pose.position.z;
    EXPECT_LT(below, std::min(z, -0.05));
    EXPECT_GT(below, std::min(z, 0.0) - 0.25);
  }
}

TEST_F(PathMarkers, highlightThePointThatMovesTheRobot) {
  board.show(1, corner());
  EXPECT_EQ(toActivePoint(board.activePlace(), kSite).action, Marker::DELETE);
  board.setActive(1, 5);
  const Marker active = toActivePoint(board.activePlace(), kSite);
  EXPECT_EQ(active.action, Marker::ADD);
  EXPECT_EQ(active.pose.position.y, 0.2);
  EXPECT_GT(active.scale.x, named("points")[0].scale.x);
  board.end(1);
  EXPECT_EQ(board.activePlace(), std::nullopt);
}

TEST_F(PathMarkers, highlightTheOutgoingPointWhileTwoGoalsBlend) {
  board.show(1, corner());
  board.show(2, corner());
  board.setActive(1, 5);
  board.setActive(2, 4);
  EXPECT_EQ(board.activePlace(), Eigen::Vector3d(0.1, 0.2, 0));
  board.end(1);
  EXPECT_EQ(board.activePlace(), Eigen::Vector3d(0.1, 0, 0));
}

TEST_F(PathMarkers, stayUntilAnotherPathIsPlanned) {
  board.show(1, corner());
  board.show(2, corner());
  board.end(1);
  EXPECT_EQ(board.shown().size(), 2U);
  board.show(3, corner());
  ASSERT_EQ(board.shown().size(), 2U);
  EXPECT_EQ(board.shown()[0].goal, 2U) << "it is under way";
}

TEST_F(PathMarkers, areThoseOfTheLastPlanOfAGoal) {
  board.show(1, corner());
  board.show(1, refusedBehindACorner(at(2, 0, 0)));
  ASSERT_EQ(board.shown().size(), 1U);
  EXPECT_TRUE(board.shown()[0].preview.refusal);
  EXPECT_FALSE(board.shown()[0].ended);
}

}  // namespace
}  // namespace cobot_command::ros_adapter
