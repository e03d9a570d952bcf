// The life of an exchange_configuration goal: SRCI oracles 1 to 6, 11 and 17.
#include "exchange_rig.h"
#include <gmock/gmock.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// SRCI oracle 1.
TEST(ExchangeConfiguration, isEnabledAtOnceOnALinkThatIsReady) {
  ExchangeRig rig;
  rig.connect();
  const GoalId id = rig.exchange();
  EXPECT_TRUE(rig.accepted(id));
  const ExchangeReport report = rig.report(id);
  EXPECT_TRUE(report.enabled && report.command_buffered && report.parameter_accepted);
  EXPECT_FALSE(report.busy);
  EXPECT_EQ(report.out_cmd.length_acr, 65);
  EXPECT_EQ(report.out_cmd.highest_tool_index, 15);
  EXPECT_EQ(report.out_cmd.highest_frame_index, 15);
  EXPECT_EQ(report.out_cmd.highest_load_index, 15);
  EXPECT_EQ(report.out_cmd.highest_work_area_index, 0);
  EXPECT_EQ(report.ri_state, RiState::Initialized);
  EXPECT_EQ(report.par_seq, 1);
  for (const char* name :
       {"work areas", "hours", "brake test", "step mode", "path accuracy", "singularity", "collision"}) {
    EXPECT_THAT(report.unsupported, Contains(HasSubstr(name)));
  }
  EXPECT_THAT(report.local_sets, Contains("reference_dynamics"));
}

/// SRCI oracle 2.
TEST(ExchangeConfiguration, endsWithACancelAndTheSettingsOfTheNodeHoldAgain) {
  ExchangeRig rig;
  rig.connect();
  const GoalId id = rig.exchange();
  rig.cancel(id);
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Done);
  const ExchangeReport told = rig.report(id);
  EXPECT_TRUE(told.busy && !told.enabled) << "what was told in front of the end";
  EXPECT_FALSE(rig.outputs(kBlock<ExchangeConfigurationGoal>).busy);
  const std::size_t before = rig.traces.size();
  rig.pass(10s);
  EXPECT_LE(rig.traces.size() - before, 2U * 11U) << "a question and an answer a second";
}

/// SRCI oracle 3.
TEST(ExchangeConfiguration, isRefusedByTheFirstRowThatIsViolated) {
  struct Row {
    std::function<void(ExchangeConfigurationGoal&)> change;
    int error_id;
  };
  using Goal = ExchangeConfigurationGoal;
  const std::vector<Row> rows = {
      {[](Goal& g) { g.name = "abcdefghijklmnopqrstu"; }, 8},
      {[](Goal& g) { g.name = "caf\xC3\xA9"; }, 8},
      {[](Goal& g) { g.priority = 5; }, 8},
      {[](Goal& g) { g.exec_mode = 18; }, 0x8F10},
      {[](Goal& g) { g.settings.log_level = 6; }, 0x8D18},
      {[](Goal& g) { g.settings.wait_for_nr_of_cmd = 65; }, 0x8D39},
      {[](Goal& g) { g.settings.delay_time = -1; }, 0x8D39},
      {[](Goal& g) { g.settings.life_sign_time_out = 9; }, 0x8D14},
      {[](Goal& g) { g.settings.life_sign_time_out = 0; }, 0x8D14},
      {[](Goal& g) { g.settings.sync_reaction = 4; }, 0x8D33},
      {[](Goal& g) { g.settings.wait_at_blending_zone = true; }, 0x8E21},
      {[](Goal& g) { g.settings.log_level = 6, g.settings.life_sign_time_out = 9; }, 0x8D18},
  };
  for (const Row& row : rows) {
    ExchangeRig rig;
    rig.connect();
    const GoalId id = rig.exchange(row.change);
    EXPECT_FALSE(rig.accepted(id));
    EXPECT_EQ(rig.errorOf(id), row.error_id);
    EXPECT_TRUE(rig.nothingSent());
    EXPECT_FALSE(rig.last(id).error_add_txt.empty());
    EXPECT_LE(rig.last(id).error_add_txt.size(), 40U);
    EXPECT_STRNE(srciNameOf(row.error_id), "");
  }
}

