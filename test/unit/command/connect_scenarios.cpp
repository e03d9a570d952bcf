// How a connect goal fails.

#include "catalogue_scenarios.h"
#include "core_rig.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;

Outcome connectWith(const std::function<void(ConnectGoal&)>& change) {
  CoreRig rig;
  ConnectGoal goal = CoreRig::robot();
  change(goal);
  return *rig.outcome(rig.submit(goal));
}

Outcome connectUntilTimeout(const std::function<void(CoreRig&)>& trouble) {
  CoreRig rig;
  rig.answers_lifesigns = false;
  const GoalId goal = rig.submit(CoreRig::robot());
  for (int i = 0; i < 100 && rig.outcome(goal) == nullptr; ++i) {
    if (rig.pendingOpen(link::Channel::Script)) trouble(rig);
    rig.pass(100ms);
  }
  rig.discardSent();
  return *rig.outcome(goal);
}

}  // namespace

Scenarios connectScenarios() {
  using Kind = link::OpenFailure::Kind;
  const auto row = [](int id) { return Row{kBlock<ConnectGoal>, id}; };
  return {
      {row(connect_error::kTimeoutRange), [] { return connectWith([](auto& g) { g.timeout = 1; }); }},
      {row(connect_error::kConnection),
       [] { return connectUntilTimeout([](auto& rig) { rig.failOpen(Kind::UnknownHost); }); }},
      {row(connect_error::kTimeOut),
       [] {
         return connectUntilTimeout([](auto& rig) {
           rig.answers_lifesigns = true;
           rig.listening = false;
           rig.open();
         });
       }},
      {row(connect_error::kNotACobot),
       [] {
         return connectUntilTimeout([](auto& rig) {
           rig.open();
           rig.receive("HTTP/1.1 400 Bad Request\r\n");
         });
       }},
      {row(connect_error::kDisconnected),
       [] {
         CoreRig rig;
         const GoalId goal = rig.connect();
         rig.close("gone");
         return *rig.outcome(goal);
       }},
      {row(own_error::kShutDown),
       [] {
         CoreRig rig;
         rig.shutDown();
         const Outcome outcome = *rig.outcome(rig.submit(CoreRig::robot()));
         EXPECT_EQ(outcome.ending, Ending::Rejected);
         return outcome;
       }},
      {row(own_error::kHostInvalid), [] { return connectWith([](auto& g) { g.host = ""; }); }},
      {row(own_error::kPortRange), [] { return connectWith([](auto& g) { g.port = 0; }); }},
      {row(own_error::kConnectBusy),
       [] {
         CoreRig rig;
         rig.connect();
         return *rig.outcome(rig.submit(CoreRig::robot()));
       }},
  };
}

}  // namespace cobot_command::testing
