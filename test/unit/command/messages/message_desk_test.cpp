// What of goals, link and robot becomes a message, once, and until when it is pending.
#include "core_rig.h"
#include "status_frames.h"
#include <gmock/gmock.h>

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::HasSubstr;

MoveAbsoluteGoal tooFast() {
  MoveAbsoluteGoal goal = CoreRig::move();
  goal.speed = 101;
  return goal;
}

class Messages : public ::testing::Test {
 protected:
  Messages() : rig(std::nullopt, link::LinkSettings()) {
    rig.connect();
    show(StatusFrames().whole());
    rig.messages.clear();  // of the frame that it was connected with
  }
  [[nodiscard]] std::vector<int> pendingCodes() const {
    std::vector<int> codes;
    for (const Message& message : rig.pending_messages) codes.push_back(message.code);
    return codes;
  }
  void show(StatusFrames frame) { rig.status(frame.whole()); }

  CoreRig rig;
};

TEST_F(Messages, tellOnceWhatTheStatusStreamShouldHaveAndUntilItHas) {
  for (int i = 0; i < 3; ++i) rig.status(StatusFrames().whole().without("ESTOP").without("MA_Mode"));
  ASSERT_EQ(rig.messages.size(), 1U);
  EXPECT_EQ(rig.messages[0].severity, Severity::Warning);
  EXPECT_EQ(rig.messages[0].origin, "status_stream");
  EXPECT_THAT(rig.messages[0].text, HasSubstr("does not have ESTOP (an emergency stop is not detected"));
  EXPECT_THAT(rig.messages[0].text, HasSubstr("MA_Mode ("));
  EXPECT_EQ(rig.pending_messages.size(), 1U);
  rig.status(StatusFrames().whole().without("MA_Mode"));
  EXPECT_EQ(rig.messages.size(), 2U) << "in other words it is another one";
  EXPECT_EQ(rig.pending_messages.size(), 1U);
  show(StatusFrames());
  EXPECT_TRUE(rig.pending_messages.empty());
}

/// With another model every pose is reached elsewhere, and every motion succeeds.
TEST(MessagesOfAnArm, warnWhileTheControllerMovesAnotherOne) {
  CoreRig rig(*arm::ArmModel::named("tm5-900"), link::LinkSettings());
  rig.connect();
  const auto show = [&rig](const char* model) {
    rig.status(StatusFrames().whole().with(protocol::item::ofString("Robot_Model", model)));
  };
  for (const char* same : {"TM5-900", "TM5X-900", "TM5M-900", "tm5-900"}) {
    show(same);
    EXPECT_TRUE(rig.pending_messages.empty()) << same;
  }
  rig.messages.clear();
  for (int i = 0; i < 3; ++i) show("TM12");
  ASSERT_EQ(rig.messages.size(), 1U);
  EXPECT_EQ(rig.messages[0].severity, Severity::Warning);
  EXPECT_THAT(rig.messages[0].text, HasSubstr("moves a TM12, but this node plans for a tm5-900"));
  EXPECT_THAT(rig.messages[0].remedy, HasSubstr("~robot_model"));
  EXPECT_EQ(rig.pending_messages.size(), 1U);
  for (const char* other : {"TM5-700", "TM12S", "TM14"}) {
    show(other);
    EXPECT_EQ(rig.pending_messages.size(), 1U) << other;
  }
  show("TM5-900");
  EXPECT_TRUE(rig.pending_messages.empty());
}

TEST_F(Messages, tellOfAScriptThatTheControllerTakesWithAWarning) {
  RunScriptGoal script;
  script.script = "var_i++\r\nvar_j++";
  const GoalId id = rig.submit(script);
  rig.reply(rig.takeScript().id, true, {2});
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Done);
  EXPECT_THAT(rig.outcome(id)->error_description, HasSubstr("the controller warns of line 2: var_j++"));
  ASSERT_EQ(rig.messages.size(), 1U);
  EXPECT_EQ(rig.messages[0].severity, Severity::Warning);
  EXPECT_EQ(rig.messages[0].text, "the controller warns of line 2: var_j++");
  EXPECT_TRUE(rig.pending_messages.empty()) << "it has no end that could be awaited";
}

TEST_F(Messages, tellTheErrorOfAGoal) {
  const GoalId id = rig.submit(tooFast());
  ASSERT_EQ(rig.messages.size(), 1U);
  const Message& message = rig.messages.front();
  const Outcome& outcome = *rig.outcome(id);
  EXPECT_EQ(message.severity, Severity::Error);
  EXPECT_EQ(message.type, MessageType::Command);
  EXPECT_EQ(message.code, outcome.error_id);
  EXPECT_EQ(message.origin, "move_absolute");
  EXPECT_EQ(message.text, outcome.error_description);
  EXPECT_EQ(message.remedy, outcome.remedy);
  EXPECT_TRUE(message.pending);
}

