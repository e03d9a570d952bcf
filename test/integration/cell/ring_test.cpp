// Many robots in a ring, each of which needs the spaces of both its neighbours, by safe orders (P11).
#include <chrono>
#include <iostream>

#include "ring_cell.h"
#include "run_rig.h"
#include "thorough.h"

namespace cobot_command::trial {
namespace {

TEST(ARingOfRobots, endsAllCyclesBySafeOrdersWithinTheMargin) {
  const auto robots = testing::fromEnvironment("COBOT_CELL_ROBOTS", testing::quickOrThorough(8U, 32U));
  const auto cycles = testing::fromEnvironment("COBOT_CELL_CYCLES", testing::quickOrThorough(5U, 1000U));
  TrialSettings settings;
  settings.policy = cell::Policy::SafeOrder;
  settings.most = std::chrono::hours(240);
  RunRig rig(artifactOfText(ringCell(static_cast<int>(robots)), {}, cell::Policy::SafeOrder), settings);
  ASSERT_EQ(rig.artifact->zones.size(), robots);
  const auto start = std::chrono::steady_clock::now();
  const Instant began = rig.trial->now();
  rig.begin(static_cast<int>(cycles));
  EXPECT_TRUE(rig.endsAll(std::chrono::hours(240)));
  std::cout << cycles << " cycles of " << robots << " robots in " << toSeconds(rig.trial->now() - began)
            << " s, of the clock "
            << std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()
            << " s; least distance " << 1000.0 * rig.trial->least().distance << " mm\n";
}

/// Those who help the one that waits for longest do not wait for the sake of another.
TEST(ARingOfRobots, endsAllCyclesWhereMostHaveWaitedForLong) {
  TrialSettings settings;
  settings.policy = cell::Policy::SafeOrder;
  const auto impatient = [](cell::Parameters& parameters) { parameters.aging = 5s; };
  RunRig rig(artifactOfText(ringCell(20), impatient, cell::Policy::SafeOrder), settings);
  rig.begin(4);
  EXPECT_TRUE(rig.endsAll(std::chrono::minutes(30)));
}

/// As each holds one zone and wants the next one.
TEST(ARingOfRobots, blocksWhereWhateverIsFreeIsGranted) {
  TrialSettings settings;
  settings.policy = cell::Policy::MutualExclusion;
  settings.cycles = 1000;
  const auto trial = CellTrial::of(artifactOfText(ringCell(8), {}, cell::Policy::SafeOrder), settings);
  ASSERT_TRUE(trial) << trial.error();
  EXPECT_TRUE((*trial)->run().is_dead);
}

}  // namespace
}  // namespace cobot_command::trial
