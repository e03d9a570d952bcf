// A motion is done when its tag came back and the status stream shows the robot standing at its target.
//
// A tag is a number of 1 to 15 that every client of the controller hears: it may be another's.

#include "block_goals.h"
#include "core_rig.h"
#include "motion_goals.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::HasSubstr;
namespace item = protocol::item;

using Joints = std::vector<float>;
const Joints kHome{0, 0, 90, 0, 90, 0};
const Joints kAside{60, 0, 90, 0, 90, 0};

StatusFrames at(const Joints& joints) {
  return StatusFrames().at(joints);
}
StatusFrames passing(const Joints& joints) {
  return StatusFrames().at(joints).moving();
}

class Evidence : public ::testing::Test {
 protected:
  explicit Evidence(const link::LinkSettings& settings = {})
      : rig(*arm::ArmModel::named("tm5-900"), settings) {
    rig.connect();
    rig.status(StatusFrames());
  }
  /// A motion that was accepted.
  GoalId moving(const Goal& goal = moveJoints({60, 0, 90, 0, 90, 0})) {
    const GoalId id = rig.submit(goal);
    rig.reply(rig.takeScript().id);
    return id;
  }
  /// Lets time pass while the status stream goes on.
  void stream(Duration duration, const StatusFrames& frame) { rig.streamFor(duration, frame); }
  void expectDone(GoalId id) {
    ASSERT_NE(rig.outcome(id), nullptr);
    EXPECT_EQ(rig.outcome(id)->ending, Ending::Done) << rig.outcome(id)->error_description;
  }
  void expectNotReached(GoalId id, const std::string& words) {
    ASSERT_NE(rig.outcome(id), nullptr);
    EXPECT_EQ(rig.outcome(id)->ending, Ending::Aborted);
    EXPECT_EQ(rig.outcome(id)->error_id, own_error::kNotAtTarget);
    EXPECT_THAT(rig.outcome(id)->error_description, HasSubstr(words));
    EXPECT_EQ(rig.takeScript().script, "StopAndClearBuffer()");
  }
  CoreRig rig;
};

TEST_F(Evidence, isTheFirstFrameBehindTheTag) {
  const GoalId id = moving();
  rig.status(passing({59.9F, 0, 90, 0, 90, 0}));
  rig.pass(900ms);
  rig.tag(1);
  EXPECT_EQ(rig.outcome(id), nullptr);
  EXPECT_TRUE(rig.outputs(kBlock<MoveAbsoluteGoal>).busy);
  rig.pass(5ms);
  rig.status(at(kAside));
  expectDone(id);
  EXPECT_NEAR((*rig.outcome(id)->final_joints_deg)[0], 60, 1e-6) << "of the frame behind the tag";
  EXPECT_EQ(rig.outcome(id)->actual, 900ms) << "the wait for it is no part of the motion";
}

/// Two command nodes on one controller that have both taken tag 1.
TEST_F(Evidence, againstATagThatWasAnothersIsAnError) {
  const GoalId id = moving();
  stream(300ms, passing({20, 0, 90, 0, 90, 0}));
  rig.tag(1);
  stream(510ms, passing({14.5F, 0, 90, 0, 90, 0}));
  EXPECT_EQ(rig.outcome(id), nullptr);
  stream(15ms, passing({14, 0, 90, 0, 90, 0}));
  expectNotReached(id, "tag 1 was reported complete, but J1 is 45.50 deg from its target");
}

TEST_F(Evidence, isAlsoAskedForWhenTheTagComesBeforeTheReply) {
  const GoalId id = rig.submit(moveJoints({60, 0, 90, 0, 90, 0}));
  const auto script = rig.takeScript();
  rig.tag(1);
  rig.reply(script.id);
  EXPECT_EQ(rig.outcome(id), nullptr);
  stream(600ms, passing({1, 0, 90, 0, 90, 0}));
  expectNotReached(id, "J1 is 59.00 deg");
}

/// Somebody else has stopped the robot, and used the number for a motion of his own.
TEST_F(Evidence, isAskedForWhenTheAnswerToTheOverdueTagIsTrue) {
  const GoalId id = moving();
  for (int i = 0; i < 1000 && rig.nothingSent(); ++i) stream(15ms, at({10, 0, 90, 0, 90, 0}));
  EXPECT_EQ(rig.takeTagQuery().tag, 1);
  rig.tag(1);
  EXPECT_EQ(rig.outcome(id), nullptr);
  stream(600ms, at({10, 0, 90, 0, 90, 0}));
  expectNotReached(id, "J1 is 50.00 deg");
}

