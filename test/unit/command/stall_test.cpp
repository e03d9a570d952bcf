// A motion that somebody else ends: the robot stands away from the target, and nobody reports it. Standing
// alone says little, so the controller is asked.

#include <functional>

#include "core_rig.h"
#include "motion_goals.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using protocol::TagState;
using ::testing::AllOf;
using ::testing::HasSubstr;

StatusFrames at(float j1) {
  return StatusFrames().at({j1, 0, 90, 0, 90, 0});
}
StatusFrames passing(float j1) {
  return at(j1).moving();
}

MoveAbsoluteGoal toJoints(double j1) {
  return moveJoints({j1, 0, 90, 0, 90, 0}, 5);
}

class Stall : public ::testing::Test {
 protected:
  Stall() : rig(*arm::ArmModel::named("tm5-900"), link::LinkSettings{}) {
    rig.connect();
    rig.status(StatusFrames());
  }
  /// A motion of some seconds that was accepted, and is seen on its way.
  GoalId moving(const Goal& goal = toJoints(60)) {
    const GoalId id = rig.submit(goal);
    rig.reply(rig.takeScript().id);
    stream(150ms, passing(10));
    return id;
  }
  void stream(Duration duration, const StatusFrames& frame, Duration period = 15ms) {
    rig.streamFor(duration, frame, period);
  }
  /// It stands where it is, until it is asked for; within `patience`.
  void expectQuestion(Duration patience = 600ms) {
    const Instant end = rig.now + patience;
    while (rig.nothingSent() && rig.now < end) stream(15ms, at(20));
    EXPECT_EQ(rig.takeTagQuery().tag, 1);
  }
  void expectStop() { EXPECT_EQ(rig.takeScript().script, "StopAndClearBuffer()"); }
  CoreRig rig;
};

TEST_F(Stall, isAnErrorOnceTheControllerHasDroppedTheTag) {
  const GoalId id = moving();
  expectQuestion();
  rig.tag(1, TagState::Unknown);
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Aborted);
  EXPECT_EQ(rig.outcome(id)->error_id, own_error::kStoppedElsewhere);
  EXPECT_THAT(rig.outcome(id)->error_description,
              AllOf(HasSubstr("J1 is 40.00 deg from its target"), HasSubstr("no longer knows tag 1"),
                    HasSubstr("another client")));
  EXPECT_THAT(rig.outcome(id)->remedy, HasSubstr("~stop_orphaned_motion"));
  expectStop();
}

/// Nobody could plan it, so its tag is due after five minutes only.
TEST(StallWithoutAModel, isFoundInASecondAsWell) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  rig.connect();
  rig.status(StatusFrames());
  RunScriptGoal script;
  script.script = "float[] now = Robot[0].Joint\r\nPTP(\"CPP\",400,0,300,180,0,90,10,200,0,false)";
  script.await_motion = true;
  const GoalId id = rig.submit(script);
  rig.reply(rig.takeScript().id);
  rig.status(passing(10));
  for (int i = 0; i < 60 && rig.nothingSent(); ++i) {
    rig.pass(15ms);
    rig.status(at(20));
  }
  EXPECT_EQ(rig.takeTagQuery().tag, 1);
  rig.tag(1, TagState::Unknown);
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->error_id, own_error::kStoppedElsewhere);
  rig.discardSent();
}

/// Behind a hold of another client's, for example: the controller has the motion still.
TEST_F(Stall, isNoErrorAsLongAsTheControllerHasTheTag) {
  const GoalId id = moving();
  for (int i = 0; i < 3; ++i) {
    expectQuestion();
    rig.tag(1, TagState::Incomplete);
    EXPECT_EQ(rig.outcome(id), nullptr);
  }
  stream(300ms, passing(50));
  rig.tag(1);
  rig.status(at(60));
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Done) << rig.outcome(id)->error_description;
}

TEST_F(Stall, leavesTheDeadlineOfTheTagWhereItWas) {
  const GoalId id = moving();
  const Instant accepted = rig.now - 150ms;
  const Duration planned = *rig.progress(id).back().planned;
  const Instant due =
      accepted + fromSeconds(toSeconds(planned) * 1.5) + link::LinkSettings{}.tag_deadline_margin;
  while (rig.outcome(id) == nullptr && rig.now < due + 10s) {
    stream(15ms, at(20));
    for (std::size_t i = rig.takeAllSent().size(); i > 0; --i) rig.tag(1, TagState::Incomplete);
  }
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->error_id, motion_error::kMotionFailed);
  EXPECT_LT(rig.now - due, 100ms);
  EXPECT_GE(rig.now, due);
  rig.discardSent();
}

