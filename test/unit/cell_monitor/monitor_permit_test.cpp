// What programs allow takes back a part of what old data is uncertain by, and nothing of what was measured
// (doc/cell.md, "The monitor").
#include "watched_cell.h"
#include <gtest/gtest.h>

namespace cobot_command::cell {
namespace {

/// As fast as a program on the way to T1 may be [rad/s].
arm::JointVector fast() {
  return kT1 - kHome;
}

std::vector<double> speedsOf(const arm::JointVector& speeds) {
  std::vector<double> all;
  for (const double speed : speeds) all.push_back(std::abs(speed));
  return all;
}

/// The left one moves towards the right one, which stands at T1; both were measured `age` before the look.
class OldData : public ::testing::Test {
 protected:
  void look(double distance, double age, const arm::JointVector& speed = fast()) {
    monitor.take("left", leftAt(distance), speed, Duration(0), at(1));
    monitor.take("right", kT1, kStanding, Duration(0), at(1));
    monitor.tick(at(1 + age));
  }
  void permit(const std::vector<std::size_t>& left, const std::vector<std::size_t>& right,
              const arm::JointVector& most = fast()) {
    EXPECT_TRUE(monitor.setPermit("left", Permit{left, speedsOf(most)}));
    EXPECT_TRUE(monitor.setPermit("right", Permit{right, speedsOf(most)}));
  }
  [[nodiscard]] bool isStopped() { return !only<StopAll>(monitor.takeActions()).empty(); }
  [[nodiscard]] PairStatus pair() { return monitor.status().pairs.front(); }

  Monitor monitor = handover();
};

TEST_F(OldData, isUncertainWithoutBoundWhereNobodyKnowsWhatIsPermitted) {
  look(0.1286, 0.3);
  EXPECT_GT(pair().uncertainty, 0.1286);
  EXPECT_TRUE(isStopped());
}

TEST_F(OldData, isUncertainDownToTheMarginWhereWhatBothHoldKeepsThemApart) {
  permit({0}, {1});
  look(0.1286, 0.3);
  EXPECT_NEAR(pair().distance - pair().uncertainty, 0.020, 1e-9);
  EXPECT_FALSE(pair().breached);
  EXPECT_FALSE(isStopped());
}

TEST_F(OldData, isThatOfOneThatMayBeAnywhereUnlessBothArePermitted) {
  monitor.setPermit("left", Permit{{0}, speedsOf(fast())});
  look(0.1286, 0.3);
  EXPECT_TRUE(isStopped());
}

TEST_F(OldData, countsInFullWhereBothHoldTheSame) {
  permit({0, 3}, {3});
  look(0.1286, 0.3);
  EXPECT_TRUE(isStopped()) << "by its program each keeps the other out: something is wrong";
}

TEST_F(OldData, countsInFullOnceNobodyKnowsAnyMore) {
  permit({0}, {1});
  look(0.1286, 0.3);
  EXPECT_FALSE(isStopped());
  monitor.setPermit("right", std::nullopt);
  monitor.tick(at(1.31));
  EXPECT_TRUE(isStopped());
}

TEST_F(OldData, countsByWhatMayHaveHappenedPromptly) {
  permit({0}, {1});
  look(0.040, 0.049);
  EXPECT_TRUE(isStopped()) << "0.05 s at a metre a second";
}

TEST_F(OldData, isNeverReasonToPassOverWhatWasMeasured) {
  permit({0}, {1});
  look(0.009, 0);
  EXPECT_TRUE(isStopped());
}

TEST_F(OldData, thatIsStaleStopsAllWhateverIsPermitted) {
  permit({0}, {1});
  look(0.4, 0.51);
  EXPECT_TRUE(isStopped());
}

/// Two that come at once behind a pause, as on a busy machine: as if it had moved so far within 10 ms.
TEST_F(OldData, showsNoSpeedThatTheProgramDoesNotHave) {
  permit({0}, {1});
  const arm::JointVector end = leftAt(0.1286);
  monitor.take("left", end - 0.3 * fast(), kStanding, Duration(0), at(1));
  monitor.take("left", end, kStanding, Duration(0), at(1.01));
  monitor.take("right", kT1, kStanding, Duration(0), at(1.01));
  monitor.tick(at(1.04));
  EXPECT_NEAR(pair().distance - pair().uncertainty, 0.020, 1e-9);
  EXPECT_FALSE(isStopped()) << "by the program it is 40 mm, and by the messages more than a metre";
}

TEST_F(OldData, showsNoSpeedThatTheArmDoesNotHave) {
  const auto uncertaintyOf = [](const std::vector<double>& most) {
    Monitor watch = monitorOf({{"left", leftBodies(), {}, most}, {"right", rightBodies(), {}}});
    watch.take("left", kHome, std::nullopt, Duration(0), at(1));
    watch.take("left", onTheWay(0.3), std::nullopt, Duration(0), at(1.01));
    watch.take("right", kHome, kStanding, Duration(0), at(1.01));
    watch.tick(at(1.02));
    return watch.status().pairs.front().uncertainty;
  };
  EXPECT_LT(uncertaintyOf(speedsOf(fast())), 0.02);
  EXPECT_GT(uncertaintyOf({}), 0.2);
}

TEST(OldDataBesideAnObstacle, isUncertainDownToTheMarginWhereItsProgramIsKnown) {
  const auto isStopped = [](bool is_permitted) {
    const WatchedObstacle post{"post", {{{0, 0, -2}, {0, 0, 2}, 0.05}}};
    Monitor watch = monitorOf({{"left", leftBodies(), {}}}, {}, {post});
    if (is_permitted) watch.setPermit("left", Permit{{}, speedsOf(fast())});
    watch.take("left", kHome, 3 * fast(), Duration(0), at(1));
    watch.tick(at(1.4));
    return !only<StopAll>(watch.takeActions()).empty();
  };
  EXPECT_TRUE(isStopped(false));
  EXPECT_FALSE(isStopped(true));
}

TEST(APermit, isRefusedForWhatIsNotWatched) {
  Monitor monitor = handover();
  EXPECT_FALSE(monitor.setPermit("middle", Permit{}));
}

}  // namespace
}  // namespace cobot_command::cell
