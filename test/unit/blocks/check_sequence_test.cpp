// A list of commands is planned end to end, and the first step that fails is named.

#include "cobot_command/blocks/check_sequence.h"

#include <cmath>

#include "block_goals.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr SixValues kHome{0, 0, 90, 0, 90, 0};
constexpr SixValues kAside{60, 0, 90, 0, 90, 0};

arm::ArmModel model() {
  return *arm::ArmModel::named("tm5-900");
}

using Start = planning::ScriptPlanner::Start;

Outcome checkSequence(const CheckSequenceGoal& goal, const std::optional<arm::ArmModel>& arm,
                      const std::optional<Start>& start) {
  PlanningScene scene;
  scene.arm = arm ? &*arm : nullptr;
  scene.start = start;
  return plan(goal, scene);
}

Start at(const SixValues& joints_deg) {
  Start start;
  start.joints = arm::toJointVector(joints_deg);
  return start;
}

/// Where the flange is at these joints.
SixValues poseAt(const SixValues& joints_deg) {
  return arm::toControllerPose(arm::forwardKinematics(model(), arm::toJointVector(joints_deg)));
}

MoveAbsoluteGoal toJoints(const SixValues& joints_deg) {
  return with<MoveAbsoluteGoal>([&](auto& g) {
    g.data_format = static_cast<int>(AbsoluteFormat::Jpp);
    g.target = joints_deg;
    g.speed = 50;
  });
}

MoveAbsoluteGoal lineTo(const SixValues& pose) {
  return with<MoveAbsoluteGoal>([&](auto& g) {
    g.movement_command = static_cast<int>(Movement::Line);
    g.data_format = static_cast<int>(AbsoluteFormat::Cap);
    g.target = pose;
    g.speed = 100;
  });
}

MoveRelativeGoal down(double mm) {
  return with<MoveRelativeGoal>([&](auto& g) {
    g.movement_command = static_cast<int>(Movement::Line);
    g.data_format = static_cast<int>(RelativeFormat::Cap);
    g.target = {0, 0, -mm, 0, 0, 0};
    g.speed = 100;
  });
}

ChangeBaseGoal baseNamed(const std::string& name) {
  return with<ChangeBaseGoal>([&](auto& g) { g.base_name = name; });
}

CheckSequenceGoal sequence(std::vector<SequenceStep> steps) {
  CheckSequenceGoal goal;
  goal.steps = std::move(steps);
  return goal;
}

Outcome checked(const CheckSequenceGoal& goal) {
  return checkSequence(goal, model(), at(kHome));
}

const SequenceReport& reportOf(const Outcome& outcome) {
  return outcome.detail.as<SequenceReport>();
}

void expectFailure(const Outcome& outcome, int step, int step_error) {
  EXPECT_EQ(outcome.ending, Ending::Rejected);
  EXPECT_EQ(outcome.error_id, own_error::kStepRefused) << outcome.error_description;
  EXPECT_EQ(reportOf(outcome).failed_step, step);
  ASSERT_EQ(reportOf(outcome).steps.size(), static_cast<std::size_t>(step) + 1)
      << "what is behind is not looked at";
  EXPECT_EQ(reportOf(outcome).steps.back().error_id, step_error) << outcome.error_description;
  for (int i = 0; i < step; ++i) EXPECT_EQ(reportOf(outcome).steps[static_cast<std::size_t>(i)].error_id, 0);
  EXPECT_FALSE(outcome.planned);
}

TEST(CheckSequence, plansEachStepFromTheEndOfTheOneBefore) {
  const Outcome outcome = checked(sequence({toJoints(kAside), down(50), toJoints(kHome)}));
  EXPECT_EQ(outcome.ending, Ending::Done) << outcome.error_description;
  EXPECT_EQ(outcome.error_id, 0);
  EXPECT_EQ(reportOf(outcome).failed_step, -1);
  ASSERT_EQ(reportOf(outcome).steps.size(), 3u);
  Duration start{};
  for (const StepReport& report : reportOf(outcome).steps) {
    EXPECT_EQ(report.start, start);
    EXPECT_GT(report.duration, Duration::zero());
    start += report.duration;
  }
  EXPECT_EQ(outcome.planned, start);
}

