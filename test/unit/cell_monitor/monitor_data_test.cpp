// What the monitor makes of data that is old, missing or wrong (cell.md, M35 and the faults).
#include <cmath>
#include <limits>

#include "watched_cell.h"
#include <gtest/gtest.h>

namespace cobot_command::cell {
namespace {

const arm::JointVector kMoving = 0.1 * arm::JointVector::Unit(5);

TEST(MonitorData, thatIsStaleOfARobotThatStandsIsNoStop) {
  Monitor monitor = handover();
  stand(monitor, kHome, kHome, at(0));
  for (int i = 1; i < 100; ++i) monitor.tick(at(100 * i));
  EXPECT_TRUE(monitor.takeActions().empty());
  EXPECT_FALSE(monitor.nextDeadline().has_value());
}

TEST(MonitorData, thatIsStaleOfARobotThatMovesStopsAll) {
  Monitor monitor = handover();
  stand(monitor, kHome, kHome, at(0));
  monitor.take("left", kHome, kMoving, fromSeconds(0.1), at(1.1));
  monitor.tick(at(1.5));
  EXPECT_TRUE(monitor.takeActions().empty());
  monitor.tick(at(1.5) + Duration(1));
  const auto stops = only<StopAll>(monitor.takeActions());
  ASSERT_EQ(stops.size(), 1u);
  EXPECT_EQ(stops[0].why, "left moved in its last report, which was measured more than 0.5 s ago.");
  monitor.tick(at(9));
  EXPECT_TRUE(monitor.takeActions().empty());
  EXPECT_FALSE(monitor.reset(at(9)).success);
  monitor.take("left", kHome, kStanding, Duration(0), at(10));
  EXPECT_TRUE(monitor.reset(at(10)).success);
}

TEST(MonitorData, thatIsNotFiniteOrAbsurdIsDroppedAndCounted) {
  Monitor monitor = handover();
  stand(monitor, kHome, kHome, at(0));
  std::uint64_t dropped = 0;
  for (const double wrong : {std::nan(""), std::numeric_limits<double>::infinity(), -1e300, 100.0}) {
    for (Eigen::Index i = 0; i < 6; ++i) {
      arm::JointVector joints = kT1;
      joints[i] = wrong;
      monitor.take("left", joints, kStanding, Duration(0), at(1));
      monitor.take("left", kT1, joints, Duration(0), at(1));
      dropped += 2;
    }
  }
  monitor.take("left", kT1, kStanding, Duration(-1), at(1));
  monitor.take("left", kT1, kStanding, Duration::max(), at(1));
  monitor.take("left", kT1, kStanding, Duration::min(), at(1));
  monitor.tick(at(1));
  EXPECT_EQ(monitor.status().counts.malformed, dropped + 3);
  EXPECT_NEAR(mToMm(monitor.status().pairs.front().distance), 659, 1);
}

TEST(MonitorData, ofAnUnknownRobotIsCounted) {
  Monitor monitor = handover();
  monitor.take("middle", kHome, kStanding, Duration(0), at(0));
  EXPECT_EQ(monitor.status().counts.unknown, 1u);
  EXPECT_FALSE(monitor.nextDeadline().has_value());
}

TEST(MonitorData, thatWasMeasuredBeforeWhatIsKnownIsCountedAndChangesNothing) {
  Monitor monitor = handover();
  stand(monitor, kHome, kHome, at(1));
  monitor.take("left", kT1, kStanding, fromSeconds(0.3), at(1.2));
  monitor.take("left", kT1, kStanding, fromSeconds(0.2), at(1.2));
  monitor.tick(at(1.2));
  EXPECT_EQ(monitor.status().counts.old, 2u);
  EXPECT_NEAR(mToMm(monitor.status().pairs.front().distance), 659, 1);
}

TEST(MonitorData, ofAFrozenStreamBecomesStale) {
  Monitor monitor = handover();
  stand(monitor, kHome, kHome, at(0));
  monitor.take("left", kHome, kMoving, Duration(0), at(1));
  for (int i = 1; i <= 60; ++i) {
    monitor.take("left", kHome, kMoving, fromSeconds(0.01 * i), at(1 + 0.01 * i));
    monitor.tick(at(1 + 0.01 * i));
  }
  EXPECT_EQ(only<StopAll>(monitor.takeActions()).size(), 1u);
}

TEST(MonitorData, withoutVelocitiesHasThoseOfSuccessiveSamples) {
  Monitor monitor = handover();
  stand(monitor, kHome, kHome, at(0));
  for (int i = 0; i <= 10; ++i) {
    const arm::JointVector joints = kHome + 0.01 * i * arm::JointVector::Unit(0);
    monitor.take("left", joints, std::nullopt, Duration(0), at(1 + 0.02 * i));
  }
  monitor.take("right", kHome, kStanding, Duration(0), at(1.2));
  monitor.tick(at(1.3));
  const double derived = monitor.status().pairs.front().uncertainty;
  Monitor told = handover();
  told.take("left", kHome + 0.1 * arm::JointVector::Unit(0), 0.5 * arm::JointVector::Unit(0), Duration(0),
            at(1.2));
  told.take("right", kHome, kStanding, Duration(0), at(1.2));
  told.tick(at(1.3));
  EXPECT_NEAR(derived, told.status().pairs.front().uncertainty, 1e-6);
  EXPECT_GT(derived, 0.01);
}

TEST(MonitorData, whoseVelocitiesAreZerosWhileTheJointsMoveIsThatOfARobotThatMoves) {
  Monitor monitor = handover();
  monitor.take("left", kHome, kStanding, Duration(0), at(0));
  monitor.take("left", kHome + 0.01 * arm::JointVector::Unit(0), kStanding, Duration(0), at(0.02));
  monitor.take("right", kHome, kStanding, Duration(0), at(0.02));
  monitor.tick(at(0.1));
  EXPECT_GT(monitor.status().pairs.front().uncertainty, 0.01);
  monitor.tick(at(0.6));
  EXPECT_TRUE(monitor.latched());
}

TEST(MonitorData, thatComesInABurstMakesNoSpeeds) {
  Monitor monitor = handover();
  stand(monitor, kHome, kHome, at(0));
  monitor.take("left", kHome + 1e-4 * arm::JointVector::Unit(0), std::nullopt, Duration(0), at(0.001));
  monitor.tick(at(0.4));
  EXPECT_EQ(monitor.status().pairs.front().uncertainty, 0);
}

TEST(MonitorData, ofOneSampleWithoutVelocitiesCountsAsThatOfARobotThatMoves) {
  Monitor monitor = handover();
  monitor.take("left", kHome, std::nullopt, Duration(0), at(0));
  monitor.tick(at(0.5));
  EXPECT_FALSE(monitor.latched());
  monitor.tick(at(0.6));
  EXPECT_TRUE(monitor.latched());
}

TEST(MonitorClock, onlyDifferencesOfItsInstantsMatter) {
  const auto run = [](Instant begin) {
    Monitor monitor = handover();
    monitor.take("left", kHome, kMoving, fromSeconds(0.02), begin);
    monitor.take("right", kT1, kMoving, fromSeconds(0.03), begin);
    monitor.tick(begin + fromSeconds(0.1));
    return monitor.status().pairs.front();
  };
  const PairStatus one = run(at(0));
  for (const Instant begin : {at(3600), at(-3600), at(1e9)}) {
    EXPECT_EQ(run(begin).distance, one.distance);
    EXPECT_EQ(run(begin).uncertainty, one.uncertainty);
  }
}

TEST(MonitorClock, tellsWhenThereIsSomethingToLookAt) {
  Monitor monitor = handover();
  EXPECT_FALSE(monitor.nextDeadline().has_value());
  monitor.take("left", kHome, kStanding, Duration(0), at(1));
  EXPECT_EQ(monitor.nextDeadline(), at(1));
  monitor.tick(at(1));
  EXPECT_FALSE(monitor.nextDeadline().has_value());
  monitor.take("left", kHome, kMoving, Duration(0), at(1.01));
  EXPECT_EQ(monitor.nextDeadline(), at(1.02));
  monitor.tick(at(1.02));
  EXPECT_EQ(monitor.nextDeadline(), at(1.04));
  monitor.tick(at(1.505));
  EXPECT_EQ(monitor.nextDeadline(), at(1.51) + Duration(1));
  monitor.tick(*monitor.nextDeadline());
  EXPECT_TRUE(monitor.latched());
  EXPECT_FALSE(monitor.nextDeadline().has_value());
}

TEST(MonitorSettingsCheck, refusesWhatIsNone) {
  const auto message = [](const MonitorSettings& settings) {
    const auto monitor = Monitor::of({{"left", leftBodies(), {}}}, {}, settings);
    return monitor ? std::string() : monitor.error().message;
  };
  EXPECT_EQ(message({}), "");
  MonitorSettings settings;
  settings.margin = std::nan("");
  EXPECT_NE(message(settings), "");
  settings = {};
  settings.stop_distance = 0.021;
  EXPECT_EQ(message(settings), "The stop distance is 0.021 m, but must be at most the margin, 0.02 m.");
  settings = {};
  settings.stale_after = Duration(0);
  EXPECT_NE(message(settings), "");
  settings = {};
  settings.exact_within = 0.001;
  EXPECT_NE(message(settings), "");
}

TEST(MonitorSettingsCheck, refusesTwoOfOneNameAndThingsWithoutBodies) {
  const WatchedRobot left{"left", leftBodies(), {}};
  EXPECT_FALSE(Monitor::of({left, left}, {}));
  EXPECT_FALSE(Monitor::of({left}, {{"left", {Capsule{}}}}));
  EXPECT_FALSE(Monitor::of({left}, {{"table", {}}}));
  EXPECT_FALSE(Monitor::of({{"left", leftBodies(), {{"bar", {}}, {"bar", {}}}}}, {}));
}

}  // namespace
}  // namespace cobot_command::cell
