// Path loading: what is wrong with a goal by itself, what its plan finds, and where.

#include <algorithm>
#include <cmath>
#include <string>

#include "block_goals.h"
#include "chain/loaded_path.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using path::PathPoint;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr arm::ControllerJoints kStartDeg{0, 0, 90, 0, 90, 0};
constexpr arm::ControllerPose kStartPose{417.5, -122.3, 461.05, 180, 0, 90};

arm::ControllerPose besideStart(double x, double y, double z) {
  arm::ControllerPose pose = kStartPose;
  pose[0] += x;
  pose[1] += y;
  pose[2] += z;
  return pose;
}

const arm::ArmModel& model() {
  static const arm::ArmModel kModel = *arm::ArmModel::named("tm5-900");
  return kModel;
}

PlanningScene scene() {
  PlanningScene scene;
  scene.arm = &model();
  scene.start.emplace();
  scene.start->joints = arm::toJointVector(kStartDeg);
  return scene;
}

LoadPathGoal goalOf(std::vector<PathPoint> points) {
  LoadPathGoal goal;
  goal.number_of_moves = static_cast<int>(points.size());
  goal.path = std::move(points);
  return goal;
}

const PathReport& reportOf(const Outcome& outcome) {
  return outcome.detail.as<PathReport>();
}

template <class Change>
int pointError(const Change& change) {
  return errorWith<LoadPathGoal>([&](auto& g) { change(g.path[1]); });
}

TEST(LoadPathCheck, letsAGoodGoalPass) {
  EXPECT_EQ(errorOf(good<LoadPathGoal>()), 0);
  EXPECT_EQ(errorWith<LoadPathGoal>([](auto& g) {
              g.path[0] = {};  // is not loaded
              g.start_index = 1;
              g.number_of_moves = 2;
            }),
            0);
}

TEST(LoadPathCheck, looksAtTheSection) {
  EXPECT_EQ(errorOf(LoadPathGoal{}), 1010) << "a goal of zeros";
  EXPECT_EQ(errorWith<LoadPathGoal>([](auto& g) {
              g.path.resize(20, g.path[0]);
              g.start_index = 15;
              g.number_of_moves = 6;
            }),
            1010);
  EXPECT_EQ(errorWith<LoadPathGoal>([](auto& g) { g.path.resize(1001, g.path[0]); }), 1010);
  EXPECT_EQ(errorWith<LoadPathGoal>([](auto& g) {
              g.start_index = 3;
              g.number_of_moves = 1;
            }),
            1012);
}

TEST(LoadPathCheck, looksAtEachPoint) {
  EXPECT_EQ(errorWith<LoadPathGoal>([](auto& g) { g.path[0].speed = 0; }), 1013);
  EXPECT_EQ(pointError([](PathPoint& p) { p.acceleration_jerk = 101; }), 1014);
  EXPECT_EQ(pointError([](PathPoint& p) {
              p = pathLine(kStartPose);
              p.orientation_speed = 0;
            }),
            1015);
  EXPECT_EQ(pointError([](PathPoint& p) { p.move_type = 2; }), 1017);
  EXPECT_EQ(pointError([](PathPoint& p) { p.target_type = 3; }), 1018);
  EXPECT_EQ(pointError([](PathPoint& p) {
              p = pathLine(kStartPose);
              p.interpolation = 4;
            }),
            1020);
  EXPECT_EQ(pointError([](PathPoint& p) {
              p.termination_type = 6;
              p.command_tolerance = -0.1;
            }),
            1022);
  EXPECT_EQ(pointError([](PathPoint& p) {
              p.termination_type = 6;
              p.command_tolerance = 100.1;
            }),
            1023);
  EXPECT_EQ(pointError([](PathPoint& p) { p.termination_type = 1; }), 1024);
  EXPECT_EQ(pointError([](PathPoint& p) { p.profile_type = 4; }), 1025);
  EXPECT_EQ(pointError([](PathPoint& p) { p.robot_configuration = 16; }), 1026);
}

