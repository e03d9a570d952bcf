// Ramps that follow a law, by the figures of section 7 of the path contract.
#include "profiles/ramped_profile.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion_support.h"

namespace cobot_command::motion {
namespace {

constexpr std::array<SpeedLaw, 4> kLaws{SpeedLaw::SCurve, SpeedLaw::ModSine, SpeedLaw::Poly5,
                                        SpeedLaw::SineSquared};
using Figures = std::array<double, 4>;  // in the order of kLaws

RampShape shape(SpeedLaw law, double varying) {
  return {law, varying, varying};
}

void expectDurations(double way, const Rates& rates, double varying, const Figures& expected) {
  for (std::size_t i = 0; i < kLaws.size(); ++i) {
    EXPECT_NEAR(phasesOf(way, rates, shape(kLaws[i], varying)).duration(), expected[i], 5e-5) << i;
  }
}

TEST(RampedProfile, takesTheTimesOfTheClosedForms) {
  const Rates rates{90, 180, 180};  // deg, as below
  expectDurations(90, rates, 0.0, {1.5, 1.5, 1.5, 1.5});
  expectDurations(90, rates, 1.0, {1.75, 1.8798, 1.9375, 2.0});
  expectDurations(90, rates, 0.5, {1.6, 1.6376, 1.6522, 1.6667});
}

TEST(RampedProfile, keepsItsAccelerationWhereTheWayIsTooShortForTheSpeed) {
  const Rates rates{90, 180, 180};
  expectDurations(20, rates, 1.0, {0.8165, 0.8843, 0.9129, 0.9428});
  const Figures top{48.990, 45.232, 43.818, 42.426};
  for (std::size_t i = 0; i < kLaws.size(); ++i) {
    const Phases phases = phasesOf(20, rates, shape(kLaws[i], 1.0));
    EXPECT_EQ(phases.cruise, 0.0);
    EXPECT_NEAR(20 / (0.5 * (phases.up + phases.down)), top[i], 5e-4) << i;
  }
}

TEST(RampedProfile, hasRampsOfTheirOwn) {
  const Rates rates{250, 1000, 500};  // mm
  const Phases sine = phasesOf(300, rates, {SpeedLaw::ModSine, 1.0, 0.0});
  EXPECT_NEAR(sine.up, 0.4399, 5e-5);
  EXPECT_NEAR(sine.cruise, 0.7301, 1e-4);
  EXPECT_NEAR(sine.down, 0.5, 1e-9);
  EXPECT_NEAR(sine.duration(), 1.6700, 5e-5);
  EXPECT_NEAR(phasesOf(300, rates, {SpeedLaw::SCurve, 1.0, 0.0}).duration(), 1.6375, 1e-9);
}

TEST(RampedProfile, roundsItsPhasesUpToWholeMilliseconds) {
  const Phases grid = onGrid({0.4399, 0.7301, 0.5});
  EXPECT_DOUBLE_EQ(grid.up, 0.440);
  EXPECT_DOUBLE_EQ(grid.cruise, 0.731);
  EXPECT_DOUBLE_EQ(grid.down, 0.5);
  EXPECT_EQ(RampedProfile(grid, {}).time(), std::chrono::milliseconds(1671));
  EXPECT_DOUBLE_EQ(onGrid({0.001, 0.0, 0.001}).duration(), 0.05);
}

TEST(RampedProfile, hasNoCruiseThatIsShorterThanASegment) {
  const Phases phases = phasesOf(20, {180, 2000, 2000}, {});  // 21 ms at 180
  EXPECT_DOUBLE_EQ(phases.cruise, 0.025);
  EXPECT_NEAR(2000 * phases.up, 176.556, 1e-3);
  EXPECT_NEAR(phases.duration(), 20.0 / 180 + 180.0 / 2000, 1e-3);
  EXPECT_NEAR(2000 * phases.up * (phases.cruise + phases.up), 20, 1e-9) << "it goes as far";
}

TEST(RampedProfile, neverTakesLessTimeThanTheClosedFormAndAtMostThreeMillisecondsMore) {
  for (int i = 0; i < 18; ++i) {
    const double way = 5 * std::pow(1.3, i);
    for (const SpeedLaw law : kLaws) {
      const Phases exact = phasesOf(way, {200, 900, 500}, shape(law, 0.7));
      const double more = onGrid(exact).duration() - exact.duration();
      EXPECT_GE(more, -1e-8);
      EXPECT_LE(more, 3e-3);
    }
  }
}

TEST(Ramp, goesHalfAsFarAsItsTopSpeedWouldWhateverTheLaw) {
  for (const SpeedLaw law : kLaws) {
    for (const double varying : {0.0, 0.3, 1.0}) {
      const Ramp ramp(law, varying);
      EXPECT_NEAR(ramp.way(1.0), 0.5, 1e-15);
      EXPECT_NEAR(ramp.speed(1.0), 1.0, 1e-15);
      EXPECT_EQ(ramp.speed(0.0), 0.0);
      EXPECT_EQ(ramp.way(0.0), 0.0);
    }
  }
}

TEST(Ramp, followsTheLawsAtAQuarterAndInTheMiddle) {
  const Figures quarter{0.15625, 0.117178, 0.103516, 0.090845};
  const Figures way_to_the_middle{0.09375, 0.0820065, 0.078125, 0.0743394};
  const Figures steepest{1.5, 1.7596034, 1.875, 2.0};
  for (std::size_t i = 0; i < kLaws.size(); ++i) {
    const Ramp ramp(kLaws[i], 1.0);
    EXPECT_NEAR(ramp.speed(0.25), quarter[i], 5e-7) << i;
    EXPECT_NEAR(ramp.speed(0.5), 0.5, 1e-15) << i;
    EXPECT_NEAR(ramp.way(0.5), way_to_the_middle[i], 5e-8) << i;
    EXPECT_NEAR(ramp.stretch(), steepest[i], 5e-8) << i;
  }
}

TEST(Ramp, isTheIntegralOfItsSpeedAndKeepsItsAcceleration) {
  for (const SpeedLaw law : kLaws) {
    for (const double varying : {0.0, 0.05, 0.5, 1.0}) {
      const Ramp ramp(law, varying);
      constexpr int kSteps = 20000;
      constexpr double kStep = 1.0 / kSteps;
      double way = 0.0;
      double steepest = 0.0;
      for (int i = 0; i < kSteps; ++i) {
        const double from = ramp.speed(i * kStep);
        const double to = ramp.speed((i + 1) * kStep);
        ASSERT_GE(to, from);
        steepest = std::max(steepest, (to - from) / kStep);
        way += kStep / 6.0 * (from + 4.0 * ramp.speed((i + 0.5) * kStep) + to);
        ASSERT_NEAR(way, ramp.way((i + 1) * kStep), 1e-9);
      }
      // in units of the acceleration that was asked for
      EXPECT_LE(steepest / ramp.stretch(), 1.0 + 1e-9);
      EXPECT_GE(steepest / ramp.stretch(), 0.999);
    }
  }
}

TEST(RampedProfile, isTheIntegralOfItsRateAndEndsExactly) {
  const RampedProfile profile(onGrid(phasesOf(300, {250, 1000, 500}, {SpeedLaw::Poly5, 1.0, 0.4})),
                              {SpeedLaw::Poly5, 1.0, 0.4});
  EXPECT_EQ(profile.progress(0.0), 0.0);
  EXPECT_EQ(profile.progress(profile.duration()), 1.0);
  EXPECT_EQ(profile.rate(profile.duration()), 0.0);
  double way = 0.0;
  constexpr int kSteps = 20000;
  const double step = profile.duration() / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    way += step * profile.rate((i + 0.5) * step);
    ASSERT_NEAR(way, profile.progress((i + 1) * step), 1e-6);
  }
}

}  // namespace
}  // namespace cobot_command::motion