TEST_F(Evidence, mayBeAFewFramesBehind) {
  const GoalId id = moving();
  rig.tag(1);
  stream(300ms, passing({58, 0, 90, 0, 90, 0}));
  EXPECT_EQ(rig.outcome(id), nullptr);
  rig.status(at(kAside));
  expectDone(id);
}

TEST_F(Evidence, isWaitedForWhileTheStreamHangs) {
  const GoalId id = moving();
  rig.tag(1);
  rig.pass(900ms);
  EXPECT_EQ(rig.outcome(id), nullptr);
  rig.status(passing({30, 0, 90, 0, 90, 0}));
  rig.status(at(kAside));
  expectDone(id);
}

TEST_F(Evidence, isNotToBeHadFromAStreamThatStopped) {
  const GoalId id = moving();
  rig.tag(1);
  rig.close("gone", link::Channel::Status);
  expectDone(id);
}

TEST_F(Evidence, isNotToBeHadFromAStreamWithoutJoints) {
  rig.status(StatusFrames().without("Joint_Angle").without("Joint_Speed"));
  const GoalId id = moving();
  rig.tag(1);
  expectDone(id);
}

TEST_F(Evidence, againstItTheMotionCanBeCancelled) {
  const GoalId id = moving();
  rig.tag(1);
  rig.cancel(id);
  const auto stop = rig.takeScript();
  EXPECT_EQ(stop.script, "StopAndClearBuffer()");
  rig.reply(stop.id);
  rig.stream(at({3, 0, 90, 0, 90, 0}));
  EXPECT_EQ(rig.outcome(id)->ending, Ending::CommandAborted);
}

TEST_F(Evidence, isOvertakenByAnEmergencyStop) {
  const GoalId id = moving();
  rig.tag(1);
  rig.status(passing(kHome).emergencyStop());
  EXPECT_EQ(rig.outcome(id)->error_id, motion_error::kLinkDropped);
  EXPECT_THAT(rig.outcome(id)->error_description, HasSubstr("emergency stop"));
  rig.discardSent();
}

/// The tag was right, and behind it another client's motion has begun: to stop that is not this goal's
/// business.
TEST_F(Evidence, isThatTheRobotWasThereAlsoWhenItMovesOn) {
  const GoalId id = moving();
  rig.tag(1);
  rig.status(passing({59.95F, 0, 90, 0, 90, 0}));
  stream(600ms, passing({40, 0, 90, 0, 90, 0}));
  expectDone(id);
  EXPECT_TRUE(rig.nothingSent());
}

/// Where the robot is now is of another motion.
TEST_F(Evidence, thatItWasThereIsWhatTheResultTells) {
  const Goal path = with<LoadPathGoal>([](auto& g) { g.number_of_moves = 1; });
  const Goal trajectory = with<FollowJointTrajectoryGoal>([](auto& g) { g.path_tolerance.fill(-1); });
  for (const Goal& goal : {Goal(moveJoints({10, 0, 90, 0, 90, 0})), path, trajectory}) {
    SCOPED_TRACE(toString(blockOf(goal)));
    rig.status(at(kHome));
    const GoalId id = moving(goal);
    stream(300ms, passing({5, 0, 90, 0, 90, 0}));
    rig.tag(rig.latest().open_tags.at(0));
    rig.status(passing({9.96F, 0, 90, 0, 90, 0}));
    rig.status(passing({10.03F, 0, 90, 0, 90, 0}));
    stream(600ms, passing({25, 0, 90, 0, 90, 0}));
    expectDone(id);
    ASSERT_TRUE(rig.outcome(id) && rig.outcome(id)->final_joints_deg);
    EXPECT_NEAR((*rig.outcome(id)->final_joints_deg)[0], 9.96, 1e-4);
    rig.stream(at(kHome));
  }
}

/// What was there first, and stands there then, is told as it stands.
TEST_F(Evidence, thatItStandsThereIsWhatTheResultTells) {
  const GoalId id = moving();
  rig.tag(1);
  rig.status(passing({59.93F, 0, 90, 0, 90, 0}));
  rig.status(at(kAside));
  expectDone(id);
  EXPECT_NEAR((*rig.outcome(id)->final_joints_deg)[0], 60, 1e-4);
}

