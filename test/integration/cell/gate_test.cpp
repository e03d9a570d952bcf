// What the gate refuses, so that no byte leaves (oracle 42), and that nothing is released before it is
// measured (oracle 39).
#include "run_rig.h"

#include "cobot_command/common/units.h"

namespace cobot_command::trial {
namespace {

using command::Departure;
using ::testing::HasSubstr;
namespace own_error = blocks::own_error;

/// The robot is ordered a cycle, and refused its first frame.
void expectRefusal(RunRig& rig, int error_id, const std::string& why) {
  const std::size_t sent = rig.robot(0).scripts().size();
  const arm::JointVector joints = rig.robot(0).state().joints;
  rig.order(0, 1);
  ASSERT_TRUE(rig.passUntil([&] { return rig.robot(0).hasEnded(); }, 2s));
  EXPECT_EQ(rig.errorOf(0), error_id);
  EXPECT_THAT(rig.robot(0).lastOutcome()->error_description, HasSubstr(why));
  EXPECT_EQ(rig.robot(0).scripts().size(), sent);
  rig.pass(2s);
  EXPECT_TRUE(rig.robot(0).state().joints == joints);
}

void expectRefusalOf(const std::function<void(Departure&)>& tamper, int error_id, const std::string& why) {
  RunRig rig(artifactOf("handover"));
  ASSERT_TRUE(rig.trial->start());
  rig.robot(0).tamper = [tamper](Departure& departure) {
    if (departure.asks_permit) tamper(departure);
  };
  expectRefusal(rig, error_id, why);
}

TEST(TheGate, refusesLinesOfWhichOneDigitIsAnother) {
  expectRefusalOf(
      [](Departure& departure) {
        std::string& line = departure.lines.at(0);
        char& digit = line.at(line.find_first_of("123456789"));
        digit = digit == '9' ? '8' : static_cast<char>(digit + 1);
      },
      own_error::kNotInArtifact, "is permitted");
}

/// What nobody is told of cannot be looked at.
TEST(TheGate, refusesAllWhereTheStreamDoesNotTellOfModeErrorAndEmergencyStop) {
  for (const char* item : {"MA_Mode", "Robot_Error", "ESTOP"}) {
    TrialSettings settings;
    settings.not_streamed = {item};
    RunRig rig(artifactOf("handover"), settings);
    ASSERT_TRUE(rig.trial->start());
    expectRefusal(rig, own_error::kSettingDiffers, item);
  }
}

TEST(TheGate, refusesAFrameThatLeavesTheNodeBehindIt) {
  expectRefusalOf([](Departure& departure) { departure.leaves_node = true; }, own_error::kNotInArtifact,
                  "is permitted");
}

TEST(TheGate, refusesAFrameWithAnotherTcpOrBase) {
  expectRefusalOf([](Departure& departure) { departure.tcp.translation().z() += 0.0002; },
                  own_error::kSettingDiffers, "the TCP differs from the one in the cell");
  expectRefusalOf(
      [](Departure& departure) {
        departure.tcp.rotate(Eigen::AngleAxisd(degToRad(0.02), Eigen::Vector3d::UnitX()));
      },
      own_error::kSettingDiffers, "the TCP differs from the one in the cell");
  expectRefusalOf(
      [](Departure& departure) { departure.base = arm::Pose(Eigen::Translation3d(0.0, 0.0002, 0.0)); },
      own_error::kSettingDiffers, "the base differs from the one in the cell");
}

TEST(TheGate, refusesAFrameThatWouldStartOneDegreeOff) {
  expectRefusalOf([](Departure& departure) { (*departure.start)[3] += degToRad(1.0); },
                  own_error::kNotAtStepStart, "joint 4 would start 1.00 deg off; allowed: 0.10 deg");
  expectRefusalOf([](Departure& departure) { departure.planned = false; }, own_error::kNotAtStepStart,
                  "is unknown");
}

TEST(TheGate, refusesARobotThatStandsBesideItsStation) {
  RunRig rig(artifactOf("handover"));
  ASSERT_TRUE(rig.trial->start());
  // Near enough to be at home, too far for the path from there.
  rig.commandByOther(0, {"PTP(\"JPP\",0.3,-30,120,0,90,0,5,200,0,false)"});
  rig.pass(2s);
  expectRefusal(rig, own_error::kNotAtStepStart, "joint 1 would start 0.30 deg off");
}

TEST(TheGate, refusesAProjectThatIsFasterThanWhatWasProved) {
  RunRig rig(artifactOf("handover", [](cell::Parameters& parameters) { parameters.speed_override = 0.5; }));
  ASSERT_TRUE(rig.trial->start());
  rig.robot(0).operate(simulator::SetProjectSpeed{55});
  rig.pass(1s);
  expectRefusal(rig, own_error::kSettingDiffers,
                "the project speed is 55 %, but the cell was verified for at most 50 %");
}

TEST(ARobotInManualMode, sendsNothing) {
  RunRig rig(artifactOf("handover"));
  ASSERT_TRUE(rig.trial->start());
  rig.robot(0).operate(simulator::SetOperatingMode{simulator::OperatingMode::Manual});
  rig.pass(1s);
  rig.order(0, 1);
  rig.pass(5s);
  EXPECT_EQ(rig.robot(0).scripts().size(), 0U);
}

TEST(TheGate, refusesOnAStateThatIsOlderThanTheLease) {
  RunRig rig(artifactOf("handover"));
  ASSERT_TRUE(rig.trial->start());
  rig.trial->killSupervisor();
  rig.pass(600ms);
  expectRefusal(rig, own_error::kSupervisorSilent, "no message of the supervisor for 0.6 s");
}

TEST(TheGate, refusesWhatIsNoProgram) {
  RunRig rig(artifactOf("handover"));
  ASSERT_TRUE(rig.trial->start());
  blocks::MoveAbsoluteGoal goal;
  goal.movement_command = static_cast<int>(blocks::Movement::Ptp);
  goal.data_format = static_cast<int>(blocks::AbsoluteFormat::Jpp);
  goal.target = {0, -30, 120, 0, 90, 5};
  goal.speed = 20;
  goal.accel_time = 300;
  static_cast<void>(rig.robot(0).submit(goal));
  ASSERT_TRUE(rig.passUntil([&] { return rig.robot(0).hasEnded(); }, 2s));
  EXPECT_EQ(rig.errorOf(0), own_error::kOnlyPrograms);
  EXPECT_EQ(rig.robot(0).scripts().size(), 0U);
}

TEST(ATagThatComesEarly, releasesNothingBeforeTheMeasurement) {
  RunRig rig(artifactOf("handover"));
  rig.begin(1);
  ASSERT_TRUE(rig.goesInto(0, 0));
  // The one behind the way back, on which the zone is left.
  rig.robot(0).operate(simulator::SetFault{"early_tag", true, 1, 0, ""});
  ASSERT_TRUE(rig.passUntil([&] { return rig.robot(0).hasEnded(); }));
  EXPECT_EQ(rig.robot(0).lastOutcome()->ending, blocks::Ending::Aborted);
  EXPECT_TRUE(rig.isIn(0, 0));
  rig.pass(20s);
  EXPECT_EQ(rig.zone(0).owner, "RA");
  EXPECT_FALSE(rig.isIn(1, 0));
  const auto recovered = rig.supervision().recover("RA", rig.of(0).place, "me", rig.trial->now());
  ASSERT_TRUE(recovered.success) << recovered.message;
  rig.pass(1s);
  rig.order(0, 1);
  EXPECT_TRUE(rig.endsAll());
}

TEST(AStreamThatIsFrozen, releasesNothingAndPermitsNothing) {
  RunRig rig(artifactOf("handover"));
  rig.begin(1);
  // On the way back, before it is out.
  ASSERT_TRUE(rig.passUntil([&] { return rig.of(0).place == "BACK>" && rig.isMoving(0) && rig.isIn(0, 0); }));
  rig.robot(0).operate(simulator::SetFault{"drop_stream", true, 0, 0, ""});
  ASSERT_TRUE(rig.passUntil([&] { return !rig.isMoving(0); }));
  const std::size_t sent = rig.robot(0).scripts().size();
  rig.pass(10s);
  EXPECT_FALSE(rig.isIn(0, 0)) << "and nobody knows";
  EXPECT_EQ(rig.zone(0).owner, "RA");
  EXPECT_FALSE(rig.isIn(1, 0));
  EXPECT_EQ(rig.robot(0).scripts().size(), sent);
  EXPECT_NE(rig.of(0).state, cell::RobotState::Lost) << "its reports go on";
  rig.robot(0).operate(simulator::SetFault{"drop_stream", false, 0, 0, ""});
  EXPECT_TRUE(rig.passUntil([&] { return rig.zone(0).owner != "RA"; }, 5s));
  EXPECT_TRUE(rig.ends(1));
}

}  // namespace
}  // namespace cobot_command::trial
