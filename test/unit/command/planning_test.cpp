// Pre-flight: a motion is planned before it is sent, from where it will start.

#include "block_goals.h"
#include "core_rig.h"
#include "motion_goals.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/motion/planner.h"
#include "cobot_command/planning/script_planner.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
namespace item = protocol::item;

arm::ArmModel model() {
  return *arm::ArmModel::named("tm5-900");
}

/// How long a PTP takes from one posture to another, by the planner itself.
Duration ptpTime(const std::array<double, 6>& from, const std::array<double, 6>& to, double speed = 50,
                 double project_speed = 1.0) {
  motion::Ptp ptp;
  ptp.target = arm::toJointVector(to);
  ptp.speed_ratio = speed / 100;
  ptp.time_to_top_speed = 200ms;
  motion::Setting setting;
  setting.speed_override = project_speed;
  return (*motion::plan(model(), arm::toJointVector(from), ptp, setting))->duration();
}

constexpr std::array<double, 6> kHome{0, 0, 90, 0, 90, 0};
constexpr std::array<double, 6> kAside{60, 0, 90, 0, 90, 0};
constexpr std::array<double, 6> kBack{-30, 10, 80, 0, 90, 0};

class Planning : public ::testing::Test {
 protected:
  Planning() : rig(model(), link::LinkSettings{}) { rig.connect(); }
  CoreRig rig;
};

TEST_F(Planning, tellsThePlannedDurationAndTheActualOneAndWhereTheRobotStands) {
  rig.status(StatusFrames());
  const GoalId goal = rig.submit(moveJoints(kAside));
  EXPECT_EQ(rig.progress(goal).back().planned, ptpTime(kHome, kAside));
  rig.reply(rig.takeScript().id);
  rig.pass(900ms);
  rig.tag(1);
  rig.status(StatusFrames()
                 .at({60, 0, 90, 0, 90, 0})
                 .with(item::ofFloats("Coord_Robot_Flange", {400, -100, 300, 180, 0, 90}))
                 .with(item::ofFloats("Coord_Robot_Tool", {400, -100, 200, 180, 0, 90}))
                 .with(item::ofFloats("Base_Value", {100, 0, 50, 0, 0, 0})));
  const Outcome& outcome = *rig.outcome(goal);
  EXPECT_EQ(outcome.planned, ptpTime(kHome, kAside));
  EXPECT_EQ(outcome.actual, Duration(900ms));
  ASSERT_TRUE(outcome.final_joints_deg);
  EXPECT_NEAR((*outcome.final_joints_deg)[2], 90, 1e-6);
  ASSERT_TRUE(outcome.final_pose_mm_deg);
  EXPECT_NEAR((*outcome.final_pose_mm_deg)[0], 300, 1e-3);
  EXPECT_NEAR((*outcome.final_pose_mm_deg)[1], -100, 1e-3);
  EXPECT_NEAR((*outcome.final_pose_mm_deg)[2], 150, 1e-3);
}

TEST_F(Planning, warnsOfAToolThatTheArmCannotCarry) {
  ChangeTcpGoal tool;
  tool.weight = 4;  // what a TM5-900 carries
  rig.submit(tool);
  rig.reply(rig.takeScript().id);
  EXPECT_THAT(rig.warnings, ::testing::IsEmpty());
  tool.weight = 4.5;
  const GoalId goal = rig.submit(tool);
  rig.reply(rig.takeScript().id);
  EXPECT_THAT(rig.warnings,
              ::testing::ElementsAre(::testing::HasSubstr("4.5 kg, the payload of tm5-900 is 4 kg")));
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Done);
}

