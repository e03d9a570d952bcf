#include <chrono>

#include "block_messages.h"
#include <gmock/gmock.h>

namespace cobot_command::ros_adapter {
namespace {

using std::chrono::milliseconds;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

const JointNames kNames = jointNames("left_");
const ClockPair kClocks{ros::Time(1000), Instant(std::chrono::seconds(50))};
const FillSite kSite{kNames, kClocks};

blocks::Outcome anError() {
  blocks::Outcome outcome;
  outcome.ending = blocks::Ending::Aborted;
  outcome.error_id = 0x110;
  outcome.error_description = "it failed";
  outcome.remedy = "try again";
  outcome.command_id_ack = 5;
  return outcome;
}

template <class Result>
void expectTheError(const Result& message) {
  EXPECT_EQ(message.error_id, 0x110);
  EXPECT_EQ(message.error_description, "it failed");
  EXPECT_EQ(message.remedy, "try again");
}

TEST(OutcomeMessages, everyResultTellsTheErrorAndItsRemedy) {
  cobot_command::StopResult stop;
  fill(stop, anError(), kSite);
  expectTheError(stop);
  cobot_command::ChangeBaseResult change;
  fill(change, anError(), kSite);
  expectTheError(change);
  EXPECT_EQ(change.command_id_ack, 5);
}

TEST(OutcomeMessages, aMoveTellsItsTimesAndWhereTheRobotStands) {
  blocks::Outcome outcome;
  outcome.command_id_ack = 12;
  outcome.planned = milliseconds(1500);
  outcome.actual = milliseconds(1750);
  outcome.final_joints_deg = {1, 2, 3, 4, 5, 6};
  outcome.final_pose_mm_deg = {400, 0, 300, 180, 0, 90};
  cobot_command::MoveAbsoluteResult message;
  fill(message, outcome, kSite);
  EXPECT_EQ(message.error_id, 0);
  EXPECT_EQ(message.command_id_ack, 12);
  EXPECT_EQ(message.planned_duration, ros::Duration(1.5));
  EXPECT_EQ(message.actual_duration, ros::Duration(1.75));
  EXPECT_THAT(message.final_joints, ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_THAT(toSix(message.final_pose), ElementsAre(400, 0, 300, 180, 0, 90));
  EXPECT_THAT(message.joint_path.joint_names, IsEmpty());
  EXPECT_THAT(message.joint_path.points, IsEmpty());
}

TEST(OutcomeMessages, whatIsUnknownStaysEmpty) {
  cobot_command::MoveCircleResult message;
  fill(message, blocks::Outcome{}, kSite);
  EXPECT_TRUE(message.planned_duration.isZero());
  EXPECT_TRUE(message.actual_duration.isZero());
  EXPECT_THAT(message.final_joints, IsEmpty());
  EXPECT_THAT(toSix(message.final_pose), ElementsAre(0, 0, 0, 0, 0, 0));
}

TEST(OutcomeMessages, aCheckedMotionComesAsATrajectoryOfTheRobotsOwnJoints) {
  blocks::Outcome outcome;
  outcome.detail =
      blocks::Detail(blocks::CheckedMotion{{{milliseconds(0), {0.1, 0, 0, 0, 0, 0}, {}},
                                            {milliseconds(20), {0.2, 0, 0, 0, 0, 0.6}, {5, 0, 0, 0, 0, 0}}}});
  cobot_command::MoveAbsoluteResult message;
  fill(message, outcome, kSite);
  EXPECT_THAT(message.joint_path.joint_names,
              ElementsAre("left_shoulder_1_joint", "left_shoulder_2_joint", "left_elbow_joint",
                          "left_wrist_1_joint", "left_wrist_2_joint", "left_wrist_3_joint"));
  ASSERT_EQ(message.joint_path.points.size(), 2U);
  const auto& last = message.joint_path.points[1];
  EXPECT_THAT(last.positions, ElementsAre(0.2, 0, 0, 0, 0, 0.6));
  EXPECT_THAT(last.velocities, ElementsAre(5, 0, 0, 0, 0, 0));
  EXPECT_EQ(last.time_from_start, ros::Duration(0.02));
}

TEST(OutcomeMessages, aSequenceTellsWhatWasFoundOfEachStep) {
  blocks::Outcome outcome = anError();
  blocks::SequenceReport report;
  report.failed_step = 1;
  report.steps.resize(2);
  report.steps[0].duration = milliseconds(900);
  report.steps[1].start = milliseconds(800);
  report.steps[1].error_id = 0x203;
  report.steps[1].error_description = "joint 3";
  report.steps[1].offending_point = {{1, 2, 3, 4, 5, 6}};
  outcome.detail = blocks::Detail(report);
  cobot_command::CheckSequenceResult message;
  fill(message, outcome, kSite);
  EXPECT_EQ(message.failed_step, 1);
  ASSERT_EQ(message.steps.size(), 2U);
  EXPECT_EQ(message.steps[0].duration, ros::Duration(0.9));
  EXPECT_FALSE(message.steps[0].offending_point_valid);
  EXPECT_EQ(message.steps[1].start, ros::Duration(0.8));
  EXPECT_EQ(message.steps[1].error_id, 0x203);
  EXPECT_EQ(message.steps[1].error_description, "joint 3");
  EXPECT_TRUE(message.steps[1].offending_point_valid);
  EXPECT_THAT(toSix(message.steps[1].offending_point), ElementsAre(1, 2, 3, 4, 5, 6));
}

TEST(OutcomeMessages, aPickAndPlaceTellsTheErrorOfTheStepThatFailed) {
  blocks::Outcome outcome = anError();
  blocks::CycleReport report;
  report.failed_step = 1;
  report.cycles_done = 4;
  report.steps.resize(2);
  report.steps[1].error_id = 0x201;
  report.steps[1].error_description = "too far";
  outcome.detail = blocks::Detail(report);
  cobot_command::PickAndPlaceResult message;
  fill(message, outcome, kSite);
  expectTheError(message);
  EXPECT_EQ(message.failed_step, 1);
  EXPECT_EQ(message.step_error_id, 0x201);
  EXPECT_EQ(message.step_error_description, "too far");
  EXPECT_EQ(message.cycles_done, 4);
}

TEST(OutcomeMessages, aFailedStepWithoutAReportIsStillNumbered) {
  blocks::Outcome outcome = anError();
  blocks::CycleReport report;
  report.failed_step = 3;
  outcome.detail = blocks::Detail(report);
  cobot_command::PickAndPlaceResult message;
  fill(message, outcome, kSite);
  EXPECT_EQ(message.failed_step, 3);
  EXPECT_EQ(message.step_error_id, 0);
}

TEST(OutcomeMessages, noStepFailedIsMinusOne) {
  cobot_command::PickAndPlaceResult message;
  fill(message, blocks::Outcome{}, kSite);
  EXPECT_EQ(message.failed_step, -1);
  EXPECT_EQ(message.cycles_done, 0);
  EXPECT_THAT(message.steps, IsEmpty());
  cobot_command::CheckSequenceResult check;
  fill(check, blocks::Outcome{}, kSite);
  EXPECT_EQ(check.failed_step, -1);
  EXPECT_THAT(check.steps, IsEmpty());
}

TEST(OutcomeMessages, aPathTellsWhichPointIsToBlame) {
  blocks::Outcome outcome = anError();
  blocks::PathReport report;
  report.error_index = 3;
  report.error_joint = 4;
  report.method_id = 5;
  report.execution = blocks::Execution::Pvt;
  report.execution_reason = "it was requested";
  report.approximations = {"point 1: profile"};
  report.blends_lost = {6, 7};
  report.max_joint_deviation = 0.25;
  report.max_path_deviation = 0.5;
  report.lag = milliseconds(50);
  report.points.resize(2);
  report.points[1].error_id = 1046;
  report.joint_path.resize(3);
  outcome.detail = blocks::Detail(report);
  outcome.planned = milliseconds(2000);
  outcome.actual = milliseconds(3000);
  outcome.final_joints_deg = {1, 2, 3, 4, 5, 6};
  cobot_command::LoadPathResult message;
  fill(message, outcome, kSite);
  expectTheError(message);
  EXPECT_EQ(message.error_index, 3);
  EXPECT_EQ(message.error_joint, 4);
  EXPECT_EQ(message.method_id, 5);
  EXPECT_EQ(message.execution, cobot_command::LoadPathGoal::PVT);
  EXPECT_EQ(message.execution_reason, "it was requested");
  EXPECT_THAT(message.approximations, ElementsAre("point 1: profile"));
  EXPECT_THAT(message.blends_lost, ElementsAre(6, 7));
  EXPECT_EQ(message.max_joint_deviation, 0.25);
  EXPECT_EQ(message.max_path_deviation, 0.5);
  EXPECT_EQ(message.lag.toSec(), 0.05);
  ASSERT_EQ(message.points.size(), 2U);
  EXPECT_EQ(message.points[1].error_id, 1046);
  EXPECT_EQ(message.joint_path.points.size(), 3U);
  EXPECT_EQ(message.planned_duration.toSec(), 2);
  EXPECT_EQ(message.actual_duration.toSec(), 3);
  EXPECT_TRUE(message.final_joints_valid);
  EXPECT_EQ(message.final_joints[5], 6);
  EXPECT_FALSE(message.final_pose_valid);
}

TEST(OutcomeMessages, aPathWithoutAReportBlamesNoPoint) {
  cobot_command::LoadPathResult message;
  fill(message, blocks::Outcome{}, kSite);
  EXPECT_EQ(message.error_index, -1);
  EXPECT_EQ(message.error_joint, -1);
  EXPECT_EQ(message.execution, cobot_command::LoadPathGoal::AUTO);
  EXPECT_FALSE(message.final_joints_valid);
}

TEST(FeedbackMessages, aPathTellsWhereItsPointsAre) {
  blocks::Progress progress;
  progress.phase = blocks::Phase::Active;
  progress.fraction = 0.5;
  progress.detail =
      blocks::Detail(blocks::PathPlace{true, true, 2, 3, 4, 5, 6, 7, false, blocks::ProgressSource::Stream});
  cobot_command::LoadPathFeedback message;
  fill(message, progress, kSite);
  EXPECT_EQ(message.phase, cobot_command::LoadPathFeedback::ACTIVE);
  EXPECT_TRUE(message.loaded && message.active);
  EXPECT_EQ(message.method_id, 2);
  EXPECT_EQ(message.active_path_point, 3);
  EXPECT_EQ(message.active_move_id, 4);
  EXPECT_EQ(message.pending_path_points, 5);
  EXPECT_EQ(message.queued_path_points, 6);
  EXPECT_EQ(message.done_path_points, 7);
  EXPECT_EQ(message.progress_source, cobot_command::LoadPathFeedback::STREAM);
  EXPECT_EQ(message.progress, 0.5);
  fill(message, blocks::Progress{}, kSite);
  EXPECT_EQ(message.active_path_point, -1);
  EXPECT_EQ(message.progress_source, cobot_command::LoadPathFeedback::PLAN);
}

TEST(FeedbackMessages, aMoveTellsItsPhasePlaceAndProgress) {
  blocks::Progress progress;
  progress.phase = blocks::Phase::Held;
  progress.command_id_ack = 3;
  progress.place_in_queue = 2;
  progress.fraction = 0.25;
  progress.planned = milliseconds(4000);
  progress.remaining = milliseconds(3000);
  progress.text = "a safeguard stops the robot";
  cobot_command::MoveAbsoluteFeedback message;
  fill(message, progress, kSite);
  EXPECT_EQ(message.phase, cobot_command::MoveAbsoluteFeedback::HELD);
  EXPECT_EQ(message.command_id_ack, 3);
  EXPECT_EQ(message.place_in_queue, 2);
  EXPECT_EQ(message.progress, 0.25);
  EXPECT_EQ(message.planned_duration, ros::Duration(4));
  EXPECT_EQ(message.remaining, ros::Duration(3));
  EXPECT_EQ(message.text, "a safeguard stops the robot");
}

TEST(FeedbackMessages, aPickAndPlaceTellsItsStepAndCycle) {
  blocks::Progress progress;
  progress.phase = blocks::Phase::Dwelling;
  progress.detail = blocks::Detail(blocks::CyclePlace{2, 7});
  cobot_command::PickAndPlaceFeedback message;
  fill(message, progress, kSite);
  EXPECT_EQ(message.phase, cobot_command::PickAndPlaceFeedback::DWELLING);
  EXPECT_EQ(message.step, 2);
  EXPECT_EQ(message.cycle, 7);
}

TEST(FeedbackMessages, aPickAndPlaceThatWaitsIsAtNoStepOfNoCycle) {
  cobot_command::PickAndPlaceFeedback message;
  fill(message, blocks::Progress{}, kSite);
  EXPECT_EQ(message.step, -1);
  EXPECT_EQ(message.cycle, 0);
}

TEST(FeedbackMessages, thePhasesHaveTheSameNumbersInEveryAction) {
  using Move = cobot_command::MoveAbsoluteFeedback;
  EXPECT_EQ(toPhase(blocks::Phase::Sent), Move::SENT);
  EXPECT_EQ(toPhase(blocks::Phase::Queued), Move::QUEUED);
  EXPECT_EQ(toPhase(blocks::Phase::Active), Move::ACTIVE);
  EXPECT_EQ(toPhase(blocks::Phase::Stopping), Move::STOPPING);
  EXPECT_EQ(toPhase(blocks::Phase::Stopping), cobot_command::StopFeedback::STOPPING);
}

TEST(FeedbackMessages, connectHasPhasesOfItsOwn) {
  using Message = cobot_command::ConnectFeedback;
  blocks::Progress progress;
  Message message;
  progress.phase = blocks::Phase::Probing;
  fill(message, progress, kSite);
  EXPECT_EQ(message.phase, Message::PROBING);
  EXPECT_FALSE(message.connected);
  progress.phase = blocks::Phase::Connected;
  fill(message, progress, kSite);
  EXPECT_EQ(message.phase, Message::CONNECTED);
  EXPECT_TRUE(message.connected);
}

TEST(OutcomeMessages, theTimesOfALinkAreRosTimesAndZeroWhereThereAreNone) {
  blocks::Outcome outcome;
  outcome.detail = blocks::Detail(blocks::LinkTimes{Instant(std::chrono::seconds(40)), std::nullopt});
  cobot_command::ConnectResult result;
  fill(result, outcome, kSite);
  EXPECT_EQ(result.last_connected, ros::Time(990));
  EXPECT_TRUE(result.last_lost.isZero());
  blocks::Progress progress;
  progress.detail = blocks::Detail(blocks::LinkTimes{std::nullopt, Instant(std::chrono::seconds(45))});
  cobot_command::ConnectFeedback feedback;
  fill(feedback, progress, kSite);
  EXPECT_EQ(feedback.last_lost, ros::Time(995));
}

}  // namespace
}  // namespace cobot_command::ros_adapter
