#include "cobot_command/planning/script_rest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "planning_support.h"

#include "cobot_command/common/units.h"

namespace cobot_command::planning {
namespace {

constexpr double kOnItsWay = 1e-4;  // [m] what 32-bit floats and whole millionths leave
const arm::ArmModel kArm = model();

ScriptPlanner::Start startInFrames() {
  ScriptPlanner::Start start;
  start.joints = workingPosture();
  start.base = arm::toPose({100, 50, 20, 0, 0, 30});
  start.tcp = arm::toPose({10, 0, 120, 0, 20, 0});
  return start;
}

PlannedLines planned(const std::vector<std::string>& lines) {
  PlannedLines made{{}, {}, startInFrames()};
  ScriptPlanner planner(kArm, made.start);
  for (const std::string& text : lines) {
    made.commands.push_back(line(text));
    if (const auto step = append(planner, text); step.trajectory) made.motions.push_back(step.trajectory);
  }
  return made;
}

arm::Pose tcpAt(const motion::Trajectory& motion, Duration time) {
  return arm::forwardKinematics(kArm, motion.at(time).position) * *startInFrames().tcp;
}

/// Of the TCP from the way of `motion` behind `time` [m].
double awayFrom(const motion::Trajectory& motion, Duration time, const arm::Pose& pose) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 2000; ++i) {
    const Duration at = time + (motion.duration() - time) * i / 2000;
    least = std::min(least, (tcpAt(motion, at).translation() - pose.translation()).norm());
  }
  return least;
}

/// Plans what is left from where the arm stands; returns the motions of it.
std::vector<motion::TrajectoryPtr> planRest(const PlannedLines& lines, const PlaceOnLines& place) {
  auto start = lines.start;
  start.joints = lines.motions[place.motion]->at(place.time).position;
  ScriptPlanner planner(kArm, start);
  std::vector<motion::TrajectoryPtr> motions;
  for (const auto& command : restOf(lines, place, kArm)) {
    const auto step = planner.append(command);
    if (!step) {
      ADD_FAILURE() << script::toText(command) << ": " << step.error().message;
      return {};
    }
    if (step->trajectory) motions.push_back(step->trajectory);
  }
  return motions;
}

struct Kind {
  std::string name;
  std::string line;
};

class ScriptRest : public ::testing::TestWithParam<Kind> {};

TEST_P(ScriptRest, goesOnByTheSameWayToTheSamePlace) {
  const PlannedLines lines = planned({GetParam().line});
  ASSERT_EQ(lines.motions.size(), 1U);
  ASSERT_EQ(whyNotResumable(lines), std::nullopt);
  const motion::Trajectory& whole = *lines.motions[0];
  for (const double share : {0.0, 0.2, 0.5, 0.83, 0.97}) {
    SCOPED_TRACE(share);
    const Duration time = std::chrono::duration_cast<Duration>(whole.duration() * share);
    const auto rest = planRest(lines, {0, time});
    ASSERT_FALSE(rest.empty());
    for (const auto& motion : rest) {
      for (int i = 0; i <= 20; ++i) {
        EXPECT_LT(awayFrom(whole, time, tcpAt(*motion, motion->duration() * i / 20)), kOnItsWay + 2e-4);
      }
    }
    EXPECT_LT((rest.back()->end().position - whole.end().position).cwiseAbs().maxCoeff(), degToRad(0.01));
  }
}

INSTANTIATE_TEST_SUITE_P(
    , ScriptRest,
    ::testing::Values(Kind{"PtpToJoints", R"(PTP("JPP",40,0,90,0,90,0,50,200,0,false))"},
                      Kind{"PtpToAPose", R"(PTP("CPP",200,-300,300,180,0,90,50,200,0,false,0,2,4))"},
                      Kind{"MovePtpOfJoints", R"(Move_PTP("JPP",20,5,-10,0,5,30,50,200,0,false))"},
                      Kind{"MovePtpInTheBase", R"(Move_PTP("CPP",0,60,-40,0,0,10,50,200,0,false))"},
                      Kind{"MovePtpInTheTool", R"(Move_PTP("TPP",0,20,-40,0,0,10,50,200,0,false))"},
                      Kind{"Line", R"(Line("CAP",180,-420,250,170,-10,40,100,200,0,false))"},
                      Kind{"MoveLineInTheBase", R"(Move_Line("CAP",50,40,-60,0,0,25,100,200,0,false))"},
                      Kind{"MoveLineInTheTool", R"(Move_Line("TPP",0,30,-60,10,0,25,50,200,0,false))"},
                      Kind{"PLineToJoints", R"(PLine("JAP",20,10,85,-5,85,20,100,200,0))"},
                      Kind{"MovePLineOfJoints", R"(Move_PLine("JAP",4,-5,5,0,0,0,100,200,0))"},
                      Kind{"MovePLineInTheTool", R"(Move_PLine("TAP",0,30,-60,10,0,25,100,200,0))"}),
    [](const auto& kind) { return kind.param.name; });

