// The supervisor is killed at each record of its journal, and within records (oracle 36).
#include <random>

#include "run_rig.h"
#include "thorough.h"

namespace cobot_command::trial {
namespace {

using cell::SupervisorMode;

/// Kills the supervisor when its journal has got `bytes` longer, or the record in which it does is begun and
/// not ended, and starts it anew a while later.
bool killBehind(RunRig& rig, std::size_t bytes, Duration later) {
  const std::size_t before = rig.trial->journal().size();
  rig.trial->limitJournal(before + bytes);
  const bool is_written = rig.passUntil(
      [&] { return rig.mode() == SupervisorMode::Fault || rig.trial->journal().size() >= before + bytes; },
      30s);
  if (!is_written) return false;
  const automata::Tuple tuple = rig.supervision().tuple();
  const std::uint64_t events = rig.trial->status().events;
  const std::uint64_t epoch = rig.trial->status().epoch;
  rig.trial->killSupervisor();
  rig.pass(later);
  rig.trial->limitJournal(std::nullopt);
  rig.trial->startSupervisor();
  EXPECT_EQ(rig.supervision().tuple(), tuple);
  EXPECT_EQ(rig.trial->status().events, events);
  EXPECT_EQ(rig.trial->status().epoch, epoch + 1);
  return true;
}

TEST(ASupervisorThatIsKilledAtAnyByteOfItsJournal, knowsWhatItHadToldAndTheCellGoesOn) {
  RunRig rig(artifactOf("iris"));
  rig.begin(testing::quickOrThorough(2, 20));
  std::mt19937 chance(36);
  int kills = 0;
  const auto all_ended = [&] {
    return rig.robot(0).hasEnded() && rig.robot(1).hasEnded() && rig.robot(2).hasEnded();
  };
  while (!all_ended() && !::testing::Test::HasFailure()) {
    // A record has about 100 bytes, and each may be the last one, or be torn.
    if (killBehind(rig, 1 + chance() % 150, std::chrono::milliseconds(chance() % 800))) ++kills;
    EXPECT_TRUE(rig.passUntil(
        [&] { return rig.mode() == SupervisorMode::Running || rig.mode() == SupervisorMode::Ready; }, 2s))
        << rig.trial->status().diagnosis;
  }
  EXPECT_TRUE(rig.endsAll());
  EXPECT_GT(kills, 15);
}

}  // namespace
}  // namespace cobot_command::trial