/// Who has stopped it uses the number for a motion of his own.
TEST_F(Stall, isAlsoFoundWhenTheNumberMeansAnothersMotion) {
  const GoalId id = moving();
  expectQuestion();
  rig.tag(1);
  stream(600ms, at(20));
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->error_id, own_error::kNotAtTarget);
  expectStop();
}

TEST_F(Stall, mayBeOverBeforeTheAnswer) {
  for (const auto& frame : {passing(21), at(20).paused()}) {
    const GoalId id = moving();
    const auto tag = rig.latest().open_tags.at(0);
    while (rig.nothingSent()) stream(15ms, at(20));
    EXPECT_EQ(rig.takeTagQuery().tag, tag);
    rig.status(frame);
    rig.tag(tag, TagState::Unknown);
    EXPECT_EQ(rig.outcome(id), nullptr);
    rig.tag(tag);
    rig.status(at(60));
    ASSERT_NE(rig.outcome(id), nullptr);
    EXPECT_EQ(rig.outcome(id)->ending, Ending::Done);
    rig.status(at(0));
  }
}

TEST_F(Stall, isLeftToTheDeadlineWhenTheQuestionGetsNoAnswer) {
  const GoalId id = moving();
  expectQuestion();
  rig.answers_lifesigns = false;
  stream(1100ms, passing(30));
  EXPECT_EQ(rig.outcome(id), nullptr);
  rig.tag(1, TagState::Incomplete);  // the answer, late: it reads like the report of a motion that failed
  EXPECT_EQ(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.latest().late_replies, 1U);
  stream(100ms, passing(31));
  EXPECT_EQ(rig.outcome(id), nullptr);
  rig.tag(1);
  rig.status(at(60));
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Done);
  rig.discardSent();  // lifesigns
}

TEST_F(Stall, canBeCancelledWhileTheControllerIsAsked) {
  const GoalId id = moving();
  expectQuestion();
  rig.cancel(id);
  rig.reply(rig.takeScript().id);
  rig.stream(at(20));
  EXPECT_EQ(rig.outcome(id)->ending, Ending::CommandAborted);
}

// --- What stands for good reasons is not asked for before its deadline.

TEST_F(Stall, isNoPauseAndNoSafeguard) {
  const StatusFrames kHeld[] = {at(20).paused(), at(20).with(protocol::item::ofBool("Safeguard_A", true))};
  for (const StatusFrames& frame : kHeld) {
    const GoalId id = moving();
    stream(60s, frame, 100ms);
    EXPECT_TRUE(rig.nothingSent());
    stream(400ms, at(20));  // released, and it has to get going
    EXPECT_TRUE(rig.nothingSent());
    rig.tag(rig.latest().open_tags.at(0));
    rig.status(at(60));
    EXPECT_EQ(rig.outcome(id)->ending, Ending::Done);
    rig.status(at(0));
  }
}

TEST_F(Stall, isNoMotionThatHasNotBegun) {
  const GoalId id = rig.submit(toJoints(60));
  rig.reply(rig.takeScript().id);
  stream(3s, at(0));
  EXPECT_TRUE(rig.nothingSent());
  EXPECT_EQ(rig.outcome(id), nullptr);
  rig.shutDown();
  rig.discardSent();
}

TEST_F(Stall, isNoRobotAtItsTarget) {
  moving();
  stream(2s, at(60));
  EXPECT_TRUE(rig.nothingSent()) << "a tag may take its time";
  rig.shutDown();
  rig.discardSent();
}

/// At 0.05 deg/s every joint counts as standing.
TEST_F(Stall, isNoSlowMotion) {
  moving();
  for (int i = 0; i < 150; ++i) stream(15ms, at(20 + static_cast<float>(i) * 0.05F * 0.015F));
  EXPECT_TRUE(rig.nothingSent());
  rig.shutDown();
  rig.discardSent();
}

TEST_F(Stall, isNotSeenInAStreamThatHangs) {
  moving();
  for (int i = 0; i < 3; ++i) stream(15ms, at(20));
  rig.pass(800ms);
  rig.status(at(20));
  EXPECT_TRUE(rig.nothingSent()) << "four frames";
  rig.shutDown();
  rig.discardSent();
}

TEST_F(Stall, isNotSeenWithoutJointAngles) {
  rig.status(StatusFrames().without("Joint_Angle").moving());
  const GoalId id = rig.submit(toJoints(60));
  rig.reply(rig.takeScript().id);
  rig.status(StatusFrames().without("Joint_Angle").moving());
  stream(5s, StatusFrames().without("Joint_Angle"));
  EXPECT_TRUE(rig.nothingSent());
  EXPECT_EQ(rig.outcome(id), nullptr);
  rig.shutDown();
  rig.discardSent();
}

}  // namespace
}  // namespace cobot_command::testing