/// The stop alone leads back into the same error: the way out has to be told.
TEST_F(Planning, namesTheToolThatIsTooHeavyInTheErrorOfTheMotionAndHowToGetOut) {
  using ::testing::AllOf;
  using ::testing::HasSubstr;
  const auto changeTo = [&](double weight) {
    ChangeTcpGoal tool;
    tool.weight = weight;
    const GoalId goal = rig.submit(tool);
    ASSERT_TRUE(rig.accepted(goal));
    rig.reply(rig.takeScript().id);
  };
  const auto isExplained = [&](GoalId goal) {
    ASSERT_NE(rig.outcome(goal), nullptr);
    EXPECT_EQ(rig.outcome(goal)->error_id, own_error::kRobotError);
    EXPECT_THAT(rig.outcome(goal)->error_description,
                AllOf(HasSubstr("error 0x22"),
                      HasSubstr("the active tool has 4.5 kg, the payload of tm5-900 is 4 kg")));
    EXPECT_THAT(rig.outcome(goal)->remedy,
                AllOf(HasSubstr("Execute stop, then change_tcp"), HasSubstr("4 kg")));
  };
  const auto acknowledge = [&] {
    rig.discardSent();  // the layer stops a motion that fails by itself
    const GoalId stop = rig.submit(StopGoal{});
    rig.reply(rig.takeScript().id);
    rig.stream(StatusFrames().error(0x22, "OVERLOAD"));
    ASSERT_NE(rig.outcome(stop), nullptr);
    EXPECT_EQ(rig.outcome(stop)->ending, Ending::Done);
  };
  changeTo(4.5);
  const GoalId first = rig.submit(moveJoints(kAside));
  rig.reply(rig.takeScript().id);
  rig.status(StatusFrames().error(0x22, "OVERLOAD"));
  isExplained(first);
  acknowledge();
  rig.status(StatusFrames());
  rig.status(StatusFrames().error(0x22, "OVERLOAD"));
  EXPECT_THAT(rig.latest().diagnosis, HasSubstr("the active tool has 4.5 kg"));
  isExplained(rig.submit(moveJoints(kAside)));
  acknowledge();
  changeTo(4);
  rig.status(StatusFrames());
  rig.status(StatusFrames().error(0x23, "another"));
  const GoalId lighter = rig.submit(moveJoints(kAside));
  ASSERT_NE(rig.outcome(lighter), nullptr);
  EXPECT_THAT(rig.outcome(lighter)->error_description, ::testing::Not(HasSubstr("change_tcp")));
  EXPECT_THAT(rig.outcome(lighter)->remedy, ::testing::Not(HasSubstr("change_tcp")));
}

TEST_F(Planning, weighsTheToolOfTheStreamAndTheLoadOfAScript) {
  using ::testing::HasSubstr;
  rig.status(StatusFrames().with(item::ofFloat("TCP_Mass", 3)).with(item::ofString("TCP_Name", "grip")));
  RunScriptGoal load;
  load.script = "ChangeLoad(1.5)";
  rig.submit(load);
  rig.reply(rig.takeScript().id);
  EXPECT_THAT(rig.warnings,
              ::testing::ElementsAre(HasSubstr("the active tool \"grip\" has 3 kg, its load (ChangeLoad) 1.5 "
                                               "kg, the payload of tm5-900 is 4 kg")));
  rig.status(StatusFrames().with(item::ofFloat("TCP_Mass", 2)).error(0x22, "OVERLOAD"));
  EXPECT_THAT(rig.latest().diagnosis, ::testing::Not(HasSubstr("the payload of")));
  rig.status(StatusFrames().with(item::ofFloat("TCP_Mass", 5)).error(0x22, "OVERLOAD"));
  EXPECT_THAT(rig.latest().diagnosis, HasSubstr("the active tool has 5 kg, its load (ChangeLoad) 1.5 kg"));
}

TEST_F(Planning, countsTheProjectSpeed) {
  rig.status(StatusFrames().with(item::ofInt("Project_Speed", 50)));
  const GoalId goal = rig.submit(moveJoints(kAside));
  EXPECT_EQ(rig.progress(goal).back().planned, ptpTime(kHome, kAside, 50, 0.5));
  rig.takeScript();
}

/// The operator has changed it in the moment in which the motion was sent.
TEST_F(Planning, isMadeAnewForTheProjectSpeedThatIsShownWhenTheMotionBegins) {
  const auto slowly = [](const StatusFrames& frame) {
    return StatusFrames(frame).with(item::ofInt("Project_Speed", 10));
  };
  rig.status(StatusFrames());
  const GoalId goal = rig.submit(moveJoints(kAside));
  const Instant sent = rig.now;
  rig.reply(rig.takeScript().id);
  rig.status(slowly(StatusFrames().moving()));
  rig.pass(110ms);
  rig.status(slowly(StatusFrames().at({1, 0, 90, 0, 90, 0}).moving()));
  const Duration slow = ptpTime(kHome, kAside, 50, 0.1);
  EXPECT_EQ(rig.progress(goal).back().planned, slow);
  const Duration deadline = fromSeconds(toSeconds(slow) * 1.5) + 2s;
  while (rig.now - sent < deadline - 300ms) {
    rig.pass(100ms);
    rig.status(slowly(StatusFrames().at({30, 0, 90, 0, 90, 0}).moving()));
  }
  EXPECT_TRUE(rig.nothingSent()) << "its tag is not overdue";
  rig.tag(1);
  rig.status(slowly(StatusFrames().at({60, 0, 90, 0, 90, 0})));
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->planned, slow);
  EXPECT_THAT(rig.outcome(goal)->error_description,
              ::testing::HasSubstr("at 10 %, which the status stream showed"));
}

