#include "files/path_file.h"

#include <string>

#include "source_tree.h"
#include <gmock/gmock.h>

#include "cobot_command/arm/controller_pose.h"

namespace cobot_command::ros_adapter {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kPoint =
    "points:\n"
    "  - interpolation_type: PTP\n"
    "    joints: [1, 2, 3, 4, 5, 6]\n";

/// A point of which nothing more is said but this line.
path::PathPoint pointWith(const std::string& line) {
  const auto points = parsePath(std::string(kPoint) + "    " + line + "\n", "cell.yaml");
  if (points && points->size() == 1) return points->front();
  ADD_FAILURE() << (points ? "not one point" : points.error());
  return {};
}

std::string errorOf(const std::string& text) {
  const auto points = parsePath(text, "cell.yaml");
  return points ? "no error" : points.error();
}
std::string errorWith(const std::string& line) {
  return errorOf(std::string(kPoint) + "    " + line + "\n");
}

/// What the file of the package says, a TM5-900 does.
TEST(PathFile, thatComesWithThePackageCanBeGone) {
  auto points = readPathFile(test_support::inSourceTree("config/path.yaml"));
  ASSERT_TRUE(points) << points.error();
  blocks::LoadPathGoal goal;
  goal.number_of_moves = static_cast<int>(points->size());
  goal.path = std::move(*points);
  EXPECT_TRUE(check(goal).empty());
  const auto arm = *arm::ArmModel::named("tm5-900");
  blocks::PlanningScene scene;
  scene.arm = &arm;
  scene.start.emplace();
  scene.start->joints = arm::toJointVector({0, 0, 90, 0, 90, 0});
  const blocks::Outcome planned = plan(goal, scene);
  ASSERT_EQ(planned.ending, blocks::Ending::Done) << planned.error_description;
  EXPECT_TRUE(planned.detail.as<blocks::PathReport>().blends_lost.empty());
}

TEST(PathFile, isReadAsItStands) {
  const path::PathPoint point = pointWith("move_id: 7");
  EXPECT_EQ(point.move_id, 7);
  EXPECT_THAT(point.joints, ElementsAre(1, 2, 3, 4, 5, 6, 0, 0, 0));
  EXPECT_EQ(point.pose_type, static_cast<int>(path::MovedFrame::Flange)) << "unless it says otherwise";
  EXPECT_EQ(point.ref_frame_type, static_cast<int>(path::Reference::Robot));
  EXPECT_EQ(pointWith("move_type: INCREMENTAL").move_type, 1);
  EXPECT_EQ(pointWith("pose_type: TOOL").pose_type, 3);
  EXPECT_EQ(pointWith("pose_id: 5").pose_id, 5);
  EXPECT_EQ(pointWith("ref_frame_type: USER").ref_frame_type, 4);
  EXPECT_EQ(pointWith("ref_frame_type: WORLD").ref_frame_type, 0);
  EXPECT_EQ(pointWith("ref_frame_id: 6").ref_frame_id, 6);
  EXPECT_EQ(pointWith("termination_type: BLEND").termination_type, 6);
  EXPECT_EQ(pointWith("command_tolerance: 2.5").command_tolerance, 2.5);
  EXPECT_EQ(pointWith("profile_type: MOD_SINE").profile_type, 2);
  EXPECT_EQ(pointWith("speed: 1.5").speed, 1.5);
  EXPECT_EQ(pointWith("acceleration: 1.5").acceleration, 1.5);
  EXPECT_EQ(pointWith("deceleration: 1.5").deceleration, 1.5);
  EXPECT_EQ(pointWith("acceleration_jerk: 15").acceleration_jerk, 15);
  EXPECT_EQ(pointWith("deceleration_jerk: 15").deceleration_jerk, 15);
  EXPECT_EQ(pointWith("orientation_speed: 15").orientation_speed, 15);
  EXPECT_EQ(pointWith("orientation_acceleration: 15").orientation_acceleration, 15);
  EXPECT_EQ(pointWith("orientation_deceleration: 15").orientation_deceleration, 15);
  EXPECT_EQ(pointWith("tracking_axis_position: 15").tracking_axis_position, 15);
}

/// Value 5 of the manual: righty, above, no flip.
TEST(PathFile, hasPosturesByTheirNames) {
  EXPECT_EQ(pointWith("name: keeps it").robot_configuration, 0);
  EXPECT_EQ(pointWith("robot_configuration: [RIGHTY, ABOVE, NOFLIP]").robot_configuration, 5);
  EXPECT_EQ(pointWith("robot_configuration: [LEFTY, ABOVE, FLIP]").robot_configuration, 15);
  EXPECT_EQ(pointWith("robot_configuration: [RIGHTY, BELOW, NOFLIP]").robot_configuration, 1);
  EXPECT_THAT(
      errorWith("robot_configuration: [LEFTY, UP, FLIP]"),
      HasSubstr("cell.yaml:4: robot_configuration[1] is something else; it must be one of: BELOW, ABOVE"));
}

TEST(PathFile, hasTargetsOfItsKinds) {
  const auto points = parsePath(
      "points:\n"
      "  - {interpolation_type: CP_CIRCULAR, target_point_type: CARTESIAN, pose: [1, 2, 3, 4, 5, 6], "
      "via_pose: [7, 8, 9]}\n"
      "  - {interpolation_type: CP_WRIST, target_point_type: HYBRID, pose: [1, 2, 3, 0, 0, 0], "
      "joints: [0, 0, 0, 4, 5, 6]}\n",
      "cell.yaml");
  ASSERT_TRUE(points) << points.error();
  EXPECT_EQ(points->at(0).interpolation, 3);
  EXPECT_THAT(points->at(0).via_pose, ElementsAre(7, 8, 9, 0, 0, 0));
  EXPECT_EQ(points->at(1).interpolation, 2);
  EXPECT_EQ(points->at(1).target_type, 2);
}

TEST(PathFile, namesTheLineOfWhatIsWrong) {
  EXPECT_THAT(errorWith("sped: 10"), HasSubstr("cell.yaml:4: unknown key in a point; known: name, move_id"));
  EXPECT_THAT(errorWith("speed: fast"),
              HasSubstr("cell.yaml:4: speed is something else; it must be a number"));
  EXPECT_THAT(errorWith("profile_type: 2"),
              HasSubstr("cell.yaml:4: profile_type is something else; it must be one of: S_CURVE"));
  EXPECT_THAT(errorWith("joints: [1]"), HasSubstr("cell.yaml:4: joints is twice in a point"));
  EXPECT_THAT(errorWith("pose: [1, 2]"),
              HasSubstr("cell.yaml:4: pose is a list of 2; it must be a list of 6"));
}

/// Nobody means a target of zeros by leaving it out.
TEST(PathFile, needsTheTargetOfAPoint) {
  EXPECT_THAT(errorOf("points:\n  - interpolation_type: PTP\n"), HasSubstr("cell.yaml:2: joints is missing"));
  EXPECT_THAT(errorOf("points:\n  - {interpolation_type: PTP, target_point_type: CARTESIAN}\n"),
              HasSubstr("pose is missing"));
  EXPECT_THAT(errorOf("points:\n  - {joints: [1, 2, 3, 4, 5, 6]}\n"),
              HasSubstr("interpolation_type is missing"));
  EXPECT_THAT(errorWith("target_point_type: HYBRID"), HasSubstr("pose is missing"));
  EXPECT_THAT(errorOf("points:\n  - {interpolation_type: CP_CIRCULAR, joints: [1, 2, 3, 4, 5, 6]}\n"),
              HasSubstr("via_pose is missing"));
}

TEST(PathFile, isCountedBeforeItIsRead) {
  EXPECT_THAT(errorOf("points: 3"), HasSubstr("points is something else; it must be a list"));
  std::string text = "points: [";
  for (int i = 0; i < 1001; ++i) text += "x,";
  EXPECT_THAT(errorOf(text + "]"), HasSubstr("points is a list of 1001; it must have 1..1000 points"));
}

TEST(PathFile, isALocationLikeThatOfAStepsFile) {
  const auto fault = [](const std::string& location) {
    const auto points = readPathFile(location);
    return points ? std::string("no error") : points.error();
  };
  EXPECT_THAT(fault("path.yaml"), HasSubstr("path_file is 'path.yaml'; it must be an absolute path"));
  EXPECT_THAT(fault("/no/such/path.yaml"), HasSubstr("/no/such/path.yaml"));
  EXPECT_THAT(fault("/dev/zero"), HasSubstr("/dev/zero"));
}

/// Its bytes may be any.
TEST(PathFile, saysNothingThatStandsInIt) {
  EXPECT_THAT(errorWith("\x01speed: \xff"), Not(HasSubstr("\xff")));
}

}  // namespace
}  // namespace cobot_command::ros_adapter
