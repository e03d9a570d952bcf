// How an exchange_configuration goal is refused, and how it fails.
#include "catalogue_scenarios.h"
#include "exchange_rig.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;

Outcome refused(const std::function<void(ExchangeConfigurationGoal&)>& change) {
  ExchangeRig rig;
  rig.connect();
  return *rig.outcome(rig.exchange(change));
}

/// Enabled, until that.
Outcome until(const std::function<void(ExchangeRig&)>& trouble) {
  ExchangeRig rig;
  rig.connect();
  const GoalId id = rig.exchange();
  trouble(rig);
  rig.discardSent();
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Aborted);
  return *rig.outcome(id);
}

/// Enabled with tools that are in sync, or are said not to be.
void enable(ExchangeRig& rig, SyncReaction reaction, bool in_sync) {
  rig.connect();
  rig.exchangeWith([&](ExchangeSettings& s) {
    s.sync_reaction = static_cast<int>(reaction);
    s.data_enable_sync.tools = true;
    s.data_in_sync.tools = in_sync;
  });
}

/// Its data were in sync when it was enabled, and are so no more.
void interrupt(ExchangeRig& rig) {
  enable(rig, SyncReaction::InterruptAtOnce, true);
  rig.update([](ExchangeSettings& s) {
    s.sync_reaction = static_cast<int>(SyncReaction::InterruptAtOnce);
    s.data_enable_sync.tools = true;
  });
}

}  // namespace

Scenarios interfaceScenarios(const Goal& goal) {
  using namespace interface_error;
  const auto row = [&](int id) { return Row{blockOf(goal), id}; };
  return {{row(kNotEnabled),
           [=] {
             ExchangeRig rig;
             command::ExchangeRules rules;
             rules.required = true;
             rig.core.useExchangeRules(rules);
             rig.connect();
             return *rig.outcome(rig.submit(goal));
           }},
          {row(kNotSynchronized),
           [=] {
             ExchangeRig rig;
             enable(rig, SyncReaction::NoEnable, false);
             return *rig.outcome(rig.submit(goal));
           }},
          {row(kInterrupted), [=] {
             ExchangeRig rig;
             interrupt(rig);
             return *rig.outcome(rig.submit(goal));
           }}};
}

Scenarios resumeScenarios() {
  ProgramControlGoal resume;
  resume.command = static_cast<int>(ProgramCommand::Resume);
  return {{Row{kBlock<ProgramControlGoal>, interface_error::kInterrupted},
           [=] {
             ExchangeRig rig;
             interrupt(rig);
             return *rig.outcome(rig.submit(resume));
           }},
          {Row{kBlock<ProgramControlGoal>, own_error::kOverrideZero}, [=] {
             CoreRig rig;
             rig.connect();
             rig.core.setSpeedOverride(
                 0, [](const auto& /*answer*/) {}, rig.now);
             return *rig.outcome(rig.submit(resume));
           }}};
}

Scenarios exchangeScenarios() {
  using namespace exchange_error;
  using Goal = ExchangeConfigurationGoal;
  const auto row = [](int id) { return Row{kBlock<Goal>, id}; };
  return {
      {row(kTimedOut),
       [] {
         ExchangeRig rig;
         const GoalId id = rig.exchange();
         rig.pass(6s);
         return *rig.outcome(id);
       }},
      {row(kParCmd), [] { return refused([](Goal& g) { g.priority = 5; }); }},
      {row(kSyncMode),
       [] {
         ExchangeRig rig;
         command::ExchangeRules rules;
         rules.sync.tools.start = static_cast<int>(command::SyncMode::Automatic);
         rig.core.useExchangeRules(rules);
         rig.connect();
         return *rig.outcome(rig.exchange());
       }},
      {row(kLifeSignLost),
       [] {
         return until([](ExchangeRig& rig) {
           rig.answers_lifesigns = false;
           rig.pass(500ms);
         });
       }},
      {row(kConnectionLost), [] { return until([](ExchangeRig& rig) { rig.close("gone"); }); }},
      {row(kLifeSignTimeOut), [] { return refused([](Goal& g) { g.settings.life_sign_time_out = 9; }); }},
      {row(kLogLevel), [] { return refused([](Goal& g) { g.settings.log_level = 6; }); }},
      {row(kSyncReaction), [] { return refused([](Goal& g) { g.settings.sync_reaction = 4; }); }},
      {row(kNumberOfCommands), [] { return refused([](Goal& g) { g.settings.wait_for_nr_of_cmd = 65; }); }},
      {row(kWaitAtBlending),
       [] { return refused([](Goal& g) { g.settings.wait_at_blending_zone = true; }); }},
      {row(kExecutionMode), [] { return refused([](Goal& g) { g.exec_mode = 18; }); }},
      {row(kOnlyOneInstance),
       [] {
         ExchangeRig rig;
         rig.connect();
         rig.exchange();
         return *rig.outcome(rig.exchange());
       }},
      {row(own_error::kShutDown), [] { return until([](ExchangeRig& rig) { rig.shutDown(); }); }},
  };
}

}  // namespace cobot_command::testing
