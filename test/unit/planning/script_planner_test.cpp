#include "planning_support.h"

#include "cobot_command/motion/planner.h"

namespace cobot_command::planning {
namespace {

using motion::Refusal;

class ScriptPlannerTest : public ::testing::Test {
 protected:
  ScriptPlanner planner{model(), workingPosture(), motion::Setting{}};

  [[nodiscard]] arm::ControllerPose tool() const {
    const motion::Setting setting = planner.setting();
    return arm::toControllerPose(setting.base.inverse() * arm::forwardKinematics(model(), planner.joints()) *
                                 setting.tcp);
  }
};

TEST_F(ScriptPlannerTest, startsEachMotionWhereAndWhenTheOneBeforeEnds) {
  const PlannedStep first = append(planner, "PTP(\"JPP\",0,0,90,0,90,0,50,200,0,false)");
  const PlannedStep second = append(planner, "Move_Line(\"CAP\",0,0,-50,0,0,0,100,200,0,false)");
  EXPECT_EQ(first.start, Duration::zero());
  EXPECT_EQ(first.trajectory->at(Duration::zero()).position, workingPosture());
  EXPECT_EQ(second.start, first.duration);
  EXPECT_EQ(second.trajectory->at(Duration::zero()).position, first.trajectory->end().position);
  EXPECT_EQ(planner.joints(), second.trajectory->end().position);
  EXPECT_EQ(planner.duration(), first.duration + second.duration);
  EXPECT_NEAR(toSeconds(second.duration), 0.5 + 0.2, 1e-8) << "50 mm at 100 mm/s";
}

TEST_F(ScriptPlannerTest, plansAsMotionDoes) {
  motion::Setting setting;
  setting.speed_override = 0.3;
  ScriptPlanner slow(model(), workingPosture(), setting);
  const PlannedStep step = append(slow, "PTP(\"JPP\",0,0,90,0,90,0,50,200,0,false)");
  const auto direct = motion::plan(
      model(), workingPosture(),
      motion::Ptp{arm::toJointVector({0, 0, 90, 0, 90, 0}), 0.5, std::chrono::milliseconds(200)}, setting);
  EXPECT_EQ(step.duration, (*direct)->duration());
}

TEST_F(ScriptPlannerTest, plansATimeToTopSpeedOfZeroAsTheShortestThatTheArmAllows) {
  // As an off-line programming tool sends it.
  for (const char* text :
       {"PTP(\"JPP\",5,0,90,0,90,0,10,0,0,false)", "Move_Line(\"CAP\",0,0,-50,0,0,0,100,0,0,false)",
        "Circle(\"CAP\",400,-100,300,180,0,90,380,-60,300,180,0,90,100,0,0,0,false)"}) {
    const PlannedStep step = append(planner, text);
    EXPECT_TRUE(step.planned) << text;
    EXPECT_GT(step.duration, Duration::zero()) << text;
  }
}

TEST_F(ScriptPlannerTest, givesNoTrajectoryToWhatIsNoMotion) {
  append(planner, "PTP(\"JPP\",0,0,90,0,90,0,50,200,0,false)");
  for (const char* text : {"QueueTag(1)", "ChangeBase(1,2,3,4,5,6)", "ChangeTCP(1,2,3,4,5,6)",
                           "ChangeLoad(1)", "Pause()", "WaitQueueTag(1)"}) {
    const PlannedStep step = append(planner, text);
    EXPECT_TRUE(step.planned) << text;
    EXPECT_EQ(step.trajectory, nullptr) << text;
    EXPECT_EQ(step.start, planner.duration()) << text;
    EXPECT_EQ(step.duration, Duration::zero()) << text;
  }
  EXPECT_EQ(planner.joints(), arm::toJointVector({0, 0, 90, 0, 90, 0}));
}

TEST_F(ScriptPlannerTest, takesBaseAndTcpForWhatFollows) {
  append(planner, "ChangeBase(100,0,50,0,0,90)");
  append(planner, "ChangeTCP(0,0,120,0,0,0,1.5)");
  append(planner, "PTP(\"CPP\",-100,-450,200,180,0,0,50,200,0,false)");
  EXPECT_TRUE(arm::toPose(tool()).isApprox(arm::toPose({-100, -450, 200, 180, 0, 0}), 1e-9));
  EXPECT_TRUE(planner.setting().base.isApprox(arm::toPose({100, 0, 50, 0, 0, 90})));
  EXPECT_TRUE(planner.setting().tcp.isApprox(arm::toPose({0, 0, 120, 0, 0, 0})));
  append(planner, "ChangeBase(\"RobotBase\")");
  append(planner, "ChangeTCP(\"NOTOOL\")");
  EXPECT_TRUE(planner.setting().base.isApprox(arm::Pose::Identity()));
  EXPECT_TRUE(planner.setting().tcp.isApprox(arm::Pose::Identity()));
  EXPECT_TRUE(planner.framesKnown());
}

TEST_F(ScriptPlannerTest, plansOnlyJointMotionsInUnknownFrames) {
  for (const char* change : {"ChangeBase(\"Table\")", "ChangeTCP(\"Gripper\")"}) {
    ScriptPlanner lost(model(), workingPosture(), motion::Setting{});
    append(lost, change);
    EXPECT_FALSE(lost.framesKnown());
    EXPECT_TRUE(append(lost, "PTP(\"JPP\",0,0,90,0,90,0,50,200,0,false)").planned);
    EXPECT_TRUE(append(lost, "Move_PTP(\"JPP\",1,0,0,0,0,0,50,200,0,false)").planned);
    const Duration known = lost.duration();
    const PlannedStep step = append(lost, "Move_Line(\"CAP\",0,0,-50,0,0,0,100,200,0,false)");
    EXPECT_FALSE(step.planned);
    EXPECT_EQ(step.trajectory, nullptr);
    EXPECT_EQ(step.start, known);
    EXPECT_FALSE(lost.jointsKnown());
  }
}

TEST_F(ScriptPlannerTest, knowsTheArmAgainAfterTheNextJointTarget) {
  append(planner, "ChangeBase(\"Table\")");
  append(planner, "PTP(\"CPP\",400,0,300,180,0,90,50,200,0,false)");
  append(planner, "ChangeBase(\"RobotBase\")");
  EXPECT_FALSE(append(planner, "Move_PTP(\"JPP\",1,0,0,0,0,0,50,200,0,false)").planned);
  EXPECT_FALSE(append(planner, "PTP(\"JPP\",0,0,90,0,90,0,50,200,0,false)").planned)
      << "from an unknown start";
  ASSERT_TRUE(planner.jointsKnown());
  EXPECT_EQ(planner.joints(), arm::toJointVector({0, 0, 90, 0, 90, 0}));
  EXPECT_TRUE(append(planner, "Move_Line(\"CAP\",0,0,-50,0,0,0,100,200,0,false)").planned);
}

TEST_F(ScriptPlannerTest, doesNotKnowWhereAStopLeavesTheArm) {
  EXPECT_TRUE(append(planner, "StopAndClearBuffer()").planned) << "nothing moves yet";
  EXPECT_TRUE(planner.jointsKnown());
  append(planner, "PTP(\"JPP\",0,0,90,0,90,0,50,200,0,false)");
  EXPECT_FALSE(append(planner, "StopAndClearBuffer()").planned);
  EXPECT_FALSE(planner.jointsKnown());
  EXPECT_FALSE(append(planner, "Move_Line(\"CAP\",0,0,-50,0,0,0,100,200,0,false)").planned);
  append(planner, "PTP(\"JPP\",0,0,90,0,90,0,50,200,0,false)");
  EXPECT_TRUE(planner.jointsKnown());
}

TEST_F(ScriptPlannerTest, knowsTheArmBehindAStopThatComesWhenAllIsDone) {
  append(planner, "PTP(\"JPP\",0,0,90,0,90,0,50,200,0,false)");
  const auto stop = planner.append(script::ScriptCommand(script::StopAndClearBuffer{}), planner.duration());
  ASSERT_TRUE(stop);
  EXPECT_TRUE(stop->planned);
  EXPECT_EQ(planner.joints(), arm::toJointVector({0, 0, 90, 0, 90, 0}));
}

TEST_F(ScriptPlannerTest, refusesAJointTargetOutsideTheLimitsFromAnUnknownStartToo) {
  ScriptPlanner lost(model(), ScriptPlanner::Start{});
  EXPECT_EQ(refusalOf(lost, "PTP(\"JPP\",0,0,170,0,90,0,50,200,0,false)").reason,
            Refusal::Reason::JointLimit);
  EXPECT_FALSE(lost.jointsKnown());
}

TEST_F(ScriptPlannerTest, isNotChangedByARefusedMotion) {
  append(planner, "PTP(\"JPP\",0,0,90,0,90,0,50,200,0,false)");
  const Duration before = planner.duration();
  EXPECT_EQ(refusalOf(planner, "PTP(\"CPP\",2000,0,300,180,0,90,50,200,0,false)").reason,
            Refusal::Reason::Unreachable);
  EXPECT_EQ(refusalOf(planner, "PTP(\"CPP\",400,0,300,180,0,90,50,200,0,false,0,0,0)").reason,
            Refusal::Reason::PoseBits);
  EXPECT_EQ(planner.duration(), before);
  EXPECT_EQ(planner.joints(), arm::toJointVector({0, 0, 90, 0, 90, 0}));
}

TEST_F(ScriptPlannerTest, canBeTriedOutOnACopy) {
  ScriptPlanner trial = planner;
  append(trial, "PTP(\"JPP\",0,0,90,0,90,0,50,200,0,false)");
  EXPECT_EQ(planner.joints(), workingPosture());
  EXPECT_EQ(planner.duration(), Duration::zero());
}

}  // namespace
}  // namespace cobot_command::planning
