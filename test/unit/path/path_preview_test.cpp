// What people are shown of a path.
#include "cobot_command/path/path_preview.h"

#include "path_support.h"

namespace cobot_command::path {
namespace {

class PathPreviews : public Paths {
 protected:
  [[nodiscard]] PathPreview previewed(const std::vector<PathPoint>& points, std::size_t first = 0) const {
    return previewOf(planned(points), first, scene.arm);
  }
  [[nodiscard]] Eigen::Vector3d start() const {
    return arm::forwardKinematics(scene.arm, scene.start).translation();
  }
  /// The pose of the start, moved [mm].
  [[nodiscard]] arm::ControllerPose from(double y, double z) const {
    arm::ControllerPose pose = flangeAt(scene.start);
    pose[1] += y;
    pose[2] += z;
    return pose;
  }
  /// A corner, and a stop.
  [[nodiscard]] std::vector<PathPoint> corner(double tolerance) const {
    return {blending(toPose(from(100, 0)), tolerance), toPose(from(100, 100))};
  }
  static double nearest(const PathPreview::Line& line, const Eigen::Vector3d& place) {
    double least = 1e9;
    for (const Eigen::Vector3d& one : line) least = std::min(least, (one - place).norm());
    return least;
  }
};

TEST_F(PathPreviews, haveTheTargetOfEachPointAlsoOfOneThatIsBlendedPast) {
  const PathPreview preview = previewed(corner(5));
  ASSERT_EQ(preview.points.size(), 2U);
  const Eigen::Vector3d target = start() + Eigen::Vector3d(0, 0.1, 0);
  EXPECT_LT((preview.points[0].place - target).norm(), 1e-6);
  EXPECT_LT((preview.points[1].place - target - Eigen::Vector3d(0, 0, 0.1)).norm(), 1e-6);
  EXPECT_EQ(preview.points[1].index, 1);
  EXPECT_FALSE(preview.refusal);
}

TEST_F(PathPreviews, sayHowFarFromACornerThePathIsLeft) {
  const PathPreview preview = previewed(corner(5));
  EXPECT_GT(preview.points[0].blend, 0.0049);
  EXPECT_LE(preview.points[0].blend, 0.005);
  EXPECT_EQ(preview.points[1].blend, 0) << "it rests there";
  EXPECT_EQ(previewed(corner(0)).points[0].blend, 0);
}

TEST_F(PathPreviews, goAroundACornerAndThroughAStop) {
  const PathPreview preview = previewed(corner(5));
  ASSERT_EQ(preview.lines.size(), 1U);
  const PathPreview::Line& line = preview.lines.front();
  EXPECT_LT((line.front() - start()).norm(), 1e-9);
  EXPECT_LT((line.back() - preview.points[1].place).norm(), 1e-9);
  EXPECT_NEAR(nearest(line, preview.points[0].place), 0.00177, 2e-4);
  EXPECT_LT(nearest(previewed(corner(0)).lines.front(), preview.points[0].place), 1e-9);
}

TEST_F(PathPreviews, beginWithTheFirstPointThatIsNew) {
  const PathPreview preview = previewed(corner(5), 1);
  ASSERT_EQ(preview.points.size(), 1U);
  EXPECT_EQ(preview.points[0].index, 1);
  EXPECT_NEAR((preview.lines.front().front() - start()).norm(), 0.095, 1e-4) << "where it joins";
}

TEST_F(PathPreviews, haveALineForEachFrameThatIsMoved) {
  ASSERT_FALSE(scene.tables.writeTool(3, tables::Tool{"", arm::toPose({0, 0, 100, 0, 0, 0}), 0}, {}));
  std::vector<PathPoint> points = corner(0);
  points.push_back(points.front());
  points.back().pose_type = number(MovedFrame::Tool);
  points.back().pose_id = 3;
  points.back().pose[2] -= 100;
  const PathPreview preview = previewed(points);
  ASSERT_EQ(preview.lines.size(), 2U);
  EXPECT_NEAR((preview.lines[1].front() - preview.lines[0].back()).norm(), 0.1, 1e-9);
  EXPECT_LT((preview.lines[1].back() - preview.points[2].place).norm(), 1e-9);
}

TEST_F(PathPreviews, ofManyPointsHaveFewPlacesOfEach) {
  std::vector<PathPoint> points;
  for (int i = 0; i < 500; ++i) points.push_back(toPose(from(20 * (i % 2), 0)));
  const PathPreview preview = previewed(points);
  EXPECT_LE(preview.lines.front().size(), 4001U);
  EXPECT_EQ(preview.points.size(), 500U);
}

}  // namespace
}  // namespace cobot_command::path
