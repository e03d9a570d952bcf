// The death of who holds the arm: the node, its computer, or the link, which to the controller are one, as
// nothing comes any more, and no end of the connection either.

#include "jog_cell.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;

/// What the controller does by itself: the core is never called again.
class JogDeath : public ::testing::Test {
 protected:
  /// Joint 1, or along Y of the base, at 30 %.
  static void beginIn(JogCell& cell, JogMode mode) {
    cell.cell.submit(jog(mode, mode == JogMode::Axes ? 0 : 1, 1, 30));
    cell.hold(400ms);
    ASSERT_FALSE(cell.stands());
  }
  /// Since the last byte that it got.
  static Duration restAfterSilence(JogCell& cell) {
    const Instant silent_since = cell.cell.now();
    while (!cell.stands() && cell.cell.now() - silent_since < 5s) cell.cell.passRobotAlone(1ms);
    return cell.cell.now() - silent_since;
  }
};

TEST_F(JogDeath, letsAnArmThatJogsByMovesStandWithinAFifthOfASecond) {
  for (const auto mode : {JogMode::Axes, JogMode::Frame, JogMode::Tool}) {
    JogCell cell(true, {}, {}, {});
    beginIn(cell, mode);
    EXPECT_LE(restAfterSilence(cell), 220ms);
  }
}

TEST_F(JogDeath, letsTheControllersOwnWatchEndVelocitiesOfTheTcp) {
  for (const auto mode : {JogMode::Frame, JogMode::Tool}) {
    JogCell cell(true);
    beginIn(cell, mode);
    EXPECT_LE(restAfterSilence(cell), 300ms + 200ms + 20ms);
  }
}

TEST_F(JogDeath, letsVelocitiesOfJointsGoOnAsThePageSays) {
  JogCell cell(true);
  beginIn(cell, JogMode::Axes);
  const double at = cell.jointDeg(0);
  EXPECT_GT(restAfterSilence(cell), 2s) << "until the joint is at its limit";
  EXPECT_GT(cell.jointDeg(0) - at, 100);
}

}  // namespace
}  // namespace cobot_command::testing