/// What the tables hold is not known before the plan is made.
TEST(LoadPathCheck, leavesEntriesOfTheTablesToThePlan) {
  const LoadPathGoal goal = goalOf({[] {
    PathPoint point = pathLine(kStartPose);
    point.pose_type = static_cast<int>(path::MovedFrame::Tool);
    point.pose_id = 7;
    return point;
  }()});
  EXPECT_EQ(errorOf(goal), 0);
  const Outcome found = plan(goal, scene());
  EXPECT_EQ(found.ending, Ending::Rejected);
  EXPECT_EQ(found.error_id, 1031);
  EXPECT_EQ(reportOf(found).error_index, 0);
}

TEST(LoadPathCheck, looksAtItsOwnParameters) {
  EXPECT_EQ(errorWith<LoadPathGoal>([](auto& g) { g.buffer_mode = 3; }), own_error::kBufferModeUnknown);
  EXPECT_EQ(errorWith<LoadPathGoal>([](auto& g) { g.execution = 3; }), own_error::kExecutionUnknown);
  for (const double deviation : {-1.0, kNan, kInf, 1e6}) {
    EXPECT_EQ(errorWith<LoadPathGoal>([=](auto& g) { g.max_deviation = deviation; }),
              own_error::kDeviationRange);
  }
  EXPECT_EQ(errorWith<LoadPathGoal>([](auto& g) {
              g.path.clear();
              g.path_fault = "no such file";
            }),
            own_error::kPathUnreadable);
}

TEST(LoadPathPlan, isInTheWorldWhereThatIs) {
  PathPoint point = pathPoint({0, 0, 90, 0, 90, 0});
  point.target_type = static_cast<int>(path::TargetType::Cartesian);
  point.ref_frame_type = static_cast<int>(path::Reference::World);
  point.pose = besideStart(0, 0, 0);
  LoadPathGoal goal = goalOf({point});
  goal.check_only = true;
  goal.world_fault = "nobody publishes it";
  const Outcome refused = plan(goal, scene());
  EXPECT_EQ(refused.error_id, 1040);
  EXPECT_THAT(refused.error_description, HasSubstr("nobody publishes it"));
  goal.world = arm::Pose::Identity();
  goal.world->translation().z() = -0.1;
  const Outcome planned = plan(goal, scene());
  ASSERT_EQ(planned.ending, Ending::Done) << planned.error_description;
  const auto& end = reportOf(planned).joint_path.back().joints;
  arm::JointVector joints;
  std::copy(end.begin(), end.end(), joints.data());
  EXPECT_NEAR(arm::forwardKinematics(model(), joints).translation().z(), 0.36105, 1e-6);
}

TEST(LoadPathCheck, refusesToFollowAConveyor) {
  const auto offset = [](bool enabled) {
    return with<LoadPathGoal>([=](auto& g) {
      g.enable_tracking[1] = enabled;
      g.path[2].tracking_axis_position = 5;
    });
  };
  EXPECT_EQ(errorOf(offset(false)), 0) << "without a gate it is ignored";
  EXPECT_EQ(errorOf(offset(true)), own_error::kTrackingOffset);
  EXPECT_EQ(check(offset(true)).front().detail.as<PathReport>().error_index, 2);
}

/// Two violations: speed -1 in point 2, profile 9 in point 1.
TEST(LoadPathCheck, blamesTheFirstPoint) {
  const auto goal = with<LoadPathGoal>([](auto& g) {
    g.path[2].speed = -1;
    g.path[1].profile_type = 9;
    g.execution = 9;
  });
  const Outcome refused = toRejection(kBlock<LoadPathGoal>, check(goal));
  EXPECT_EQ(refused.error_id, 1025);
  EXPECT_EQ(reportOf(refused).error_index, 1);
  EXPECT_EQ(reportOf(refused).error_joint, -1);
  ASSERT_THAT(reportOf(refused).points, SizeIs(2));
  EXPECT_EQ(reportOf(refused).points[1].error_id, 1025);
  EXPECT_THAT(refused.error_description, HasSubstr("point 1: "));
  EXPECT_THAT(refused.error_description, HasSubstr("; also 16#275 "));
}

