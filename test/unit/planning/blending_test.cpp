#include "planning_support.h"

namespace cobot_command::planning {
namespace {

using namespace std::chrono_literals;

// 80 mm at 100 mm/s with 200 ms to the top speed: 1 s.
const std::string kSideways = "Move_Line(\"CAP\",0,80,0,0,0,0,100,200,";
const std::string kDown = "Move_Line(\"CAP\",0,0,-80,0,0,0,100,200,";
const std::string kSidewaysByRadius = "Move_Line(\"CAR\",0,80,0,0,0,0,100,200,";
const std::string kStop = "0,false)";

class BlendedScript : public ::testing::Test {
 protected:
  ScriptPlanner planner{model(), workingPosture(), motion::Setting{}};

  [[nodiscard]] Eigen::Vector3d tcp(const arm::JointVector& joints) const {
    return (arm::forwardKinematics(model(), joints) * planner.setting().tcp).translation();
  }
};

TEST(BlendOf, readsPercentAndMillimetres) {
  const auto of = [](const std::string& text) { return blendOf(std::get<script::MoveLine>(line(text))); };
  EXPECT_DOUBLE_EQ(std::get<motion::BlendShare>(*of(kSideways + "35,false)")).value, 0.35);
  EXPECT_DOUBLE_EQ(std::get<motion::BlendShare>(*of(kSideways + "250,false)")).value, 1.0);
  EXPECT_DOUBLE_EQ(std::get<motion::BlendRadius>(*of(kSidewaysByRadius + "35,false)")).metres, 0.035);
  EXPECT_FALSE(of(kSideways + "0,true)"));
  EXPECT_FALSE(of(kSideways + "-5,false)"));
}

TEST(BlendOf, doesNotDependOnPrecisePositioning) {
  const auto of = [](const std::string& text) { return blendOf(std::get<script::Ptp>(line(text))); };
  EXPECT_TRUE(of("PTP(\"JPP\",0,0,90,0,90,0,50,200,20,true)"));
  EXPECT_TRUE(of("PTP(\"JPP\",0,0,90,0,90,0,50,200,20,false)"));
}

TEST_F(BlendedScript, startsTheNextMotionBeforeTheEnd) {
  const PlannedStep first = append(planner, kSideways + "50,false)");
  const PlannedStep second = append(planner, kDown + kStop);
  EXPECT_NEAR(toSeconds(first.duration), 1.0, 2e-9);
  EXPECT_NEAR(toSeconds(second.start), 0.9, 4e-9) << "half of 200 ms before the end";
  EXPECT_NEAR(toSeconds(second.duration), 1.0, 2e-9);
  EXPECT_EQ(planner.duration(), second.start + second.duration);
  EXPECT_EQ(second.trajectory->at(0s).position, first.trajectory->at(second.start).position);
  EXPECT_EQ(second.trajectory->at(0s).velocity, first.trajectory->at(second.start).velocity);
}

TEST_F(BlendedScript, countsAnOffsetFromTheCorner) {
  const Eigen::Vector3d start = tcp(planner.joints());
  append(planner, kSideways + "100,false)");
  append(planner, kDown + "100,false)");
  append(planner, kSideways + kStop);
  EXPECT_LT((tcp(planner.joints()) - start - Eigen::Vector3d(0, 0.16, -0.08)).norm(), 1e-9);
}

TEST_F(BlendedScript, blendsPastTagsOutputsBasesAndLoads) {
  append(planner, kSideways + "100,false)");
  for (const char* between : {"QueueTag(1)", "ChangeBase(1,2,3,0,0,0)", "ChangeBase(\"RobotBase\")",
                              "ChangeLoad(1)", "IO[\"EndModule\"].DO[0]=1"}) {
    append(planner, between);
  }
  EXPECT_NEAR(toSeconds(append(planner, kDown + kStop).start), 0.8, 4e-9);
}

TEST_F(BlendedScript, stopsWhereTheTcpChangesOrTheScriptWaits) {
  for (const char* between : {"ChangeTCP(0,0,100,0,0,0)", "QueueTag(1,1)", "WaitQueueTag(1)"}) {
    ScriptPlanner one(model(), workingPosture(), motion::Setting{});
    const PlannedStep first = append(one, kSideways + "100,false)");
    append(one, between);
    EXPECT_EQ(append(one, kDown + kStop).start, first.duration) << between;
  }
}

TEST_F(BlendedScript, blendsWithWhatIsLeftWhenACommandArrivesLate) {
  append(planner, kSideways + "100,false)");
  const Duration end = planner.duration();
  ScriptPlanner in_time = planner, late = planner, too_late = planner;
  EXPECT_EQ(in_time.append(line(kDown + kStop), 700ms)->start, append(planner, kDown + kStop).start);
  EXPECT_EQ(late.append(line(kDown + kStop), 930ms)->start, Duration(930ms));
  const auto alone = too_late.append(line(kDown + kStop), end + 1s);
  EXPECT_EQ(alone->start, end + 1s);
  EXPECT_TRUE(alone->trajectory->at(0s).velocity.isZero());
  EXPECT_EQ(too_late.duration(), end + 1s + alone->duration);
}

TEST_F(BlendedScript, tellsOfARadiusThatIsLargerThanHalfOfItsOwnPath) {
  EXPECT_FALSE(append(planner, kSidewaysByRadius + "40,false)").misfit);
  append(planner, "ChangeTCP(\"NOTOOL\")");  // stops, so that this radius is not the next motion's business
  const PlannedStep step = append(planner, kSidewaysByRadius + "41,false)");
  ASSERT_TRUE(step.misfit);
  EXPECT_NEAR(step.misfit->radius, 0.041, 1e-12);
  EXPECT_NEAR(step.misfit->allowed, 0.040, 1e-9);
  EXPECT_FALSE(step.misfit->of_before);
}

TEST_F(BlendedScript, tellsOfARadiusThatIsLargerThanHalfOfThePathBehind) {
  append(planner, kSidewaysByRadius + "30,false)");
  const PlannedStep step = append(planner, "Move_Line(\"CAP\",0,0,-50,0,0,0,100,200,0,false)");
  ASSERT_TRUE(step.misfit);
  EXPECT_NEAR(step.misfit->radius, 0.030, 1e-12);
  EXPECT_NEAR(step.misfit->allowed, 0.025, 1e-9);
  EXPECT_TRUE(step.misfit->of_before);
}

TEST_F(BlendedScript, tellsOfNoMisfitWhereNothingIsBlendedByRadius) {
  EXPECT_FALSE(append(planner, kSideways + "100,false)").misfit);
  EXPECT_FALSE(append(planner, "Move_Line(\"CPP\",0,0,-1,0,0,0,10,200,100,false)").misfit);
  EXPECT_FALSE(append(planner, "Move_PTP(\"JPP\",0,0,0,0,0,1,10,200,0,false)").misfit);
}

TEST(Chains, ofPLinesSpeedUpAndSlowDownOnce) {
  // 5 x 20 mm at 100 mm/s, and one ramp of 100 ms.
  ScriptPlanner planner(model(), workingPosture(), motion::Setting{});
  for (int i = 0; i < 5; ++i) {
    const PlannedStep step = append(planner, "Move_PLine(\"CAP\",0,20,0,0,0,0,100,100,50)");
    EXPECT_LE(step.start + step.duration, planner.duration());
  }
  EXPECT_NEAR(toSeconds(planner.duration()), 1.0 + 0.1, 1e-6);
}

TEST(Chains, ofPvtPointsAreOneMotionAtTheirEnd) {
  ScriptPlanner planner(model(), workingPosture(), motion::Setting{});
  EXPECT_FALSE(append(planner, "PVTEnter(0)").trajectory);
  EXPECT_FALSE(append(planner, "PVTPoint(12,15,80,-5,85,20,4,0,0,0,0,0,0.5)").trajectory);
  EXPECT_FALSE(append(planner, "QueueTag(2)").trajectory);
  EXPECT_FALSE(append(planner, "PVTPoint(14,15,80,-5,85,20,0,0,0,0,0,0,1)").trajectory);
  const PlannedStep step = append(planner, "PVTExit()");
  ASSERT_TRUE(step.trajectory);
  EXPECT_EQ(step.duration, std::chrono::milliseconds(1500));
  EXPECT_EQ(planner.joints(), arm::toJointVector({14, 15, 80, -5, 85, 20}));
}

TEST(Chains, ofPvtPointsThatCannotBeMadeAreRefused) {
  ScriptPlanner planner(model(), workingPosture(), motion::Setting{});
  append(planner, "PVTEnter(0)");
  append(planner, "PVTPoint(100,15,80,-5,85,20,0,0,0,0,0,0,0.1)");
  EXPECT_EQ(refusalOf(planner, "PVTExit()").reason, motion::Refusal::Reason::JointSpeed);
}

TEST(Chains, endWhereTheArmTakesVelocities) {
  ScriptPlanner planner(model(), workingPosture(), motion::Setting{});
  append(planner, "ContinueVLine(500,1000)");
  EXPECT_FALSE(planner.jointsKnown());
}

}  // namespace
}  // namespace cobot_command::planning
