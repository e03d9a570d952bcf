// What a path is refused for: the number, the point and the joint.
#include <cmath>
#include <limits>
#include <string>

#include "path_support.h"

namespace cobot_command::path {
namespace {

const double kNan = std::nan("");
constexpr double kInf = std::numeric_limits<double>::infinity();

PathPoint good() {
  return toJoints({10, 0, 90, 0, 90, 0});
}
PathPoint goodLine() {
  return incremental(toPose({0, 20, 0, 0, 0, 0}));
}

/// A good point that one change makes bad.
struct Recipe {
  const char* name;
  int error_id;
  PathPoint point;
  int joint = -1;
};

template <class Value>
PathPoint with(PathPoint point, Value PathPoint::*field, Value value) {
  point.*field = value;
  return point;
}
PathPoint withJoint8(double value) {
  PathPoint point = good();
  point.joints[7] = value;
  return point;
}
PathPoint inFrame(PathPoint point, int frame) {
  point.move_type = number(MoveType::Absolute);
  point.ref_frame_type = number(Reference::User);
  point.ref_frame_id = frame;
  return point;
}
PathPoint ofTool(PathPoint point, int tool) {
  point.move_type = number(MoveType::Absolute);
  point.pose_type = number(MovedFrame::Tool);
  point.pose_id = tool;
  return point;
}

/// As nobody knows of which kind it is, nothing of a kind is missing.
PathPoint ofNoInterpolation() {
  PathPoint point = with(good(), &PathPoint::interpolation, -1);
  point.orientation_speed = point.orientation_acceleration = point.orientation_deceleration = 0;
  return point;
}

std::vector<Recipe> recipes() {
  return {{"noSpeed", 1013, with(good(), &PathPoint::speed, 0.0)},
          {"negativeDeceleration", 1013, with(good(), &PathPoint::deceleration, -1.0)},
          {"speedNotANumber", 1013, with(good(), &PathPoint::speed, kNan)},
          {"jerk", 1014, with(good(), &PathPoint::acceleration_jerk, 101.0)},
          {"jerkNotANumber", 1014, with(good(), &PathPoint::deceleration_jerk, kNan)},
          {"orientationSpeed", 1015, with(goodLine(), &PathPoint::orientation_speed, 0.0)},
          {"moveType", 1017, with(good(), &PathPoint::move_type, 2)},
          {"targetType", 1018, with(good(), &PathPoint::target_type, 3)},
          {"interpolation", 1020, with(goodLine(), &PathPoint::interpolation, 4)},
          {"interpolationWithoutTurnRates", 1020, ofNoInterpolation()},
          {"tolerance", 1022, blending(good(), -0.1)},
          {"toleranceNotANumber", 1022, blending(good(), kNan)},
          {"infiniteTolerance", 1022, blending(goodLine(), kInf)},
          {"ptpTolerance", 1023, blending(good(), 100.1)},
          {"termination", 1024, with(good(), &PathPoint::termination_type, 1)},
          {"profile", 1025, with(good(), &PathPoint::profile_type, 4)},
          {"configuration", 1026, with(good(), &PathPoint::robot_configuration, 16)},
          {"poseType", 1027, with(goodLine(), &PathPoint::pose_type, 0)},
          {"reference", 1028, with(goodLine(), &PathPoint::ref_frame_type, 3)},
          {"toolNumber", 1029, ofTool(goodLine(), 16)},
          {"frameNumber", 1030, inFrame(goodLine(), -1)},
          {"emptyTool", 1031, ofTool(goodLine(), 7)},
          {"emptyFrame", 1032, inFrame(goodLine(), 7)},
          {"jointLimit", 1033, toJoints({0, 0, 160, 0, 90, 0}), 2},
          {"targetNotANumber", 1037, incremental(toPose({kNan, 0, 0, 0, 0, 0}))},
          {"targetTooFar", 1037, toPose({100001, 0, 0, 0, 0, 0})},
          {"world", 1040, with(goodLine(), &PathPoint::ref_frame_type, 0)},
          {"noSolution", 1044, toPose({800, -122.3, 100, 180, 0, 90}, Interpolation::Ptp, 13)},
          {"reach", 1046, toPose({2000, 0, 500, 180, 0, 90}, Interpolation::Ptp)},
          {"reachOnTheWay", 1046, toPose({2000, 0, 500, 180, 0, 90})},
          {"otherConfiguration", 1048, toPose({517.5, -100, 461.05, 180, 0, 90}, Interpolation::Linear, 13)},
          {"disabledJoint", 1058, withJoint8(1), 7},
          {"jointSpeed", 0x204, with(toJoints({150, 0, 90, 0, 90, 0}), &PathPoint::speed, 400.0), 0}};
}

class RefusedPoints : public Paths, public ::testing::WithParamInterface<Recipe> {};

TEST_P(RefusedPoints, nameTheirNumberPointAndJoint) {
  const Recipe& recipe = GetParam();
  const PathRefusal refusal = refused({recipe.point});
  EXPECT_EQ(refusal.error_id, recipe.error_id) << refusal.found;
  EXPECT_EQ(refusal.index, 0);
  EXPECT_EQ(refusal.joint, recipe.joint);
  const bool says_what_to_do = refusal.found.find(": ") != std::string::npos;
  EXPECT_TRUE(says_what_to_do) << refusal.found;
}

TEST_P(RefusedPoints, behindGoodOnesAreNamedByTheirIndex) {
  const Recipe& recipe = GetParam();
  const PathPoint stays = toJoints({0, 0, 90, 0, 90, 0});
  PathPoint bad = recipe.point;
  if (bad.speed == 0.0) bad.speed = -1.0;  // behind others 0 is to be kept
  const PathRefusal refusal = refused({stays, stays, bad});
  EXPECT_EQ(refusal.error_id, recipe.error_id) << refusal.found;
  EXPECT_EQ(refusal.index, 2);
}

INSTANTIATE_TEST_SUITE_P(All, RefusedPoints, ::testing::ValuesIn(recipes()),
                         [](const auto& recipe) { return std::string(recipe.param.name); });

TEST_F(Paths, areRefusedForASectionOutsideTheArray) {
  const auto refused_section = [&](int start, int count) {
    PathSection section = sectionOf(std::vector<PathPoint>(20, good()));
    section.start_index = start;
    section.number_of_moves = count;
    return refused(section).error_id;
  };
  EXPECT_EQ(refused_section(15, 6), 1010);
  EXPECT_EQ(refused_section(0, 0), 1010);
  EXPECT_EQ(refused_section(0, 21), 1010);
  EXPECT_EQ(refused_section(20, 1), 1012);
  EXPECT_EQ(refused_section(-1, 1), 1012);
  constexpr int kMost = std::numeric_limits<int>::max();
  EXPECT_EQ(refused_section(kMost, kMost), 1010);
  EXPECT_EQ(refused(PathSection{}).error_id, 1010);
  EXPECT_EQ(refused(sectionOf(std::vector<PathPoint>(1001, good()))).error_id, 1010);
}

TEST_F(Paths, areRefusedForTheFirstPointThatIsWrong) {
  const PathPoint profile = with(good(), &PathPoint::profile_type, 9);
  const PathPoint speed = with(good(), &PathPoint::speed, -1.0);
  const PathRefusal refusal = refused({good(), profile, speed});
  EXPECT_EQ(refusal.error_id, 1025);
  EXPECT_EQ(refusal.index, 1);
}

TEST_F(Paths, areCheckedAsAWholeBeforeAnyPointIsPlanned) {
  const PathPoint too_far = toJoints({0, 0, 160, 0, 90, 0});
  EXPECT_EQ(refused({too_far, with(good(), &PathPoint::profile_type, 9)}).error_id, 1025);
}

TEST_F(Paths, areRefusedForMoreThanThreeReferences) {
  tables::Entries entries;
  for (std::size_t i = 1; i <= 4; ++i) entries.frames.at(i) = tables::Frame{"", arm::Pose::Identity(), 0};
  scene.tables = *tables::DataTables::of(entries, {});
  std::vector<PathPoint> points;
  for (int i = 1; i <= 4; ++i) points.push_back(inFrame(toPose(flangeAt(scene.start)), i));
  const PathRefusal refusal = refused(points);
  EXPECT_EQ(refusal.error_id, 1038);
  EXPECT_EQ(refusal.index, 3);
}

TEST_F(Paths, areRefusedForEntriesWhoseValueNobodyKnows) {
  tables::Entries entries;
  entries.tools[2] = tables::Tool{"gripper", std::nullopt, 0};
  entries.frames[3] = tables::Frame{"table", std::nullopt, 0};
  scene.tables = *tables::DataTables::of(entries, {});
  const PathPoint line = toPose(flangeAt(scene.start));
  EXPECT_EQ(refused({ofTool(line, 2)}).error_id, 1041);
  EXPECT_EQ(refused({inFrame(line, 3)}).error_id, 1042);
}

TEST_F(Paths, ofMoreThanThreeHoursAreRefused) {
  PathPoint slow = with(toJoints({90, 0, 90, 0, 90, 0}), &PathPoint::speed, 0.0125);  // two hours
  PathPoint back = with(toJoints({0, 0, 90, 0, 90, 0}), &PathPoint::speed, 0.0125);
  const PathRefusal refusal = refused({slow, back});
  EXPECT_EQ(refusal.error_id, path_error::kNotPlannable);
  EXPECT_EQ(refusal.index, 1);
  EXPECT_FALSE(refusal.where);
}

TEST_F(Paths, thatCannotBeReachedSayWhere) {
  const arm::ControllerPose pose{2000, 0, 500, 180, 0, 90};
  const PathRefusal refusal = refused({toPose(pose, Interpolation::Ptp)});
  ASSERT_TRUE(refusal.where);
  EXPECT_NEAR(refusal.where->translation().x(), 2.0, 1e-9);
  const PathRefusal outside = refused({toJoints({0, 0, 160, 0, 90, 0})});
  EXPECT_TRUE(outside.where);
}

TEST_F(Paths, areRefusedForAFlipThatDoesNotGoWithJ5BeforeAnythingIsPlanned) {
  PathPoint flip = toHybrid({500, -120, 400}, {0, -30, 0}, Interpolation::Ptp);
  flip.robot_configuration = 1;
  const PathRefusal refusal = refused({flip, with(good(), &PathPoint::termination_type, 1)});
  EXPECT_EQ(refusal.error_id, 1026);
  EXPECT_EQ(refusal.index, 0);
}

TEST_F(Paths, straightFromASingularityAreRefusedWithTheJoint) {
  scene.start = degrees(0, 0, 90, 0, 0, 0);
  const PathRefusal refusal = refused({goodLine()});
  EXPECT_EQ(refusal.error_id, 1045);
  EXPECT_EQ(refusal.joint, 4);
}

TEST_F(Paths, straightFromOutsideTheLimitsAreRefused) {
  scene.start = degrees(0, 0, 160, 0, 90, 0);
  const PathRefusal refusal = refused({goodLine()});
  EXPECT_EQ(refusal.error_id, 1043);
  EXPECT_EQ(refusal.joint, 2);
}

TEST_F(Paths, alongAnArcWithoutACircleAreRefused) {
  PathPoint arc = toPose(flangeAt(scene.start), Interpolation::Circular);
  arc.via_pose = arc.pose;
  EXPECT_EQ(refused({arc}).error_id, 1037);
}

}  // namespace
}  // namespace cobot_command::path
