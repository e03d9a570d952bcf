// Messages that are lost, doubled, late and out of order cost nothing but time (oracle 35).
#include <chrono>
#include <iostream>

#include "run_rig.h"
#include "thorough.h"

namespace cobot_command::trial {
namespace {

TrialSettings badNetwork(std::uint64_t seed) {
  TrialSettings settings;
  settings.seed = seed;
  settings.loss = 0.3;
  settings.doubled = 0.25;
  settings.delay = 2s;
  return settings;
}

void expectCycles(const std::string& cell, int cycles, const TrialSettings& settings, Duration lease) {
  RunRig rig(artifactOf(cell,
                        [lease](cell::Parameters& parameters) {
                          parameters.lease = lease;
                          parameters.wait_timeout = std::chrono::minutes(30);
                        }),
             settings);
  rig.begin(cycles);
  const auto start = std::chrono::steady_clock::now();
  const Instant began = rig.trial->now();
  EXPECT_TRUE(rig.endsAll(std::chrono::hours(2) + cycles * std::chrono::minutes(5)));
  std::cout << cycles << " cycles of " << cell << " in " << toSeconds(rig.trial->now() - began)
            << " s, of the clock "
            << std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() << " s\n";
}

TEST(AnIrisOnABadNetwork, endsAllCyclesWithinTheMargin) {
  const auto cycles = testing::fromEnvironment("COBOT_CELL_CYCLES", testing::quickOrThorough(20U, 1000U));
  expectCycles("iris", static_cast<int>(cycles), badNetwork(35), 5s);
}

/// Which is over again and again while a newer message is under way.
TEST(AnIrisOnABadNetwork, endsAllCyclesWithAShortLeaseToo) {
  const auto cycles = testing::fromEnvironment("COBOT_CELL_CYCLES", testing::quickOrThorough(3U, 100U));
  expectCycles("iris", static_cast<int>(cycles), badNetwork(36), 500ms);
}

TEST(ACellWithEverythingAtRandom, endsAllCyclesWithinTheMargin) {
  TrialSettings settings = badNetwork(37);
  settings.is_random = true;
  settings.delay = 500ms;
  const auto cycles = testing::fromEnvironment("COBOT_CELL_CYCLES", testing::quickOrThorough(3U, 100U));
  expectCycles("corridor", static_cast<int>(cycles), settings, 1s);
}

}  // namespace
}  // namespace cobot_command::trial