TEST(ExchangeConfiguration, takesTheShortestAndTheLongestLifeSign) {
  for (const int limit : {10, 65535}) {
    ExchangeRig rig;
    rig.connect();
    EXPECT_TRUE(rig.report(rig.exchangeWith([&](auto& s) { s.life_sign_time_out = limit; })).enabled);
  }
}

/// SRCI oracle 4.
TEST(ExchangeConfiguration, withoutALinkEndsAfterFiveSeconds) {
  ExchangeRig rig;
  const GoalId id = rig.exchange();
  EXPECT_TRUE(rig.report(id).busy);
  EXPECT_FALSE(rig.report(id).enabled);
  rig.pass(4900ms);
  EXPECT_EQ(rig.outcome(id), nullptr);
  rig.pass(200ms);
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Aborted);
  EXPECT_EQ(rig.errorOf(id), 6);
  EXPECT_EQ(rig.last(id).error_add_txt, "_stepCmd = 2");
}

/// SRCI oracle 4.
TEST(ExchangeConfiguration, waitsForALinkThatComesInTime) {
  ExchangeRig rig;
  const GoalId id = rig.exchange();
  rig.pass(3s);
  rig.connect();
  EXPECT_TRUE(rig.report(id).enabled);
  rig.pass(5s);
  EXPECT_EQ(rig.outcome(id), nullptr);
}

/// SRCI oracle 5.
TEST(ExchangeConfiguration, isThereOnlyOnce) {
  ExchangeRig rig;
  rig.connect();
  const GoalId first = rig.exchange();
  const GoalId second = rig.exchange();
  EXPECT_EQ(rig.errorOf(second), 0x8F12);
  EXPECT_EQ(rig.outcome(first), nullptr);
  EXPECT_TRUE(rig.report(first).enabled);
  EXPECT_TRUE(rig.outputs(kBlock<ExchangeConfigurationGoal>).busy);
}

TEST(ExchangeConfiguration, mayFollowOneThatHasEndedAndInheritsNothing) {
  ExchangeRig rig;
  rig.connect();
  const GoalId first = rig.exchange();
  rig.update([](auto& s) { s.life_sign_time_out = 400; });
  rig.cancel(first);
  const GoalId second = rig.exchange();
  EXPECT_TRUE(rig.report(second).enabled);
  EXPECT_EQ(rig.report(second).par_seq, 1);
  EXPECT_EQ(rig.progress(second).front().detail.as<ExchangeReport>().out_cmd.length_acr, 0);
}

/// SRCI oracle 6.
TEST(ExchangeConfiguration, takesOtherSettingsWhileItIsEnabled) {
  ExchangeRig rig;
  rig.connect();
  const GoalId id = rig.exchange();
  const std::size_t before = rig.progress(id).size();
  EXPECT_TRUE(rig.update([](auto& s) { s.life_sign_time_out = 400; }).success);
  std::vector<bool> accepted;
  for (std::size_t i = before; i < rig.progress(id).size(); ++i) {
    accepted.push_back(rig.progress(id)[i].detail.as<ExchangeReport>().parameter_accepted);
  }
  EXPECT_THAT(accepted, ElementsAre(false, true));
  EXPECT_EQ(rig.report(id).par_seq, 2);

  const ExchangeAnswer refused = rig.update([](auto& s) { s.life_sign_time_out = 9; });
  EXPECT_FALSE(refused.success);
  EXPECT_EQ(refused.error_id, 36116);
  EXPECT_THAT(refused.message, HasSubstr("9 ms"));
  EXPECT_EQ(rig.report(id).par_seq, 2);
  rig.answers_lifesigns = false;
  rig.pass(390ms);
  EXPECT_EQ(rig.outcome(id), nullptr) << "400 ms rule on";
  rig.pass(150ms);
  EXPECT_EQ(rig.errorOf(id), 0x80A5);
  rig.discardSent();
}

TEST(ExchangeConfiguration, takesNoSettingsWhileNothingIsEnabled) {
  ExchangeRig rig;
  EXPECT_EQ(rig.update([](auto&) {}).error_id, 0x8612);
  const GoalId id = rig.exchange();
  EXPECT_EQ(rig.update([](auto&) {}).error_id, 0x8612);
  EXPECT_EQ(rig.outcome(id), nullptr);
}

