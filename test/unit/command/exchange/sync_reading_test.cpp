// What the values of the controller's project are read by, and what comes of answers that are late or wrong.
#include "exchange_rig.h"
#include <gmock/gmock.h>

#include "cobot_command/protocol/float_payload.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::HasSubstr;

class SyncReading : public ::testing::Test {
 protected:
  void SetUp() override {
    tables::Tool tool;
    tool.name = "gripper";
    tool.pose = arm::toPose({0, 0, 150, 0, 0, 0});
    ASSERT_TRUE(rig.core.writeTable({3, std::optional(tool)}));
    rig.connect();
    id = rig.exchangeWith([](ExchangeSettings& s) {
      s.data_enable_sync.tools = s.data_in_sync.tools = true;
      s.life_sign_time_out = 60000;
    });
  }
  /// The values that the oldest script asks for.
  void answer(float z) {
    const protocol::ScriptRequest request = rig.takeScript();
    const std::string mark = request.script.substr(0, request.script.find('\r'));
    const std::size_t begin = mark.find('"') + 1;
    rig.say(protocol::ListenData{99, mark.substr(begin, mark.rfind('"') - begin)});
    rig.say(protocol::ListenData{90, protocol::floatPayload({0, 0, z, 0, 0, 0})});
    rig.reply(request.id);
  }
  RiState state() { return rig.report(id).ri_state; }

  ExchangeRig rig;
  GoalId id = 0;
};

TEST_F(SyncReading, comparesWhatWasAnswered) {
  EXPECT_EQ(state(), RiState::Initialized) << "nothing is known yet";
  answer(150);
  EXPECT_EQ(state(), RiState::Synchronized);
  rig.pass(1s);
  answer(151);
  EXPECT_EQ(state(), RiState::Initialized);
}

TEST_F(SyncReading, believesWhatWasKnownUntilThreeQuestionsAreUnanswered) {
  answer(150);
  rig.pass(2500ms);
  EXPECT_EQ(rig.scripts_sent, 3);
  EXPECT_EQ(state(), RiState::Synchronized);
  rig.pass(4s);
  EXPECT_EQ(state(), RiState::Initialized);
  EXPECT_EQ(rig.report(id).warning_id, 0x7044);
  rig.discardSent();
  while (rig.nothingSent()) rig.pass(50ms);
  answer(150);
  EXPECT_EQ(state(), RiState::Synchronized);
  rig.discardSent();
}

TEST_F(SyncReading, takesOneRefusalForNothing) {
  answer(150);
  rig.update([](ExchangeSettings& s) {
    s.data_enable_sync.tools = s.data_in_sync.tools = true;
    s.life_sign_time_out = 60000;
    s.sync_delay = 0;
    s.sync_reaction = static_cast<int>(SyncReaction::InterruptAtOnce);
  });
  for (const auto& lines : {std::vector<int>{1}, {}, {99}}) {
    rig.pass(1s);
    rig.reply(rig.takeScript().id, false, lines);  // ListenSend itself, or no line of it
    EXPECT_EQ(state(), RiState::Synchronized);
    EXPECT_NE(rig.group_state.sequence, GroupState::Sequence::Interrupted);
    EXPECT_EQ(rig.report(id).warning_id, 0);
    rig.pass(1s);
    answer(150);
    EXPECT_EQ(state(), RiState::Synchronized);
  }
  EXPECT_TRUE(rig.messages.empty());
}

TEST_F(SyncReading, asksAControllerThatRefusesListenSendAgainAndTellsWhenItTakesIt) {
  for (int look = 0; look < 3; ++look) {
    EXPECT_EQ(rig.report(id).warning_id, 0) << look;
    rig.reply(rig.takeScript().id, false, {1});
    if (look < 2) rig.pass(1s);
  }
  EXPECT_EQ(rig.report(id).warning_id, 0x7044);
  ASSERT_EQ(rig.pending_messages.size(), 1U);
  EXPECT_THAT(rig.pending_messages[0].text, HasSubstr("refuses ListenSend()"));
  EXPECT_THAT(rig.pending_messages[0].remedy, HasSubstr("queried again automatically"));
  rig.pass(6900ms);
  EXPECT_TRUE(rig.nothingSent()) << "with every tenth look, as it does not have it";
  rig.pass(200ms);
  answer(150);
  EXPECT_EQ(state(), RiState::Synchronized);
  EXPECT_TRUE(rig.pending_messages.empty());
  EXPECT_EQ(rig.messages.back().severity, Severity::Info);
  EXPECT_THAT(rig.messages.back().text, HasSubstr("can be read again"));
  rig.pass(1s);
  answer(150);
}

TEST_F(SyncReading, waitsForTheScriptsOfGoals) {
  answer(150);
  const GoalId move = rig.submit(CoreRig::move());
  const std::string sent = rig.takeScript().id;
  rig.pass(900ms);
  EXPECT_TRUE(rig.nothingSent());
  rig.pass(90ms);
  rig.reply(sent);
  rig.pass(100ms);
  answer(150);
  EXPECT_EQ(rig.outcome(move), nullptr);
}

TEST_F(SyncReading, takesNumbersOfOthersForNobodys) {
  answer(150);
  rig.say(protocol::ListenData{90, "nonsense"});
  EXPECT_EQ(state(), RiState::Synchronized);
}

}  // namespace
}  // namespace cobot_command::testing