TEST(LoadPathPlan, tellsWhenEachPointStartsAndHowLongItTakes) {
  LoadPathGoal goal = good<LoadPathGoal>();
  goal.path[0].termination_type = static_cast<int>(path::Termination::Blend);
  goal.path[0].command_tolerance = 20;
  const Outcome found = plan(goal, scene());
  ASSERT_EQ(found.ending, Ending::Done) << found.error_description;
  const PathReport& report = reportOf(found);
  ASSERT_THAT(report.points, SizeIs(3));
  EXPECT_EQ(report.points[0].start, Duration::zero());
  EXPECT_LT(report.points[1].start, report.points[0].duration) << "they blend";
  EXPECT_EQ(report.points[2].start, report.points[1].start + report.points[1].duration);
  EXPECT_EQ(*found.planned, report.points[2].start + report.points[2].duration);
  EXPECT_EQ(report.execution, Execution::Pvt);
  EXPECT_NE(report.execution_reason, "");
  EXPECT_NE(report.loaded, nullptr);
  EXPECT_THAT(report.blends_lost, IsEmpty());
  EXPECT_THAT(report.joint_path, IsEmpty()) << "nobody asked";
}

TEST(LoadPathPlan, givesTheWholePathWhenItOnlyChecks) {
  const Outcome found = plan(with<LoadPathGoal>([](auto& g) { g.check_only = true; }), scene());
  const auto& joint_path = reportOf(found).joint_path;
  ASSERT_GT(joint_path.size(), 10u);
  EXPECT_EQ(joint_path.front().time, Duration::zero());
  EXPECT_EQ(joint_path.back().time, *found.planned);
  EXPECT_NEAR(joint_path.back().joints[2], degToRad(90), 1e-9);
}

TEST(LoadPathPlan, tellsOfBlendsThatAreLost) {
  LoadPathGoal goal = good<LoadPathGoal>();
  for (PathPoint& point : goal.path) point.termination_type = static_cast<int>(path::Termination::Blend);
  goal.path[1].command_tolerance = 50;
  const Outcome found = plan(goal, scene());
  ASSERT_EQ(found.ending, Ending::Done) << found.error_description;
  EXPECT_THAT(reportOf(found).blends_lost, ElementsAre(0))
      << "a tolerance of 0; the last has nothing behind it";
}

TEST(LoadPathPlan, takesLongerAtALowerProjectSpeed) {
  PlanningScene slow = scene();
  slow.start->speed_override = 0.5;
  const Outcome full = plan(good<LoadPathGoal>(), scene());
  EXPECT_EQ(*plan(good<LoadPathGoal>(), slow).planned, 2 * *full.planned);
}

TEST(LoadPathPlan, blamesPointAndJointWithWhatIsInFrontOfIt) {
  LoadPathGoal goal = goalOf({pathPoint({10, 0, 90, 0, 90, 0}), pathLine(besideStart(2000, 0, 0))});
  const Outcome found = plan(goal, scene());
  EXPECT_EQ(found.error_id, 1046);
  const PathReport& report = reportOf(found);
  EXPECT_EQ(report.error_index, 1);
  ASSERT_THAT(report.points, SizeIs(2));
  EXPECT_GT(report.points[0].duration, Duration::zero());
  EXPECT_EQ(report.points[1].error_id, 1046);
  EXPECT_TRUE(report.points[1].offending_point.has_value());
  goal.path[1] = pathPoint({0, 0, 170, 0, 0, 0});
  EXPECT_EQ(plan(goal, scene()).error_id, 1033);
  EXPECT_EQ(reportOf(plan(goal, scene())).error_joint, 2);
}