/// SRCI oracle 11.
TEST(ExchangeConfiguration, endsWithTheConnectionInTheEventOfTheGoals) {
  ExchangeRig rig;
  const GoalId connect = rig.connect();
  const GoalId id = rig.exchange();
  const GoalId move = rig.submit(CoreRig::move());
  rig.takeScript();
  rig.close("the cable");
  EXPECT_EQ(rig.errorOf(id), 0x8AAD);
  EXPECT_EQ(rig.errorOf(move), 0x99);
  EXPECT_EQ(rig.errorOf(connect), 0x90);
  rig.connect();
  EXPECT_EQ(rig.update([](auto&) {}).error_id, 0x8612) << "nothing is enabled by itself";
}

TEST(ExchangeConfiguration, endsWithAConnectGoalThatIsCancelled) {
  ExchangeRig rig;
  const GoalId connect = rig.connect();
  const GoalId id = rig.exchange();
  rig.cancel(connect);
  EXPECT_EQ(rig.errorOf(id), 0x8AAD);
}

TEST(ExchangeConfiguration, staysEnabledWhileTheFlowIsOutsideOfTheListenNode) {
  ExchangeRig rig;
  rig.connect();
  const GoalId id = rig.exchange();
  rig.listening = false;
  rig.pass(3s);
  EXPECT_EQ(rig.outcome(id), nullptr);
}

/// SRCI oracle 17.
TEST(ExchangeConfiguration, namesWhatIsWithoutEffect) {
  ExchangeRig rig;
  rig.connect();
  const GoalId id = rig.exchangeWith([](auto& s) { s.allow_sec_seq_while_subprogram = true; });
  EXPECT_TRUE(rig.report(id).enabled);
  EXPECT_THAT(rig.report(id).without_effect, ElementsAre("allow_sec_seq_while_subprogram"));
}

TEST(ExchangeConfiguration, warnsOfAQueueThatIsNearlyFull) {
  ExchangeRig rig;
  rig.connect();
  const GoalId id = rig.exchange();
  rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id);
  GoalId last = 0;
  for (int i = 0; i < 51; ++i) last = rig.submit(CoreRig::move(BufferMode::Buffered));
  rig.pass(200ms);
  EXPECT_EQ(rig.report(id).warning_id, 0x7A01);
  rig.cancel(last);
  rig.pass(200ms);
  EXPECT_EQ(rig.report(id).warning_id, 0);
  rig.discardSent();
}

TEST(ExchangeConfiguration, tellsItsStateEverySecond) {
  ExchangeRig rig;
  rig.connect();
  const GoalId id = rig.exchange();
  const std::size_t before = rig.progress(id).size();
  rig.pass(3500ms);
  EXPECT_EQ(rig.progress(id).size(), before + 3);
}

TEST(ExchangeConfiguration, keepsTheMessagesOfItsLogLevelAlone) {
  ExchangeRig rig;
  rig.connect();
  const GoalId id = rig.exchangeWith([](auto& s) { s.log_level = 29; });
  auto wrong = CoreRig::move();
  wrong.speed = 101;
  rig.submit(wrong);
  EXPECT_TRUE(rig.messages.empty());
  rig.cancel(id);
  rig.submit(wrong);
  EXPECT_EQ(rig.messages.size(), 1U);
}

TEST(ExchangeConfiguration, keepsWhatTheNodesSettingsBecomeForItsEnd) {
  ExchangeRig rig;
  rig.connect();
  const GoalId id = rig.exchangeWith([](auto& s) { s.life_sign_time_out = 65535; });
  link::LinkSettings settings = CoreRig::noStatus();
  settings.supervision_period = 50ms;
  settings.supervision_misses = 2;
  rig.core.useSettings(settings, rig.now);
  rig.answers_lifesigns = false;
  rig.pass(10s);
  EXPECT_EQ(rig.outcome(id), nullptr) << "those of the goal rule";
  rig.cancel(id);
  rig.pass(200ms);
  EXPECT_EQ(rig.latest().link == CommandStatus::LinkState::Ready, false)
      << "those of the node, as they are now";
  rig.discardSent();
}

}  // namespace
}  // namespace cobot_command::testing
