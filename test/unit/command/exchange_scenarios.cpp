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
  return *rig.outcome(id);
}

}  // namespace

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