TEST_F(Planning, isNotMadeAnewForAProjectSpeedThatComesLater) {
  rig.status(StatusFrames());
  const GoalId goal = rig.submit(moveJoints(kAside));
  rig.reply(rig.takeScript().id);
  rig.pass(100ms);
  rig.status(StatusFrames().moving());
  rig.pass(100ms);
  rig.status(StatusFrames().moving().with(item::ofInt("Project_Speed", 10)));
  rig.pass(100ms);
  rig.status(StatusFrames().moving().with(item::ofInt("Project_Speed", 10)));
  EXPECT_EQ(rig.progress(goal).back().planned, ptpTime(kHome, kAside));
  rig.tag(1);
  rig.status(StatusFrames().at({60, 0, 90, 0, 90, 0}));
  EXPECT_EQ(rig.outcome(goal)->error_description, "");
}

TEST_F(Planning, startsAtTheEndOfWhatIsQueuedInFrontOfIt) {
  rig.status(StatusFrames());
  MoveAbsoluteGoal blended = moveJoints(kAside);
  blended.blending_enable = true;
  blended.blending_value = 0;
  rig.submit(blended);
  rig.reply(rig.takeScript().id);
  rig.now += 100ms;
  const GoalId second = rig.submit(moveJoints(kBack));
  EXPECT_EQ(rig.progress(second).back().planned, ptpTime(kAside, kBack));
  rig.reply(rig.takeScript().id);
  EXPECT_EQ(rig.progress(second).back().phase, Phase::Queued);
  EXPECT_FALSE(rig.outputs(kBlock<MoveAbsoluteGoal>).active);
  rig.pass(ptpTime(kHome, kAside) - Duration(100ms));
  EXPECT_EQ(rig.progress(second).back().phase, Phase::Active);
  EXPECT_TRUE(rig.outputs(kBlock<MoveAbsoluteGoal>).active);
  rig.tag(1);
  rig.status(StatusFrames().at({-30, 10, 80, 0, 90, 0}));
  EXPECT_EQ(rig.outcome(second)->ending, Ending::Done);
}

TEST_F(Planning, countsTheBlendWithWhatIsQueuedInFrontOfIt) {
  rig.status(StatusFrames());
  MoveAbsoluteGoal blended = moveJoints(kAside);
  blended.blending_enable = true;
  blended.blending_value = 20;
  const GoalId first = rig.submit(blended);
  const script::ScriptCommand sent_first = commandOf(blended);
  rig.reply(rig.takeScript().id);
  rig.now += 100ms;
  const GoalId second = rig.submit(moveJoints(kBack));
  rig.reply(rig.takeScript().id);

  planning::ScriptPlanner planner(model(), arm::toJointVector(kHome), motion::Setting{});
  const Duration whole = planner.append(sent_first)->duration;
  const auto step = planner.append(commandOf(moveJoints(kBack)), 100ms);
  ASSERT_LT(step->start, whole) << "they overlap";
  EXPECT_EQ(rig.progress(first).back().planned, whole);
  EXPECT_EQ(rig.progress(second).back().planned, step->duration);
  EXPECT_EQ(rig.progress(second).back().phase, Phase::Queued);
  rig.pass(step->start - Duration(100ms));
  EXPECT_EQ(rig.progress(second).back().phase, Phase::Active);
}