/// To be there says nothing then.
TEST_F(Evidence, ofAMotionThatEndsWhereItBeganIsThatItStands) {
  const GoalId id = moving(moveJoints({0, 0, 90, 0, 90, 0}));
  rig.tag(1);
  rig.status(passing(kHome));
  stream(600ms, passing(kHome));
  expectNotReached(id, "still moves");
}

TEST_F(Evidence, ofAMotionThatCouldNotBePlannedIsThatItStands) {
  rig.status(passing(kHome));  // where it will start nobody knows
  const GoalId id = moving(CoreRig::move());
  rig.tag(1);
  rig.status(passing(kHome));
  EXPECT_EQ(rig.outcome(id), nullptr);
  rig.status(at(kHome));
  expectDone(id);
  rig.status(passing(kHome));
  const GoalId next = moving(CoreRig::move());
  rig.tag(rig.latest().open_tags.at(0));
  stream(600ms, passing(kAside));
  expectNotReached(next, "still moves");
}

TEST_F(Evidence, ofAMotionToJointsIsThatItStandsThereAlsoWhereItCouldNotBePlanned) {
  rig.status(passing(kHome));
  const GoalId id = moving();
  rig.tag(1);
  stream(600ms, at(kHome));
  expectNotReached(id, "J1 is 60.00 deg");
}

TEST(EvidenceWithoutAModel, isKnownOfJoints) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  rig.connect();
  rig.status(StatusFrames());
  const GoalId id = rig.submit(moveJoints({60, 0, 90, 0, 90, 0}));
  rig.reply(rig.takeScript().id);
  rig.tag(1);
  rig.status(at(kHome));
  EXPECT_EQ(rig.outcome(id), nullptr);
  rig.status(at(kAside));
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Done);
}

TEST_F(Evidence, ofAScriptThatSetsVelocitiesIsItsTag) {
  RunScriptGoal script;
  script.script = "ContinueVJog()\r\nSetContinueVJog(10,0,0,0,0,0)";
  script.await_motion = true;
  const GoalId id = moving(script);
  rig.status(passing(kHome));
  rig.tag(1);
  expectDone(id);
  stream(2s, passing(kHome));
  EXPECT_EQ(rig.latest().diagnosis.find("no command of this node is running"), std::string::npos)
      << "that is ours";
}

TEST_F(Evidence, isNoBusinessOfABlendedMotion) {
  MoveAbsoluteGoal goal = moveJoints({60, 0, 90, 0, 90, 0});
  goal.blending_enable = true;
  expectDone(moving(goal));
}

TEST_F(Evidence, comesBeforeTheListenNodeIsLeft) {
  MoveAbsoluteGoal goal = moveJoints({60, 0, 90, 0, 90, 0});
  goal.exit_node = true;
  const GoalId id = moving(goal);
  rig.tag(1);
  EXPECT_TRUE(rig.nothingSent());
  rig.status(at(kAside));
  const auto exit = rig.takeScript();
  EXPECT_EQ(exit.script, "ScriptExit()");
  rig.reply(exit.id);
  expectDone(id);
}

TEST_F(Evidence, isTakenFromJointAnglesWhereNoSpeedsAreStreamed) {
  const auto bare = [](float j1) { return at({j1, 0, 90, 0, 90, 0}).without("Joint_Speed"); };
  const GoalId id = moving();
  rig.tag(1);
  for (const float j1 : {59.8F, 59.92F, 59.97F, 60.0F}) stream(15ms, bare(j1));
  EXPECT_EQ(rig.outcome(id), nullptr) << "it may still be on its way";
  stream(330ms, bare(60));
  expectDone(id);
}

/// Two frames alone may have been on their way together.
TEST_F(Evidence, thatItStandsIsAwaitedUntilASlowStreamWithoutSpeedsCanTellIt) {
  for (const bool stands : {true, false}) {
    rig.status(passing(kHome));  // where it will start nobody knows, nor then where it will end
    const GoalId id = moving(CoreRig::move());
    const auto slowly = [&](float j1) {
      rig.status(at({j1, 0, 90, 0, 90, 0}).without("Joint_Speed"));
      rig.pass(700ms);
    };
    rig.close("gone", link::Channel::Status);
    rig.pass(100ms);
    rig.open(link::Channel::Status);
    slowly(20);
    rig.tag(rig.latest().open_tags.at(0));
    slowly(20);
    EXPECT_EQ(rig.outcome(id), nullptr) << "half a second behind the first frame since the tag";
    slowly(stands ? 20 : 25);
    if (stands) {
      expectDone(id);
    } else {
      expectNotReached(id, "still moves");
      rig.pass(1s);  // nobody answers the stop
    }
  }
}