TEST(CheckSequence, givesAJointPathThatHangsTogether) {
  const Outcome outcome = checked(sequence({toJoints(kAside), down(50), toJoints(kHome)}));
  ASSERT_EQ(reportOf(outcome).steps.size(), 3u);
  arm::JointVector at = arm::toJointVector(kHome);
  for (const StepReport& report : reportOf(outcome).steps) {
    ASSERT_GE(report.joint_path.size(), 2u);
    EXPECT_LE(report.joint_path.size(), 100u);
    EXPECT_EQ(report.joint_path.front().time, Duration::zero());
    EXPECT_EQ(report.joint_path.back().time, report.duration);
    for (std::size_t j = 0; j < 6; ++j) {
      EXPECT_NEAR(report.joint_path.front().joints[j], at[static_cast<Eigen::Index>(j)], 1e-9);
      EXPECT_EQ(report.joint_path.back().velocities[j], 0);
      at[static_cast<Eigen::Index>(j)] = report.joint_path.back().joints[j];
    }
    EXPECT_FALSE(report.offending_point);
  }
  EXPECT_LT((at - arm::toJointVector(kHome)).norm(), 1e-9);
}

TEST(CheckSequence, beginsAtTheStartJointsWhereTheyAreGiven) {
  CheckSequenceGoal goal = sequence({toJoints(kAside)});
  goal.start_joints.assign(kAside.begin(), kAside.end());
  const Outcome there = checkSequence(goal, model(), std::nullopt);
  EXPECT_EQ(there.ending, Ending::Done) << there.error_description;
  EXPECT_EQ(reportOf(there).steps[0].duration, Duration::zero());
  EXPECT_EQ(reportOf(checkSequence(goal, model(), at(kHome))).steps[0].duration, Duration::zero())
      << "in place of where the robot is";
}

TEST(CheckSequence, countsTheProjectSpeed) {
  Start slow = at(kHome);
  slow.speed_override = 0.5;
  const Outcome outcome = checkSequence(sequence({toJoints(kAside)}), model(), slow);
  EXPECT_GT(reportOf(outcome).steps[0].duration,
            reportOf(checked(sequence({toJoints(kAside)}))).steps[0].duration);
}

TEST(CheckSequence, takesABaseAndATcpFromTheStepsBefore) {
  SixValues pose = poseAt(kAside);
  const auto base = with<ChangeBaseGoal>([](auto& g) { g.transformation = {100, 50, -30, 0, 0, 0}; });
  const auto tcp = with<ChangeTcpGoal>([](auto& g) { g.tcp_offset = {0, 0, 120, 0, 0, 0}; });
  pose[0] -= 100;
  pose[1] -= 50;
  pose[2] += 30 - 120;
  const auto move = with<MoveAbsoluteGoal>([&](auto& g) { g.target = pose; });
  const Outcome outcome = checked(sequence({base, tcp, move}));
  ASSERT_EQ(outcome.ending, Ending::Done) << outcome.error_description;
  EXPECT_EQ(reportOf(outcome).steps[0].duration, Duration::zero());
  EXPECT_TRUE(reportOf(outcome).steps[1].joint_path.empty());
  const auto& end = reportOf(outcome).steps[2].joint_path.back().joints;
  for (std::size_t j = 0; j < 6; ++j) {
    EXPECT_NEAR(end[j], arm::toJointVector(kAside)[static_cast<Eigen::Index>(j)], 1e-6) << j;
  }
}

TEST(CheckSequence, seesAPoseInATfFrameFromTheBaseOfItsStep) {
  FramedPose pose;
  pose.frame = "table";
  pose.frame_in_robot_base = arm::toPose(poseAt(kAside));
  pose.quaternion = {0, 0, 0, 1};
  auto move = good<MoveAbsoluteGoal>();
  move.target_pose = pose;
  const auto base = with<ChangeBaseGoal>([](auto& g) { g.transformation = {100, 50, -30, 0, 0, 40}; });
  const Outcome outcome = checked(sequence({base, move}));
  ASSERT_EQ(outcome.ending, Ending::Done) << outcome.error_description;
  EXPECT_NEAR(reportOf(outcome).steps[1].joint_path.back().joints[0], arm::toJointVector(kAside)[0], 1e-6);
}