TEST_F(Messages, tellTheEndOfAGoalThatNeverCameToTheCore) {
  Outcome outcome;
  outcome.error_id = own_error::kFrameUnknown;
  outcome.error_description = "no frame";
  rig.core.tellEnd(kBlock<MoveCircleGoal>, outcome, rig.now);
  rig.pump();
  EXPECT_EQ(pendingCodes(), std::vector<int>({own_error::kFrameUnknown}));
  EXPECT_EQ(rig.messages[0].origin, "move_circle");
  EXPECT_EQ(rig.messages[0].time, rig.now);
}

/// SRCI oracle 22, first half.
TEST_F(Messages, ofAFailedGoalAreAcknowledgedByAReset) {
  rig.submit(tooFast());
  ASSERT_EQ(rig.pending_messages.size(), 1U);
  const ResetAnswer answer = rig.core.reset(rig.now);
  rig.pass(0ms);
  EXPECT_TRUE(answer.success);
  EXPECT_EQ(answer.acknowledged, 1);
  EXPECT_TRUE(rig.pending_messages.empty());
}

/// SRCI oracle 22, second half.
TEST_F(Messages, ofTheControllerStayAsLongAsItShowsItsError) {
  show(StatusFrames().error(0x13, "PTP"));
  show(StatusFrames().error(0x13, "PTP"));
  ASSERT_EQ(pendingCodes(), std::vector<int>({0x13}));
  EXPECT_EQ(rig.pending_messages[0].type, MessageType::Controller);
  const ResetAnswer refused = rig.core.reset(rig.now);
  rig.pass(0ms);
  EXPECT_FALSE(refused.success);
  EXPECT_THAT(refused.message, HasSubstr("0x13"));
  EXPECT_THAT(refused.message, HasSubstr("robot stick"));
  EXPECT_EQ(pendingCodes(), std::vector<int>({0x13}));
  show(StatusFrames());
  EXPECT_EQ(pendingCodes(), std::vector<int>({0x13})) << "until somebody has seen it";
  EXPECT_TRUE(rig.core.reset(rig.now).success);
  rig.pass(0ms);
  EXPECT_TRUE(rig.pending_messages.empty());
}

TEST_F(Messages, tellALostLinkOnce) {
  rig.close("the cable", link::Channel::Script);
  rig.pass(0ms);
  ASSERT_FALSE(rig.messages.empty());
  EXPECT_EQ(rig.messages[0].type, MessageType::Interface);
  EXPECT_EQ(rig.messages[0].code, 0x8AAD);
  EXPECT_THAT(rig.messages[0].text, HasSubstr("the cable"));
  rig.pass(1s);  // for the end of the connect goal, which is a message of its own
  const auto count = rig.messages.size();
  EXPECT_EQ(rig.messages.back().origin, "connect");
  for (int i = 0; i < 20; ++i) {
    rig.pass(5s);
    if (rig.pendingOpen(link::Channel::Script)) rig.failOpen(link::OpenFailure::Kind::Refused);
  }
  EXPECT_EQ(rig.messages.size(), count) << "a missing robot does not flood: " << rig.messages.back().text;
}

TEST_F(Messages, warnOfAnEmergencyStopUntilItIsReleased) {
  show(StatusFrames().emergencyStop());
  show(StatusFrames().emergencyStop());
  EXPECT_EQ(pendingCodes(), std::vector<int>({own_error::kEmergencyStop}));
  EXPECT_EQ(rig.messages.size(), 1U);
  EXPECT_EQ(rig.messages[0].severity, Severity::Warning);
  show(StatusFrames());
  EXPECT_TRUE(rig.pending_messages.empty());
}

TEST_F(Messages, warnOfAnEmergencyStopThatHasClosedTheLink) {
  rig.close("the peer", link::Channel::Script);
  show(StatusFrames().emergencyStop());
  EXPECT_THAT(pendingCodes(), ::testing::Contains(own_error::kEmergencyStop));
}

/// SRCI oracle 18.
TEST_F(Messages, warnOfAQueueThatIsNearlyFull) {
  const MoveAbsoluteGoal move = CoreRig::move(BufferMode::Buffered);
  for (int i = 0; i < 51; ++i) rig.submit(move);
  rig.discardSent();
  EXPECT_TRUE(rig.pending_messages.empty());
  const GoalId last = rig.submit(move);
  EXPECT_EQ(pendingCodes(), std::vector<int>({0x7A01}));
  EXPECT_THAT(rig.pending_messages[0].text, HasSubstr("80 %"));
  rig.cancel(last);
  EXPECT_TRUE(rig.pending_messages.empty());
}

TEST_F(Messages, areReadFromASeverityOn) {
  show(StatusFrames().emergencyStop());
  rig.submit(tooFast());
  const std::uint32_t before = rig.messages.front().id - 1;
  EXPECT_EQ(rig.core.messages(Severity::Off, before).size(), 2U);
  EXPECT_EQ(rig.core.messages(Severity::Error, before).size(), 1U);
  EXPECT_EQ(rig.core.messages(Severity::Off, rig.messages.back().id).size(), 0U);
}

}  // namespace
}  // namespace cobot_command::testing