/// From where the arm begins: through a place beside it to one in front of it.
std::string arcBy(int angle) {
  const auto frames = startInFrames();
  const arm::Pose start =
      frames.base->inverse() * arm::forwardKinematics(kArm, workingPosture()) * *frames.tcp;
  const auto at = [&](double x, double y) {
    arm::Pose pose = start;
    pose.translation() += Eigen::Vector3d(x, y, 0);
    return arm::toControllerPose(pose);
  };
  script::Circle circle;
  circle.format = {script::DataFormat::Target::Cartesian, script::DataFormat::Speed::Absolute,
                   script::DataFormat::Blending::Percent};
  circle.via = at(0.03, 0.03);
  circle.end = at(0.06, 0);
  circle.options.speed = 50;
  circle.options.accel_time = 200;
  circle.arc_angle = angle;
  return script::toText(script::ScriptCommand(circle));
}

TEST(ScriptRestOfAnArc, staysOnItsCircleHoweverFarItGoes) {
  for (const int angle : {0, 90, 350, 360}) {
    const PlannedLines lines = planned({arcBy(angle)});
    ASSERT_EQ(lines.motions.size(), 1U);
    const motion::Trajectory& whole = *lines.motions[0];
    for (const double share : {0.0, 0.3, 0.6, 0.9}) {
      SCOPED_TRACE(testing::Message() << angle << " deg, " << share);
      const Duration time = std::chrono::duration_cast<Duration>(whole.duration() * share);
      double way = 0;
      const auto rest = planRest(lines, {0, time});
      ASSERT_FALSE(rest.empty());
      for (const auto& motion : rest) {
        way += motion->tcpWay();
        for (int i = 0; i <= 20; ++i) {
          EXPECT_LT(awayFrom(whole, Duration::zero(), tcpAt(*motion, motion->duration() * i / 20)),
                    kOnItsWay + 2e-4);
        }
      }
      EXPECT_NEAR(way, (1.0 - whole.progress(time)) * whole.tcpWay(), 1e-3);
      EXPECT_LT((rest.back()->end().position - whole.end().position).cwiseAbs().maxCoeff(), degToRad(0.05));
    }
  }
}

TEST(ScriptRestOfAnArc, isALineWhereItIsNextToStraight) {
  const PlannedLines lines = planned({arcBy(90)});
  ASSERT_EQ(lines.motions.size(), 1U);
  const auto almost = lines.motions[0]->duration() - std::chrono::milliseconds(20);
  const auto rest = restOf(lines, {0, almost}, kArm);
  ASSERT_EQ(rest.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<script::Line>(rest[0]));
}

TEST(ScriptRestOfSeveralLines, leavesOutWhatIsDoneAndKeepsWhatFollows) {
  const PlannedLines lines =
      planned({R"(Move_Line("CAP",0,0,-30,0,0,0,100,200,0,false))", R"(IO["ControlBox"].DO[1]=1)",
               R"(Move_Line("CAP",0,40,0,0,0,0,100,200,0,false))", R"(IO["ControlBox"].DO[2]=1)"});
  ASSERT_EQ(whyNotResumable(lines), std::nullopt);
  const auto in_the_second = restOf(lines, {1, std::chrono::milliseconds(200)}, kArm);
  ASSERT_EQ(in_the_second.size(), 2U);
  EXPECT_TRUE(std::holds_alternative<script::Line>(in_the_second[0]));
  EXPECT_EQ(script::toText(in_the_second[1]), R"(IO["ControlBox"].DO[2]=1)");
  EXPECT_EQ(restOf(lines, {0, std::chrono::milliseconds(200)}, kArm).size(), 4U);
  EXPECT_EQ(restOf(lines, {1, lines.motions[1]->duration()}, kArm).size(), 1U) << "at its end";
}

TEST(ScriptRestOfWhatSets, isAllOfIt) {
  const PlannedLines lines = planned({"ChangeTCP(0,0,120,0,0,0,1.5)", "ChangeLoad(2)"});
  EXPECT_EQ(whyNotResumable(lines), std::nullopt);
  EXPECT_EQ(restOf(lines, {}, kArm).size(), 2U);
}

TEST(LinesThatCannotBeResumed, areNamed) {
  const char* const kTurn = R"(PTP("JPP",40,0,90,0,90,0,50,200,0,false))";
  for (const char* other : {"ChangeTCP(0,0,120,0,0,0)", "WaitQueueTag(3)", "QueueTag(3,0)", "Pause()",
                            "ScriptExit()", "StopAndClearBuffer()"}) {
    const auto why = whyNotResumable(planned({kTurn, other}));
    ASSERT_TRUE(why) << other;
    EXPECT_NE(why->find(other), std::string::npos) << *why;
  }
  PlannedLines unplanned = planned({kTurn});
  unplanned.motions.clear();
  EXPECT_TRUE(whyNotResumable(unplanned));
  PlannedLines unknown = planned({R"(Move_Line("TAP",0,30,-60,10,0,25,100,200,0,false))"});
  unknown.start.base.reset();
  EXPECT_NE(whyNotResumable(unknown)->find("base"), std::string::npos);
  PlannedLines in_joints = planned({kTurn});
  in_joints.start.base.reset();
  EXPECT_EQ(whyNotResumable(in_joints), std::nullopt) << "its target is in joints";
}

}  // namespace
}  // namespace cobot_command::planning