TEST(CheckSequence, namesTheStepWithABadParameter) {
  auto bad = down(10);
  bad.accel_time = 3;
  bad.command_id = 1;
  const Outcome outcome = checked(sequence({toJoints(kAside), bad, toJoints(kHome)}));
  expectFailure(outcome, 1, motion_error::kAccelTimeRange);
  EXPECT_THAT(outcome.error_description,
              StartsWith("Step refused: step 2 of 3: 16#27 Acceleration Time range is: 150~9999 ms"));
  EXPECT_THAT(outcome.error_description, HasSubstr("also 16#28"));
  EXPECT_EQ(outcome.remedy, "Set parameter in acceptable range");
  EXPECT_FALSE(reportOf(outcome).steps[1].offending_point);
}

TEST(CheckSequence, countsTheFirstStepOnceWhenItComesRound) {
  CheckSequenceGoal goal = sequence({lineTo(poseAt(kAside)), toJoints(kHome)});
  goal.start_joints = {30, 0, 90, 0, 90, 0};
  const Outcome once = checked(goal);
  goal.comes_round = true;
  const Outcome round = checked(goal);
  ASSERT_EQ(round.ending, Ending::Done) << round.error_description;
  EXPECT_EQ(reportOf(round).steps.size(), 2u);
  EXPECT_GT(*round.planned, *once.planned) << "its way from the end of the last step is planned, too";
}

TEST(CheckSequence, namesTheFirstStepWhenItCannotBeMadeFromTheEndOfTheLast) {
  CheckSequenceGoal goal = sequence({lineTo(poseAt(kAside)), toJoints({-150, 0, 90, 0, 90, 0})});
  goal.start_joints = {30, 0, 90, 0, 90, 0};
  ASSERT_EQ(checked(goal).ending, Ending::Done);
  goal.comes_round = true;
  const Outcome round = checked(goal);
  EXPECT_EQ(round.ending, Ending::Rejected);
  EXPECT_EQ(reportOf(round).failed_step, 0);
  EXPECT_THAT(round.error_description, HasSubstr("step 1 of 2"));
  EXPECT_THAT(round.error_description, HasSubstr("when it is repeated after the last step"));
  ASSERT_EQ(reportOf(round).steps.size(), 2u);
  EXPECT_NE(reportOf(round).steps[0].error_id, 0);
  EXPECT_EQ(reportOf(round).steps[1].error_id, 0);
}

TEST(CheckSequence, namesTheOffendingPointOfAPathThatCannotBeMade) {
  const SixValues far{3000, 0, 500, 180, 0, 90};
  const Outcome outcome =
      checked(sequence({toJoints(kAside), with<MoveAbsoluteGoal>([&](auto& g) { g.target = far; })}));
  expectFailure(outcome, 1, own_error::kUnreachable);
  ASSERT_TRUE(reportOf(outcome).steps[1].offending_point);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR((*reportOf(outcome).steps[1].offending_point)[i], far[i], 1e-6);
  }
  EXPECT_FALSE(reportOf(outcome).steps[0].joint_path.empty());
  EXPECT_TRUE(reportOf(outcome).steps[1].joint_path.empty());
}

TEST(CheckSequence, findsEachReasonNotToMakeAMotion) {
  const auto failing = [](const SequenceStep& step, const SixValues& start, const char* name = "tm5-900") {
    const Outcome outcome = checkSequence(sequence({step}), *arm::ArmModel::named(name), at(start));
    EXPECT_EQ(reportOf(outcome).failed_step, 0);
    EXPECT_EQ(outcome.error_id, own_error::kStepRefused);
    return reportOf(outcome).steps.at(0).error_id;
  };
  EXPECT_EQ(failing(toJoints({0, 0, 170, 0, 90, 0}), kHome), own_error::kJointLimit);
  EXPECT_EQ(failing(down(2000), kHome), own_error::kUnreachable);
  EXPECT_EQ(failing(lineTo({100, -200, 800, 0, 0, 90}), {0, 0, 0, 0, 0, 0}), own_error::kSingular);
  EXPECT_EQ(failing(with<MoveCircleGoal>([](auto& g) { g.end_point = g.arc_point; }), kHome),
            own_error::kNotPlannable);
  auto posed = with<MoveAbsoluteGoal>([](auto& g) {
    g.target = {907.1, -122.3, 145, 180, 0, 90};
    g.robot_pose_enable = true;
    g.robot_pose = {0, 2, 5};
  });
  EXPECT_EQ(failing(posed, {10, 15, 80, -5, 85, 20}), own_error::kPoseBits);
  auto fast = lineTo({255.9, 143.7, 648.7, 180, 0, 90});
  fast.speed = 1300;
  EXPECT_EQ(failing(fast, {0, -40, 130, 0, 90, 0}, "tm12"), own_error::kJointSpeed);
}