int planned(std::vector<PathPoint> points) {
  return plan(goalOf(std::move(points)), scene()).error_id;
}

TEST(LoadPathPlan, findsWhatOnlyAPlanFinds) {
  const auto changed = [](auto change) {
    PathPoint point = pathLine(besideStart(0, 0, 50));
    change(point);
    return point;
  };
  EXPECT_EQ(planned({changed([](auto&) {})}), 0);
  EXPECT_EQ(planned({changed([](auto& p) {
              p.move_type = 1;
              p.ref_frame_type = static_cast<int>(path::Reference::User);
            })}),
            1035);
  EXPECT_EQ(planned({changed([](auto& p) { p.pose[0] = kNan; })}), 1037);
  EXPECT_EQ(planned({changed([](auto& p) { p.ref_frame_type = 0; })}), 1040);
  EXPECT_EQ(planned({changed([](auto& p) { p.robot_configuration = 13; })}), 1048);
  EXPECT_EQ(planned({pathPoint({10, 0, 90, 0, 90, 0, 0, 1, 0})}), 1058);
  EXPECT_EQ(planned({[] {
              PathPoint fast = pathPoint({90, 0, 90, 0, 90, 0});
              fast.speed = 200;
              fast.acceleration = fast.deceleration = 1000;
              return fast;
            }()}),
            own_error::kJointSpeed);
}

TEST(LoadPathPlan, refusesOnePvtThatIsTooLong) {
  PathPoint slow = pathPoint({130, 0, 90, 0, 90, 0});
  slow.speed = 1;
  const Outcome found = plan(goalOf({slow}), scene());
  EXPECT_EQ(found.error_id, own_error::kPvtTooLong) << found.error_description;
  EXPECT_EQ(reportOf(found).error_index, 0);
}

TEST(LoadPathPlan, needsAModelAndAStart) {
  for (const bool has_model : {false, true}) {
    PlanningScene unknown = scene();
    if (has_model) {
      unknown.start->joints.reset();
    } else {
      unknown.arm = nullptr;
    }
    const auto found = [&](LoadPathGoal goal) { return plan(goal, unknown).error_id; };
    const int missing = has_model ? own_error::kStartUnknown : own_error::kNoModel;
    LoadPathGoal checked = good<LoadPathGoal>();
    checked.check_only = true;
    EXPECT_EQ(found(checked), missing);
    PathPoint pose = pathLine(kStartPose);
    pose.interpolation = static_cast<int>(path::Interpolation::Ptp);
    EXPECT_EQ(found(goalOf({pathPoint({}), pose})), missing);
    LoadPathGoal pvt = good<LoadPathGoal>();
    pvt.execution = static_cast<int>(Execution::Pvt);
    EXPECT_EQ(found(pvt), own_error::kPvtUnavailable);
    EXPECT_EQ(found(goalOf({pathLine(kStartPose)})), 1021);
    PathPoint increment = pathLine({10, 0, 0, 0, 0, 0});
    increment.move_type = 1;
    EXPECT_EQ(found(goalOf({increment})), 1019);
    const Outcome second = plan(goalOf({pathPoint({}), pathLine(kStartPose)}), unknown);
    EXPECT_EQ(second.error_id, 1021);
    EXPECT_EQ(reportOf(second).error_index, 1);
  }
}

LoadPathGoal turnsOfJoint1() {
  LoadPathGoal goal = goalOf({pathPoint({20, 0, 90, 0, 90, 0}), pathPoint({40, 0, 90, 0, 90, 0})});
  for (PathPoint& point : goal.path) {
    point.speed = 36;
    point.acceleration = point.deceleration = 180;
  }
  return goal;
}

std::vector<std::string> linesOf(const Outcome& planned) {
  std::vector<std::string> lines;
  for (const LoadedPiecePtr& piece : reportOf(planned).loaded->pieces) {
    lines.insert(lines.end(), piece->order.lines.begin(), piece->order.lines.end());
  }
  return lines;
}

