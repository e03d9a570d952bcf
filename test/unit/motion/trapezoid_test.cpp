#include "profiles/trapezoid.h"

#include <cmath>

#include <gtest/gtest.h>

namespace cobot_command::motion {
namespace {

TEST(Trapezoid, takesTheTravelTimePlusOneRampWhenItReachesItsTopSpeed) {
  const Trapezoid profile(3.0, 0.5);
  EXPECT_DOUBLE_EQ(profile.duration(), 3.5);
  EXPECT_DOUBLE_EQ(profile.shareOfTopSpeed(1.75), 1.0);
}

TEST(Trapezoid, isTriangularWithTheSameAccelerationWhenTheWayIsShort) {
  const Trapezoid profile(0.1, 0.4);  // sqrt(0.1 * 0.4) = 0.2 s up, 0.2 s down
  EXPECT_DOUBLE_EQ(profile.duration(), 0.4);
  EXPECT_DOUBLE_EQ(profile.shareOfTopSpeed(0.2), 0.5);
  EXPECT_DOUBLE_EQ(profile.shareOfTopSpeed(0.1), 0.25);
  EXPECT_DOUBLE_EQ(profile.progress(0.2), 0.5);
}

TEST(Trapezoid, isBothShapesAtOnceWhenItJustReachesItsTopSpeed) {
  const Trapezoid profile(0.4, 0.4);
  EXPECT_DOUBLE_EQ(profile.duration(), 0.8);
  EXPECT_DOUBLE_EQ(profile.shareOfTopSpeed(0.4), 1.0);
}

TEST(Trapezoid, followsTheClosedFormInEachOfItsThreeParts) {
  const Trapezoid profile(2.0, 1.0);  // 3 s: 1 up, 1 cruise, 1 down
  EXPECT_DOUBLE_EQ(profile.progress(0.5), 0.0625);
  EXPECT_DOUBLE_EQ(profile.progress(1.0), 0.25);
  EXPECT_DOUBLE_EQ(profile.progress(1.5), 0.5);
  EXPECT_DOUBLE_EQ(profile.progress(2.0), 0.75);
  EXPECT_DOUBLE_EQ(profile.progress(2.5), 0.9375);
  EXPECT_DOUBLE_EQ(profile.rate(0.5), 0.25);
  EXPECT_DOUBLE_EQ(profile.rate(1.5), 0.5);
  EXPECT_DOUBLE_EQ(profile.rate(2.5), 0.25);
}

TEST(Trapezoid, startsAndEndsExactlyAtRest) {
  for (const double travel : {1e-9, 0.013, 0.7, 1234.5}) {
    const Trapezoid profile(travel, 0.3);
    EXPECT_EQ(profile.progress(0.0), 0.0);
    EXPECT_EQ(profile.rate(0.0), 0.0);
    EXPECT_EQ(profile.progress(profile.duration()), 1.0);
    EXPECT_EQ(profile.rate(profile.duration()), 0.0);
  }
}

TEST(Trapezoid, ratesAreTheSlopeOfTheProgress) {
  for (const double travel : {0.05, 0.9}) {
    const Trapezoid profile(travel, 0.2);
    constexpr double kStep = 1e-6;
    for (int i = 1; i < 40; ++i) {
      const double time = profile.duration() * i / 40.0;
      const double slope = (profile.progress(time + kStep) - profile.progress(time - kStep)) / (2 * kStep);
      EXPECT_NEAR(profile.rate(time), slope, 1e-4 / travel) << time;
    }
  }
}

TEST(Trapezoid, takesNoTimeWhenThereIsNowhereToGo) {
  EXPECT_EQ(Trapezoid(0.0, 0.2).duration(), 0.0);
}

TEST(Trapezoid, fromASpeedNeedsTheRestOfItsRampOnly) {
  // Half of the top speed: 0.2 s and 0.15 s of way to all of it, 0.4 s and 0.2 s of way to rest.
  const Trapezoid profile(1.0, 0.4, 0.5);
  EXPECT_DOUBLE_EQ(profile.duration(), 0.2 + (1.0 - 0.15 - 0.2) + 0.4);
  EXPECT_FALSE(profile.startsAtRest());
  EXPECT_DOUBLE_EQ(profile.shareOfTopSpeed(0.0), 0.5);
  EXPECT_DOUBLE_EQ(profile.shareOfTopSpeed(0.1), 0.75);
  EXPECT_DOUBLE_EQ(profile.shareOfTopSpeed(0.2), 1.0);
  EXPECT_DOUBLE_EQ(profile.progress(0.2), 0.15);
  EXPECT_DOUBLE_EQ(profile.progress(profile.duration()), 1.0);
}

TEST(Trapezoid, fromASpeedPeaksWhereTheWayIsShort) {
  // Peak p: (p^2 - 0.25) 0.2 + p^2 0.2 = 0.15 gives p^2 = 0.5.
  const Trapezoid profile(0.15, 0.4, 0.5);
  const double peak = std::sqrt(0.5);
  EXPECT_NEAR(profile.duration(), 0.4 * (peak - 0.5) + 0.4 * peak, 1e-12);
  EXPECT_NEAR(profile.shareOfTopSpeed(0.4 * (peak - 0.5)), peak, 1e-12);
}

TEST(Trapezoid, brakesAsHardAsItMust) {
  const Trapezoid profile(0.1, 0.4, 1.0);  // 0.2 s of way would be needed
  EXPECT_NEAR(profile.duration(), 0.2, 1e-12);
  EXPECT_NEAR(profile.progress(0.1), 0.75, 1e-12);
  EXPECT_NEAR(profile.shareOfTopSpeed(0.1), 0.5, 1e-12);
}

TEST(Trapezoid, steadyHasOneSpeed) {
  const Trapezoid profile = Trapezoid::steady(2.0);
  EXPECT_EQ(profile.duration(), 2.0);
  EXPECT_EQ(profile.timeDown(), 0.0);
  for (const double time : {0.0, 0.5, 2.0}) {
    EXPECT_DOUBLE_EQ(profile.progress(time), 0.5 * time);
    EXPECT_DOUBLE_EQ(profile.rate(time), 0.5);
  }
}

TEST(Trapezoid, tellsWhenItIsWhereUnlessItBrakesBefore) {
  for (const double start : {0.0, 0.4}) {
    const Trapezoid profile(2.0, 0.5, start);
    for (const double time : {0.1, 0.6, 1.2}) {
      EXPECT_NEAR(profile.timeBeforeBraking(profile.progress(time)), time, 1e-12);
    }
    EXPECT_NEAR(profile.timeBeforeBraking(0.999), profile.duration() - 0.5, 1e-12);
  }
}

}  // namespace
}  // namespace cobot_command::motion
