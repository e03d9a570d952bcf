// How a wait for an input, or for a time, ends without it.

#include "block_goals.h"
#include "catalogue_scenarios.h"
#include "core_rig.h"
#include "status_frames.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;

/// Of a wait, with the input off when it begins; or without it in the stream.
Outcome waitedUntil(bool streamed, const std::function<void(CoreRig&)>& end) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  rig.connect();
  rig.status(streamed ? StatusFrames().input("Ctrl_DI3", false) : StatusFrames());
  const GoalId id = rig.submit(good<WaitForInputGoal>());
  end(rig);
  return rig.outcome(id) == nullptr ? Outcome{} : *rig.outcome(id);
}

/// The status stream goes on for so long.
void stream(CoreRig& rig, int seconds) {
  for (int i = 0; i < 2 * seconds; ++i) {
    rig.pass(500ms);
    rig.status(StatusFrames().input("Ctrl_DI3", false));
  }
}

}  // namespace

Scenarios waitScenarios() {
  const auto row = [](int id) { return Row{kBlock<WaitForInputGoal>, id}; };
  return {
      {row(own_error::kInputTimedOut),
       [] { return waitedUntil(true, [](CoreRig& rig) { stream(rig, 10); }); }},
      {row(own_error::kInputUnknown), [] { return waitedUntil(false, [](CoreRig&) {}); }},
      {row(motion_error::kLinkDropped),
       [] {
         return waitedUntil(true, [](CoreRig& rig) {
           rig.close("gone");
           rig.pass(500ms);
         });
       }},
      {Row{kBlock<WaitTimeGoal>, motion_error::kLinkDropped},
       [] {
         CoreRig rig(std::nullopt, link::LinkSettings{});
         rig.connect();
         rig.status(StatusFrames());
         const GoalId id = rig.submit(good<WaitTimeGoal>());
         rig.close("gone");
         rig.pass(500ms);
         return rig.outcome(id) == nullptr ? Outcome{} : *rig.outcome(id);
       }},
  };
}

}  // namespace cobot_command::testing