// --- Poses.

class PoseEvidence : public Evidence {
 protected:
  /// What an arm streams that stands `miss` mm from where its model has it; joints as the model wants them.
  static StatusFrames frame(const std::array<double, 6>& joints_deg, double calibration = 0,
                            double miss = 0) {
    const auto arm = *arm::ArmModel::named("tm5-900");
    arm::Pose tool = arm::forwardKinematics(arm, arm::toJointVector(joints_deg));
    tool.translation().x() += (calibration + miss) * 1e-3;
    const auto numbers = arm::toControllerPose(tool);
    return StatusFrames()
        .at(Joints(joints_deg.begin(), joints_deg.end()))
        .with(item::ofFloats("Coord_Robot_Tool", {numbers.begin(), numbers.end()}))
        .with(item::ofFloats("Base_Value", {0, 0, 0, 0, 0, 0}))
        .with(item::ofFloats("TCP_Value", {0, 0, 0, 0, 0, 0}));
  }
  static constexpr std::array<double, 6> kStart{0, 0, 90, 0, 90, 0};
  static constexpr std::array<double, 6> kTurned{30, 10, 80, 0, 90, 0};

  static MoveAbsoluteGoal toPose() {
    MoveAbsoluteGoal goal = CoreRig::move();
    goal.target = arm::toControllerPose(
        arm::forwardKinematics(*arm::ArmModel::named("tm5-900"), arm::toJointVector(kTurned)));
    return goal;
  }
  static MoveRelativeGoal up() {
    MoveRelativeGoal goal;
    goal.movement_command = static_cast<int>(Movement::Line);
    goal.target = {0, 0, 50, 0, 0, 0};
    goal.speed = 50;
    goal.accel_time = 200;
    return goal;
  }
  /// Where the model has the joints behind up().
  static std::array<double, 6> joints(const Outcome& planned) {
    std::array<double, 6> degrees{};
    for (std::size_t i = 0; i < 6; ++i) {
      degrees[i] = radToDeg(planned.detail.as<CheckedMotion>().joint_path.back().joints[i]);
    }
    return degrees;
  }
};

/// The joints of a calibrated arm are not those of the model, but the tool is where it was sent.
TEST_F(PoseEvidence, isThePoseOfTheToolNotTheJointsOfTheModel) {
  rig.status(frame(kStart, 4));
  const GoalId id = moving(toPose());
  rig.tag(1);
  rig.status(frame(kTurned).at({30.3F, 10.2F, 79.7F, 0, 90, 0}));
  expectDone(id);
}

TEST_F(PoseEvidence, isHeldAgainstTheToleranceOfTheSettings) {
  for (const double miss : {0.9, 1.1}) {
    rig.status(frame(kStart));
    const GoalId id = moving(toPose());
    rig.tag(rig.latest().open_tags.at(0));
    stream(600ms, frame(kTurned, 0, miss));
    if (miss < 1) {
      expectDone(id);
    } else {
      expectNotReached(id, "the TCP is 1.10 mm and 0.00 deg from its target");
    }
  }
}

/// What was planned from where the robot stood has the error of the model in it.
TEST_F(PoseEvidence, ofAnOffsetAllowsForTheCalibrationOfAnArmThatShowsOne) {
  for (const double calibration : {4.0, 0.0}) {
    rig.status(frame(kStart, calibration));
    MoveRelativeGoal checked = up();
    checked.check_only = true;
    auto end = joints(*rig.outcome(rig.submit(checked)));
    end[0] += 0.5;  // some millimetres
    const GoalId id = moving(up());
    rig.tag(rig.latest().open_tags.at(0));
    stream(600ms, frame(end, calibration));
    if (calibration == 0) {
      expectNotReached(id, "the TCP is 4.");
    } else {
      expectDone(id);
    }
  }
}

/// Nobody knows in which base the controller has taken the target: its joints, and its place, are not
/// certain.
TEST_F(PoseEvidence, isThatItStandsWhereTheStreamTellsNoBase) {
  rig.status(frame(kStart).without("Base_Value"));
  const GoalId id = moving(toPose());
  rig.tag(1);
  rig.status(frame({1, 0, 90, 0, 90, 0}).without("Base_Value"));
  expectDone(id);
}

}  // namespace
}  // namespace cobot_command::testing