TEST(CheckSequence, refusesMotionsInAFrameThatTheProjectKnowsByNameOnly) {
  expectFailure(checked(sequence({baseNamed("Table"), down(10)})), 1, own_error::kBaseUnknown);
  expectFailure(checked(sequence({baseNamed("Table"), good<MoveAbsoluteGoal>()})), 1,
                own_error::kBaseUnknown);
  expectFailure(checked(sequence({baseNamed("Table"), good<MoveCircleGoal>()})), 1, own_error::kBaseUnknown);
  auto posed = good<MoveAbsoluteGoal>();
  posed.target_pose = framedPose();
  expectFailure(checked(sequence({baseNamed("Table"), posed})), 1, own_error::kBaseUnknown);
  const auto tcp = with<ChangeTcpGoal>([](auto& g) { g.tcp_name = "Gripper"; });
  expectFailure(checked(sequence({tcp, down(10)})), 1, own_error::kBaseUnknown);
}

TEST(CheckSequence, plansInJointsWhateverTheFrames) {
  const Outcome outcome =
      checked(sequence({baseNamed("Table"), toJoints(kAside), baseNamed("RobotBase"), down(10)}));
  EXPECT_EQ(outcome.ending, Ending::Done) << outcome.error_description;
}

/// A line down, blended with this radius.
MoveRelativeGoal rounded(double way, double radius) {
  auto goal = down(way);
  goal.data_format = static_cast<int>(RelativeFormat::Car);
  goal.blending_enable = true;
  goal.blending_value = radius;
  return goal;
}

TEST(CheckSequence, startsABlendedMotionBeforeTheEndOfTheOneBefore) {
  const auto aside = with<MoveRelativeGoal>([](auto& g) {
    g = down(0);
    g.target = {0, 50, 0, 0, 0, 0};
  });
  const Outcome outcome = checked(sequence({rounded(50, 20), aside}));
  ASSERT_EQ(outcome.ending, Ending::Done) << outcome.error_description;
  const Duration corner = reportOf(outcome).steps[1].start;
  EXPECT_LT(corner, reportOf(outcome).steps[0].duration);
  EXPECT_EQ(outcome.planned, corner + reportOf(outcome).steps[1].duration);
  const JointPathPoint& last = reportOf(outcome).steps[0].joint_path.back();
  const JointPathPoint& first = reportOf(outcome).steps[1].joint_path.front();
  EXPECT_EQ(last.time, corner) << "the path goes on in the next step";
  for (std::size_t j = 0; j < 6; ++j) {
    EXPECT_NEAR(last.joints[j], first.joints[j], 1e-9);
    EXPECT_NEAR(last.velocities[j], first.velocities[j], 1e-9);
  }
}

TEST(CheckSequence, refusesABlendThatDoesNotFitItsOwnWay) {
  const Outcome outcome = checked(sequence({toJoints(kAside), rounded(50, 26), down(100)}));
  expectFailure(outcome, 1, own_error::kBlendingTooLarge);
  EXPECT_THAT(outcome.error_description, HasSubstr("the radius is 26.0 mm, at most 25.0 mm fit"));
}

TEST(CheckSequence, refusesABlendThatDoesNotFitTheWayBehindItInTheNameOfItsOwner) {
  const auto base = with<ChangeBaseGoal>([](auto& g) { g.transformation = {0, 0, 0, 0, 0, 0}; });
  const Outcome outcome = checked(sequence({rounded(100, 30), base, down(50), toJoints(kAside)}));
  expectFailure(outcome, 0, own_error::kBlendingTooLarge);
  ASSERT_TRUE(reportOf(outcome).steps[0].offending_point);
  SixValues corner = poseAt(kHome);
  corner[2] -= 100;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR((*reportOf(outcome).steps[0].offending_point)[i], corner[i], 1e-6);
  }
}