/// What 1021 promises. On the fastest arm a fifth of the rated speed is 36 deg/s of joint 1, on any other
/// less.
TEST(LoadPathPlan, sendsJointTargetsByPtpWithoutAModel) {
  PlanningScene unknown = scene();
  unknown.arm = nullptr;
  for (const Execution execution : {Execution::Auto, Execution::Script}) {
    LoadPathGoal goal = turnsOfJoint1();
    goal.execution = static_cast<int>(execution);
    const Outcome planned = plan(goal, unknown);
    ASSERT_EQ(planned.error_id, 0) << planned.error_description;
    EXPECT_THAT(linesOf(planned), ElementsAre("PTP(\"JPP\",20,0,90,0,90,0,20,200,0,false)",
                                              "PTP(\"JPP\",40,0,90,0,90,0,20,200,0,false)"));
    EXPECT_EQ(reportOf(planned).execution, Execution::Script);
    EXPECT_THAT(reportOf(planned).execution_reason, HasSubstr("no model"));
    EXPECT_EQ(reportOf(planned).preview, nullptr) << "nobody knows where its flange is";
  }
}

TEST(LoadPathPlan, namesTheModelWhereAPathWithoutOneCannotBeAScript) {
  PlanningScene unknown = scene();
  unknown.arm = nullptr;
  LoadPathGoal goal = turnsOfJoint1();
  goal.path.at(1).speed = 33.3;
  const Outcome planned = plan(goal, unknown);
  EXPECT_EQ(planned.error_id, own_error::kNotInAScript);
  EXPECT_THAT(planned.remedy, HasSubstr("~robot_model"));
  EXPECT_THAT(planned.remedy, ::testing::Not(HasSubstr("AUTO")));
}

TEST(LoadPathPlan, sendsAbsoluteJointTargetsByPtpFromAnywhere) {
  for (const bool has_model : {false, true}) {
    PlanningScene unknown = scene();
    if (!has_model) unknown.arm = nullptr;
    unknown.start->joints.reset();
    LoadPathGoal goal = turnsOfJoint1();
    const Outcome planned = plan(goal, unknown);
    ASSERT_EQ(planned.error_id, 0) << planned.error_description;
    EXPECT_EQ(reportOf(planned).loaded->pieces.size(), 2U);
    const std::string first = linesOf(planned).front();
    // As if joint 6 came the longest way: that is rated 520 deg/s on the fastest arm, and 225 on this one.
    EXPECT_EQ(first, has_model ? "PTP(\"JPP\",20,0,90,0,90,0,16,200,0,false)"
                               : "PTP(\"JPP\",20,0,90,0,90,0,6,200,0,false)");
    goal.path[0].move_type = static_cast<int>(path::MoveType::Incremental);
    EXPECT_EQ(plan(goal, unknown).error_id, has_model ? own_error::kStartUnknown : own_error::kNoModel);
  }
}

TEST(LoadPathPlan, saysWhatAScriptWouldSayOtherwise) {
  LoadPathGoal goal = good<LoadPathGoal>();
  goal.execution = static_cast<int>(Execution::Script);
  goal.check_only = true;
  goal.path[1].profile_type = static_cast<int>(path::ProfileType::ModSine);
  goal.path[1].acceleration_jerk = 100;
  const Outcome refused = plan(goal, scene());
  EXPECT_EQ(refused.error_id, own_error::kNotInAScript);
  EXPECT_THAT(refused.error_description, HasSubstr("MOD_SINE"));
  goal.allow_approximation = true;
  const Outcome allowed = plan(goal, scene());
  EXPECT_EQ(allowed.ending, Ending::Done) << allowed.error_description;
  EXPECT_EQ(reportOf(allowed).execution, Execution::Script);
  EXPECT_FALSE(reportOf(allowed).approximations.empty());
}

}  // namespace
}  // namespace cobot_command::testing
