#include <cmath>
#include <limits>

#include "block_messages.h"
#include "files/pick_and_place_file.h"
#include "no_lookups.h"
#include "source_tree.h"
#include <gmock/gmock.h>

namespace cobot_command::ros_adapter {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

cobot_command::Transformation six(double first) {
  cobot_command::Transformation message;
  message.x = first;
  message.y = first + 1;
  message.z = first + 2;
  message.rx = first + 3;
  message.ry = first + 4;
  message.rz = first + 5;
  return message;
}

geometry_msgs::PoseStamped poseIn(const std::string& frame) {
  geometry_msgs::PoseStamped message;
  message.header.frame_id = frame;
  message.pose.position.x = 0.1;
  message.pose.position.y = 0.2;
  message.pose.position.z = 0.3;
  message.pose.orientation.x = 0.5;
  message.pose.orientation.y = 0.6;
  message.pose.orientation.z = 0.7;
  message.pose.orientation.w = 0.8;
  return message;
}

/// Knows the frame "table", 1 m in front of the robot.
FramePlace theTable(const std_msgs::Header& header) {
  if (header.frame_id != "table") return {std::nullopt, "no frame '" + header.frame_id + "'"};
  arm::Pose table = arm::Pose::Identity();
  table.translation().x() = 1;
  return {table, ""};
}

const Lookups onlyTheTable{theTable, noSteps, noPoints};
const Lookups noTf{noFrame, readPickAndPlaceFile, noPoints};

template <class Message>
void fillMotion(Message& message) {
  message.command_id = 7;
  message.data_format = 3;
  message.speed = 250;
  message.accel_time = 400;
  message.blending_enable = true;
  message.blending_value = 30;
  message.disable_precise_positioning = true;
  message.exit_node = true;
  message.buffer_mode = 1;
  message.check_only = true;
}

template <class Goal>
void expectMotion(const Goal& goal) {
  EXPECT_EQ(goal.command_id, 7);
  EXPECT_EQ(goal.data_format, 3);
  EXPECT_EQ(goal.speed, 250);
  EXPECT_EQ(goal.accel_time, 400);
  EXPECT_TRUE(goal.blending_enable);
  EXPECT_EQ(goal.blending_value, 30);
  EXPECT_TRUE(goal.disable_precise_positioning);
  EXPECT_TRUE(goal.exit_node);
  EXPECT_EQ(goal.buffer_mode, 1);
  EXPECT_TRUE(goal.check_only);
}

TEST(GoalMessages, everyFieldOfMoveAbsoluteArrives) {
  cobot_command::MoveAbsoluteGoal message;
  fillMotion(message);
  message.movement_command = cobot_command::MoveAbsoluteGoal::PTP;
  message.target_position = six(10);
  message.robot_pose_enable = true;
  message.robot_pose.config1 = 1;
  message.robot_pose.config2 = 3;
  message.robot_pose.config3 = 5;
  const auto goal = toGoal(message, noTf);
  expectMotion(goal);
  EXPECT_EQ(goal.movement_command, 1);
  EXPECT_THAT(goal.target, ElementsAre(10, 11, 12, 13, 14, 15));
  EXPECT_FALSE(goal.target_pose);
  EXPECT_TRUE(goal.robot_pose_enable);
  EXPECT_THAT(goal.robot_pose, ElementsAre(1, 3, 5));
}

TEST(GoalMessages, everyFieldOfMoveRelativeArrives) {
  cobot_command::MoveRelativeGoal message;
  fillMotion(message);
  message.movement_command = cobot_command::MoveRelativeGoal::PTP;
  message.target_position = six(-3);
  const auto goal = toGoal(message, noTf);
  expectMotion(goal);
  EXPECT_EQ(goal.movement_command, 1);
  EXPECT_THAT(goal.target, ElementsAre(-3, -2, -1, 0, 1, 2));
}

TEST(GoalMessages, everyFieldOfMoveCircleArrives) {
  cobot_command::MoveCircleGoal message;
  fillMotion(message);
  message.arc_point = six(1);
  message.end_point = six(2);
  message.arc_angle = 270.5;
  const auto goal = toGoal(message, noTf);
  expectMotion(goal);
  EXPECT_THAT(goal.arc_point, ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_THAT(goal.end_point, ElementsAre(2, 3, 4, 5, 6, 7));
  EXPECT_EQ(goal.arc_angle, 270.5);
  EXPECT_FALSE(goal.arc_pose || goal.end_pose);
}

TEST(GoalMessages, everyFieldOfChangeBaseArrives) {
  cobot_command::ChangeBaseGoal message;
  message.command_id = 4;
  message.transformation = six(5);
  message.base_name = "pallet";
  message.exit_node = true;
  message.buffer_mode = 2;
  const auto goal = toGoal(message, noTf);
  EXPECT_EQ(goal.command_id, 4);
  EXPECT_THAT(goal.transformation, ElementsAre(5, 6, 7, 8, 9, 10));
  EXPECT_EQ(goal.base_name, "pallet");
  EXPECT_TRUE(goal.exit_node);
  EXPECT_EQ(goal.buffer_mode, 2);
}

TEST(GoalMessages, everyFieldOfChangeTcpArrives) {
  cobot_command::ChangeTCPGoal message;
  message.command_id = 4;
  message.tcp_offset = six(5);
  message.weight = 1.25;
  message.moment_of_inertia.ixx = 1;
  message.moment_of_inertia.iyy = 2;
  message.moment_of_inertia.izz = 3;
  message.mass_center = six(6);
  message.tcp_name = "gripper";
  message.exit_node = true;
  message.buffer_mode = 2;
  const auto goal = toGoal(message, noTf);
  EXPECT_EQ(goal.command_id, 4);
  EXPECT_THAT(goal.tcp_offset, ElementsAre(5, 6, 7, 8, 9, 10));
  EXPECT_EQ(goal.weight, 1.25);
  EXPECT_THAT(goal.moment_of_inertia, ElementsAre(1, 2, 3));
  EXPECT_THAT(goal.mass_center, ElementsAre(6, 7, 8, 9, 10, 11));
  EXPECT_EQ(goal.tcp_name, "gripper");
  EXPECT_TRUE(goal.exit_node);
  EXPECT_EQ(goal.buffer_mode, 2);
}

TEST(GoalMessages, everyFieldOfTheSmallGoalsArrives) {
  cobot_command::ProgramControlGoal control;
  control.command_id = 9;
  control.command = cobot_command::ProgramControlGoal::RESUME;
  EXPECT_EQ(toGoal(control, noTf).command_id, 9);
  EXPECT_EQ(toGoal(control, noTf).command, 1);

  cobot_command::ExitListenNodeGoal exit;
  exit.buffer_mode = 2;
  EXPECT_EQ(toGoal(exit, noTf).buffer_mode, 2);

  cobot_command::RunScriptGoal script;
  script.script = "IO[\"ControlBox\"].DO[0] = 1";
  script.await_motion = true;
  script.reply_timeout = 12.5;
  script.buffer_mode = 1;
  const auto goal = toGoal(script, noTf);
  EXPECT_EQ(goal.script, script.script);
  EXPECT_TRUE(goal.await_motion);
  EXPECT_EQ(goal.reply_timeout, 12.5);
  EXPECT_EQ(goal.buffer_mode, 1);
}

TEST(GoalMessages, aConnectGoalWithoutAStatusPortLeavesItToTheSettings) {
  cobot_command::ConnectGoal message;
  message.host = "192.168.1.2";
  message.port = 5890;
  message.timeout = 30;
  EXPECT_FALSE(toGoal(message, noTf).status_port);
  message.status_port = 5891;
  EXPECT_EQ(toGoal(message, noTf).status_port, 5891);
}

TEST(GoalMessages, aPoseInATfFrameArrivesAsItCameWithTheFrameInTheRobotBase) {
  cobot_command::MoveAbsoluteGoal message;
  message.target_pose = poseIn("table");
  const auto pose = toGoal(message, onlyTheTable).target_pose;
  ASSERT_TRUE(pose);
  EXPECT_EQ(pose->frame, "table");
  EXPECT_THAT(pose->position, ElementsAre(0.1, 0.2, 0.3));
  EXPECT_THAT(pose->quaternion, ElementsAre(0.5, 0.6, 0.7, 0.8));  // not normalised: the core checks it
  ASSERT_TRUE(pose->frame_in_robot_base);
  EXPECT_EQ(pose->frame_in_robot_base->translation().x(), 1);
  EXPECT_EQ(pose->fault, "");
}

TEST(GoalMessages, aStampAsksForWhereTheFrameWasAndNoneForWhereItIs) {
  cobot_command::MoveAbsoluteGoal message;
  message.target_pose = poseIn("table");
  EXPECT_TRUE(toGoal(message, onlyTheTable).target_pose->latest);
  message.target_pose.header.stamp = ros::Time(1, 0);
  EXPECT_FALSE(toGoal(message, onlyTheTable).target_pose->latest);
}

TEST(GoalMessages, aMoveThatSaysNothingOfItIsPrecise) {
  EXPECT_FALSE(toGoal(cobot_command::MoveAbsoluteGoal(), noTf).disable_precise_positioning);
  EXPECT_FALSE(toGoal(cobot_command::MoveRelativeGoal(), noTf).disable_precise_positioning);
  EXPECT_FALSE(toGoal(cobot_command::MoveCircleGoal(), noTf).disable_precise_positioning);
}

TEST(GoalMessages, aFrameThatIsNotKnownIsToldWithItsReason) {
  cobot_command::MoveCircleGoal message;
  message.arc_pose = poseIn("table");
  message.end_pose = poseIn("nowhere");
  const auto goal = toGoal(message, onlyTheTable);
  ASSERT_TRUE(goal.arc_pose && goal.end_pose);
  EXPECT_TRUE(goal.arc_pose->frame_in_robot_base);
  EXPECT_FALSE(goal.end_pose->frame_in_robot_base);
  EXPECT_EQ(goal.end_pose->fault, "no frame 'nowhere'");
}

TEST(GoalMessages, theBaseMayBeGivenInATfFrame) {
  cobot_command::ChangeBaseGoal message;
  message.base_pose = poseIn("table");
  const auto goal = toGoal(message, onlyTheTable);
  ASSERT_TRUE(goal.base_pose);
  EXPECT_TRUE(goal.base_pose->frame_in_robot_base);
}

TEST(GoalMessages, numbersThatAreNoneArePassedOnForTheCoreToRefuse) {
  cobot_command::MoveAbsoluteGoal message;
  message.target_position.x = std::numeric_limits<double>::quiet_NaN();
  message.target_pose = poseIn("table");
  message.target_pose.pose.position.y = std::numeric_limits<double>::infinity();
  const auto goal = toGoal(message, onlyTheTable);
  EXPECT_TRUE(std::isnan(goal.target[0]));
  EXPECT_TRUE(std::isinf(goal.target_pose->position[1]));
}

TEST(GoalMessages, aSequenceTakesOfEachStepTheGoalThatItsKindNames) {
  using Step = cobot_command::SequenceStep;
  cobot_command::CheckSequenceGoal message;
  for (const auto kind :
       {Step::CHANGE_TCP, Step::MOVE_ABSOLUTE, Step::MOVE_CIRCLE, Step::MOVE_RELATIVE, Step::CHANGE_BASE}) {
    Step& step = message.steps.emplace_back();
    step.kind = kind;
    step.move_absolute.command_id = 2;
    step.move_relative.command_id = 3;
    step.move_circle.command_id = 4;
    step.change_base.command_id = 5;
    step.change_tcp.command_id = 6;
  }
  message.start_joints = {1, 2, 3, 4, 5, 6};
  const auto goal = toGoal(message, noTf);
  EXPECT_EQ(goal.steps_fault, "");
  EXPECT_THAT(goal.start_joints, ElementsAre(1, 2, 3, 4, 5, 6));
  std::vector<int> ids;
  for (const auto& step : goal.steps) {
    ids.push_back(std::visit([](const auto& g) { return g.command_id; }, step));
  }
  EXPECT_THAT(ids, ElementsAre(6, 2, 4, 3, 5));
  EXPECT_TRUE(std::holds_alternative<blocks::ChangeTcpGoal>(goal.steps[0]));
  EXPECT_TRUE(std::holds_alternative<blocks::ChangeBaseGoal>(goal.steps[4]));
}

TEST(GoalMessages, aStepOfAKindThatThereIsNotIsNamed) {
  cobot_command::CheckSequenceGoal message;
  message.steps.resize(3);
  message.steps[1].kind = 5;
  message.steps[2].kind = 255;
  const auto goal = toGoal(message, noTf);
  EXPECT_THAT(goal.steps_fault, HasSubstr("step 2: kind is 5"));
  EXPECT_EQ(goal.faulty_step, 1);
}

TEST(GoalMessages, aSequenceOfMoreStepsThanThereMayBeIsToldByTheirNumberAndNothingIsLookedUpForThem) {
  cobot_command::CheckSequenceGoal message;
  message.steps.resize(blocks::CheckSequenceGoal::kMostSteps + 1);
  for (auto& step : message.steps) step.move_absolute.target_pose.header.frame_id = "table";
  const auto goal = toGoal(message, noTf);
  EXPECT_EQ(goal.steps.size(), blocks::CheckSequenceGoal::kMostSteps + 1);
  message.steps.pop_back();
  EXPECT_EQ(std::get<blocks::MoveAbsoluteGoal>(toGoal(message, onlyTheTable).steps.back()).target_pose->frame,
            "table");
}

TEST(GoalMessages, aCycleOfMoreStepsThanThereMayBeIsToldByTheirNumberAndNothingIsLookedUpForThem) {
  cobot_command::PickAndPlaceGoal message;
  message.steps.resize(blocks::PickAndPlaceGoal::kMostSteps + 1);
  for (auto& step : message.steps) step.move.target_pose.header.frame_id = "table";
  EXPECT_EQ(toGoal(message, noTf).steps.size(), blocks::PickAndPlaceGoal::kMostSteps + 1);
  message.steps.pop_back();
  EXPECT_EQ(toGoal(message, onlyTheTable).steps.back().move.target_pose->frame, "table");
}

TEST(GoalMessages, everyFieldOfPickAndPlaceArrives) {
  cobot_command::PickAndPlaceGoal message;
  message.cycles = 12;
  message.buffer_mode = 1;
  message.check_only = true;
  message.steps.resize(2);
  message.steps[0].move.speed = 60;
  message.steps[0].output.module = "EndModule";
  message.steps[0].output.output = 3;
  message.steps[0].output.value = true;
  message.steps[0].dwell = 1.5;
  const auto goal = toGoal(message, noTf);
  EXPECT_EQ(goal.steps_fault, "");
  EXPECT_EQ(goal.cycles, 12);
  EXPECT_EQ(goal.buffer_mode, 1);
  EXPECT_TRUE(goal.check_only);
  ASSERT_EQ(goal.steps.size(), 2U);
  EXPECT_EQ(goal.steps[0].move.speed, 60);
  ASSERT_TRUE(goal.steps[0].output);
  EXPECT_EQ(goal.steps[0].output->module, "EndModule");
  EXPECT_EQ(goal.steps[0].output->output, 3);
  EXPECT_TRUE(goal.steps[0].output->value);
  EXPECT_EQ(goal.steps[0].dwell, 1.5);
  EXPECT_FALSE(goal.steps[1].output) << "an empty module sets none";
}

TEST(GoalMessages, theStepsOfPickAndPlaceMayStandInAFile) {
  cobot_command::PickAndPlaceGoal message;
  message.steps_file = test_support::inSourceTree("config/pick_and_place.yaml");
  const auto goal = toGoal(message, noTf);
  EXPECT_EQ(goal.steps_fault, "");
  EXPECT_EQ(goal.steps.size(), 6U);
}

TEST(GoalMessages, stepsAndAFileAtOnceAreAFault) {
  cobot_command::PickAndPlaceGoal message;
  message.steps_file = test_support::inSourceTree("config/pick_and_place.yaml");
  message.steps.resize(1);
  EXPECT_THAT(toGoal(message, noTf).steps_fault, HasSubstr("give one"));
}

TEST(GoalMessages, aFileThatIsStillReadIsAFaultOfTheSteps) {
  cobot_command::PickAndPlaceGoal message;
  message.steps_file = "/slow.yaml";
  const Lookups slow{noFrame, [](const std::string&) -> std::optional<StepsAnswer> { return std::nullopt; },
                     [](const std::string&) -> std::optional<PointsAnswer> { return std::nullopt; }};
  EXPECT_THAT(toGoal(message, slow).steps_fault,
              HasSubstr("/slow.yaml: the file was not read within the time limit"));
}

TEST(GoalMessages, aFileThatCannotBeReadIsAFaultOfTheSteps) {
  cobot_command::PickAndPlaceGoal message;
  message.steps_file = "/no/such/file.yaml";
  EXPECT_THAT(toGoal(message, noTf).steps_fault, HasSubstr("/no/such/file.yaml"));
}

}  // namespace
}  // namespace cobot_command::ros_adapter