TEST_F(Planning, startsAtTheTargetJustReachedNotWhereTheStreamShowsIt) {
  rig.status(StatusFrames());
  rig.submit(moveJoints(kAside));
  rig.reply(rig.takeScript().id);
  rig.status(StatusFrames().moving());
  rig.pass(10ms);
  rig.tag(1);
  rig.status(StatusFrames().at({59.95F, 0, 90, 0, 90, 0}));
  const GoalId second = rig.submit(moveJoints(kBack));
  EXPECT_EQ(rig.progress(second).back().planned, ptpTime(kAside, kBack));
  EXPECT_EQ(rig.progress(second).back().phase, Phase::Sent);
  rig.takeScript();
}

TEST_F(Planning, startsWhereTheRobotStandsOnceTheQueueIsDone) {
  rig.status(StatusFrames());
  MoveAbsoluteGoal blended = moveJoints(kAside);
  blended.blending_enable = true;
  rig.submit(blended);
  rig.reply(rig.takeScript().id);
  for (Duration t{}; t < 5s; t += 500ms) {  // it was jogged elsewhere in the meantime
    rig.pass(500ms);
    rig.status(StatusFrames().with(item::ofFloats("Joint_Angle", {-30, 10, 80, 0, 90, 0})));
  }
  const GoalId second = rig.submit(moveJoints(kHome));
  EXPECT_EQ(rig.progress(second).back().planned->count() / 1000000, ptpTime(kBack, kHome).count() / 1000000);
  rig.takeScript();
}

TEST_F(Planning, ofACycleFromNobodyKnowsWhereAsksForNothingThatACycleHasNot) {
  PickAndPlaceGoal goal;
  goal.check_only = true;
  goal.steps.push_back({moveJoints(kAside), std::nullopt, std::nullopt, 0});
  const GoalId id = rig.submit(goal);
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->error_id, own_error::kStartUnknown);
  EXPECT_THAT(rig.outcome(id)->remedy, ::testing::StartsWith("Wait until the status stream shows"));
}

/// A blended motion of some seconds that is over long before its time.
class PlanningBehindWhatWasCutShort : public Planning {
 protected:
  PlanningBehindWhatWasCutShort() {
    rig.status(StatusFrames());
    MoveAbsoluteGoal far = moveJoints({120, 0, 90, 0, 90, 0}, 5);
    far.blending_enable = true;
    far.blending_value = 50;
    rig.submit(far);
    rig.reply(rig.takeScript().id);
    for (float j1 = 0; j1 < 8; ++j1) {
      rig.pass(100ms);
      rig.status(StatusFrames().at({j1, 0, 90, 0, 90, 0}).moving());
    }
  }
  static StatusFrames standing() { return StatusFrames().at({8, 0, 90, 0, 90, 0}); }
  void expectStartHere() {
    MoveAbsoluteGoal check = moveJoints(kAside);
    check.check_only = true;
    const GoalId goal = rig.submit(check);
    ASSERT_NE(rig.outcome(goal), nullptr);
    ASSERT_FALSE(rig.outcome(goal)->detail.as<CheckedMotion>().joint_path.empty())
        << rig.outcome(goal)->error_description;
    EXPECT_NEAR(rig.outcome(goal)->detail.as<CheckedMotion>().joint_path.front().joints[0], degToRad(8),
                1e-5);
  }
};

TEST_F(PlanningBehindWhatWasCutShort, startsWhereTheControllerCameToRestInItsError) {
  rig.status(standing().error(0x34, "x"));
  rig.pass(15ms);
  rig.status(standing());
  expectStartHere();
}

TEST_F(PlanningBehindWhatWasCutShort, startsWhereTheRobotStandsForSomebodyElsesReason) {
  for (int i = 0; i < 50; ++i) {
    rig.pass(15ms);
    rig.status(standing());
  }
  expectStartHere();
}

TEST_F(Planning, isLeftOutWithoutAStatusStreamAndWhileTheRobotMovesFromNobodyKnowsWhere) {
  const GoalId outside = rig.submit(moveJoints({0, 0, 170, 0, 90, 0}));
  ASSERT_NE(rig.outcome(outside), nullptr) << "a joint target can be judged from anywhere";
  EXPECT_EQ(rig.outcome(outside)->error_id, own_error::kJointLimit);
  const GoalId blind = rig.submit(moveJoints(kAside));
  EXPECT_EQ(rig.outcome(blind), nullptr) << "sent unplanned";
  EXPECT_FALSE(rig.progress(blind).back().planned);
  rig.reply(rig.takeScript().id, false);
  rig.status(StatusFrames().moving());
  const GoalId jogged = rig.submit(moveJoints(kAside));
  EXPECT_FALSE(rig.progress(jogged).back().planned);
  rig.takeScript();
}