TEST(CheckSequence, needsAStart) {
  CheckSequenceGoal goal = sequence({toJoints(kAside)});
  EXPECT_EQ(checkSequence(goal, model(), std::nullopt).error_id, own_error::kStartUnknown);
  EXPECT_EQ(checkSequence(goal, model(), Start{}).error_id, own_error::kStartUnknown);
  for (const std::vector<double>& bad : {std::vector<double>(5, 0.0),
                                         std::vector<double>(7, 0.0),
                                         {0, 0, kNan, 0, 90, 0},
                                         {kInf, 0, 0, 0, 90, 0}}) {
    goal.start_joints = bad;
    const Outcome outcome = checkSequence(goal, model(), at(kHome));
    EXPECT_EQ(outcome.error_id, own_error::kStartUnknown);
    EXPECT_EQ(outcome.ending, Ending::Rejected);
    EXPECT_TRUE(reportOf(outcome).steps.empty());
    EXPECT_EQ(reportOf(outcome).failed_step, -1);
  }
}

TEST(CheckSequence, doesNotQuoteAllStartJointsThatAreTooMany) {
  CheckSequenceGoal goal = sequence({toJoints(kAside)});
  goal.start_joints.assign(1000000, 0.1);
  const Outcome outcome = checkSequence(goal, model(), at(kHome));
  EXPECT_EQ(outcome.error_id, own_error::kStartUnknown);
  EXPECT_NE(outcome.error_description.find("1000000 start_joints"), std::string::npos);
  EXPECT_LT(outcome.error_description.size(), 200u);
}

TEST(CheckSequence, needsAModel) {
  EXPECT_EQ(checkSequence(sequence({toJoints(kAside)}), std::nullopt, at(kHome)).error_id,
            own_error::kNoModel);
}

TEST(CheckSequence, notesAToolThatIsTooHeavyForTheArm) {
  const auto withTool = [](double weight) {
    const auto tool = with<ChangeTcpGoal>([&](auto& g) { g.weight = weight; });
    return checked(sequence({tool, toJoints(kAside)}));
  };
  const Outcome heavy = withTool(14);
  EXPECT_EQ(heavy.ending, Ending::Done);
  EXPECT_EQ(reportOf(heavy).steps[0].error_id, 0);
  EXPECT_THAT(reportOf(heavy).steps[0].error_description, HasSubstr("14 kg, the payload of tm5-900 is 4 kg"));
  EXPECT_THAT(heavy.error_description, HasSubstr("step 1: the tool has 14 kg"));
  EXPECT_EQ(withTool(4).error_description, "");
}

TEST(CheckSequence, blamesAStepThatCannotBeRead) {
  CheckSequenceGoal goal = sequence({toJoints(kAside)});
  goal.steps_fault = "step 2: kind is 9";
  goal.faulty_step = 1;
  const Outcome outcome = checkSequence(goal, model(), at(kHome));
  EXPECT_EQ(outcome.error_id, own_error::kStepsUnreadable);
  EXPECT_EQ(reportOf(outcome).failed_step, 1);
}

TEST(CheckSequence, takesOneTo200Steps) {
  const auto steps = [](std::size_t count) {
    return checked(sequence(std::vector<SequenceStep>(count, toJoints(kAside)))).error_id;
  };
  EXPECT_EQ(steps(0), own_error::kStepCount);
  EXPECT_EQ(steps(1), 0);
  EXPECT_EQ(steps(200), 0);
  EXPECT_EQ(steps(201), own_error::kStepCount);
  EXPECT_THAT(checked(sequence({})).error_description, HasSubstr("0 steps; allowed: 1 to 200"));
}

TEST(CheckSequence, namesAllThatKeepsItFromBeginning) {
  const Outcome outcome = checkSequence(CheckSequenceGoal{}, std::nullopt, std::nullopt);
  EXPECT_EQ(outcome.error_id, own_error::kStartUnknown);
  EXPECT_THAT(outcome.error_description, HasSubstr("also 16#209"));
  EXPECT_THAT(outcome.error_description, HasSubstr("also 16#250"));
}

}  // namespace
}  // namespace cobot_command::testing