TEST_F(Planning, ofARawScriptKnowsItsVariablesExpressionsAndConversions) {
  rig.status(StatusFrames());
  RunScriptGoal raw;
  raw.await_motion = true;
  raw.script =
      "float[] there = {60,0,90,0,90,0}  // J1 first\n"
      "there[0] += 100 * 3\n"
      "PTP(\"JPP\", there, 35.0, 200, 0, false)";
  const GoalId outside = rig.submit(raw);
  ASSERT_NE(rig.outcome(outside), nullptr);
  EXPECT_EQ(rig.outcome(outside)->error_id, own_error::kJointLimit)
      << rig.outcome(outside)->error_description;
  raw.script = "int turn = 60\nPTP(\"JPP\",turn,0,90,0,90,0,50.0,200,0,false)";
  const GoalId inside = rig.submit(raw);
  EXPECT_EQ(rig.progress(inside).back().planned, ptpTime(kHome, kAside));
  rig.takeScript();
}

/// The next one begins with the acceptance, before any frame can show that the robot moves.
TEST_F(Planning, isLeftOutBehindAMotionThatCouldNotBePlanned) {
  rig.status(StatusFrames());
  RunScriptGoal raw;
  raw.script = "PTP(\"JPP\",60,0,90,0,90,0,speed_of_the_project,200,0,false)";
  rig.submit(raw);
  MoveAbsoluteGoal next = moveJoints(kBack);
  next.buffer_mode = static_cast<int>(BufferMode::Buffered);
  const GoalId waits = rig.submit(next);
  rig.reply(rig.takeScript().id);
  ASSERT_TRUE(rig.accepted(waits));
  EXPECT_FALSE(rig.progress(waits).back().planned);
  rig.reply(rig.takeScript().id);
  rig.pass(300ms);
  rig.tag(1);
  rig.status(StatusFrames().at({-30, 10, 80, 0, 90, 0}));
  EXPECT_EQ(rig.outcome(waits)->ending, Ending::Done) << rig.outcome(waits)->error_description;
  const GoalId known = rig.submit(moveJoints(kHome));
  EXPECT_TRUE(rig.progress(known).back().planned);
  rig.takeScript();
}

TEST_F(Planning, countsTheActiveBaseAndTheTcpThatFlangeAndToolTell) {
  const std::array<double, 6> base{100, 50, -30, 0, 0, 40};
  const arm::Pose tool = arm::toPose({0, 0, 200, 0, 0, 0});
  const arm::Pose flange = arm::forwardKinematics(model(), arm::toJointVector(kAside));
  MoveAbsoluteGoal goal = CoreRig::move();
  goal.speed = 50;
  goal.target = arm::toControllerPose(arm::toPose(base).inverse() * flange * tool);
  rig.status(StatusFrames()
                 .with(item::ofFloats("Base_Value", {100, 50, -30, 0, 0, 40}))
                 .with(item::ofFloats("Coord_Robot_Flange", {400, -100, 300, 180, 0, 90}))
                 .with(item::ofFloats("Coord_Robot_Tool", {400, -100, 100, 180, 0, 90})));
  const GoalId id = rig.submit(goal);
  ASSERT_TRUE(rig.progress(id).back().planned);
  EXPECT_NEAR(toSeconds(*rig.progress(id).back().planned), toSeconds(ptpTime(kHome, kAside)), 1e-5);
  rig.takeScript();
}

TEST_F(Planning, givesAMotionOneAndAHalfTimesItsPlanAndTwoSeconds) {
  rig.status(StatusFrames());
  rig.submit(moveJoints(kAside));
  rig.reply(rig.takeScript().id);
  const Duration limit = ptpTime(kHome, kAside) * 3 / 2 + Duration(2s);
  const Instant start = rig.now;
  while (rig.now + 500ms < start + limit) {
    rig.pass(500ms);
    rig.status(StatusFrames().moving());
  }
  EXPECT_TRUE(rig.nothingSent());
  rig.pass(start + limit - rig.now + Duration(1ns));
  EXPECT_EQ(rig.takeTagQuery().tag, 1);
}

}  // namespace
}  // namespace cobot_command::testing
