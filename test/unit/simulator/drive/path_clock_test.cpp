#include "drive/path_clock.h"

#include <gtest/gtest.h>

namespace cobot_command::simulator {
namespace {

using namespace std::chrono_literals;

Instant at(Duration since_start) {
  return Instant{} + since_start;
}

PathClock running() {
  PathClock clock(200ms);
  clock.start(at(0s));
  return clock;
}

TEST(PathClock, runsAsRealTimeDoesAfterTheStart) {
  const PathClock clock = running();
  EXPECT_EQ(clock.pathTime(at(1234567ns)), 1234567ns);
  EXPECT_EQ(clock.rate(at(1s)), 1.0);
  EXPECT_EQ(clock.reaches(3s), at(3s));
}

TEST(PathClock, slowsDownToStandstillWithinTheRamp) {
  PathClock clock = running();
  clock.slowDown(at(1s));
  EXPECT_DOUBLE_EQ(clock.rate(at(1100ms)), 0.5);
  EXPECT_EQ(clock.pathTime(at(1100ms)), 1075ms);
  EXPECT_EQ(clock.settled(), at(1200ms));
  EXPECT_EQ(clock.pathTime(at(1200ms)), 1100ms);
  EXPECT_EQ(clock.pathTime(at(9s)), 1100ms);
  EXPECT_EQ(clock.rate(at(9s)), 0.0);
}

TEST(PathClock, goesOnFromWhereItStood) {
  PathClock clock = running();
  clock.slowDown(at(1s));
  clock.speedUp(at(5s));
  EXPECT_EQ(clock.pathTime(at(5s)), 1100ms);
  EXPECT_EQ(clock.pathTime(at(5200ms)), 1200ms);
  EXPECT_EQ(clock.pathTime(at(6200ms)), 2200ms);
  EXPECT_EQ(clock.reaches(2200ms), at(6200ms));
}

TEST(PathClock, turnsRoundInTheMiddleOfARampWithoutAStep) {
  PathClock clock = running();
  clock.slowDown(at(1s));
  const double before = clock.rate(at(1100ms));
  clock.speedUp(at(1100ms));
  EXPECT_DOUBLE_EQ(clock.rate(at(1100ms)), before);
  EXPECT_EQ(clock.settled(), at(1200ms));
  EXPECT_EQ(clock.pathTime(at(1200ms)), 1150ms);
}

TEST(PathClock, knowsWhenAPointIsReachedWithinARamp) {
  PathClock clock = running();
  clock.slowDown(at(1s));
  const auto reached = clock.reaches(1075ms);
  ASSERT_TRUE(reached);
  EXPECT_LE(std::chrono::abs(*reached - at(1100ms)), 1ns);
}

TEST(PathClock, saysWhenAPointIsNeverReached) {
  PathClock clock = running();
  clock.slowDown(at(1s));
  EXPECT_EQ(clock.reaches(1101ms), std::nullopt);
  EXPECT_EQ(clock.reaches(1100ms), at(1200ms));
}

TEST(PathClock, runsAtAnotherPaceFromNowOnWithoutAJump) {
  PathClock clock = running();
  clock.setPace(at(1s), 0.5);
  EXPECT_EQ(clock.pathTime(at(1s)), 1s);
  EXPECT_EQ(clock.rate(at(2s)), 0.5);
  EXPECT_EQ(clock.pathTime(at(3s)), 2s);
  EXPECT_EQ(clock.reaches(2s), at(3s));
  clock.setPace(at(3s), 1.25);
  EXPECT_EQ(clock.pathTime(at(7s)), 7s);
  EXPECT_EQ(clock.reaches(7s), at(7s));
  clock.start(at(9s));
  EXPECT_EQ(clock.rate(at(9s)), 1.0) << "a pace is that of one motion";
}

TEST(PathClock, takesAsLongToStandstillAtAnyPace) {
  PathClock clock = running();
  clock.setPace(at(0s), 0.5);
  clock.slowDown(at(1s));
  EXPECT_EQ(clock.settled(), at(1200ms));
  EXPECT_DOUBLE_EQ(clock.rate(at(1100ms)), 0.25);
  EXPECT_EQ(clock.pathTime(at(9s)), 550ms);
  EXPECT_EQ(clock.reaches(550ms), at(1200ms));
  EXPECT_EQ(clock.reaches(551ms), std::nullopt);
}

TEST(PathClock, changesItsPaceInTheMiddleOfARamp) {
  PathClock clock = running();
  clock.slowDown(at(1s));
  clock.setPace(at(1100ms), 2.0);
  EXPECT_EQ(clock.pathTime(at(1100ms)), 1075ms);
  EXPECT_DOUBLE_EQ(clock.rate(at(1100ms)), 1.0);
  EXPECT_EQ(clock.settled(), at(1200ms));
  EXPECT_EQ(clock.pathTime(at(1200ms)), 1125ms);
  clock.speedUp(at(2s));
  EXPECT_EQ(clock.rate(at(2200ms)), 2.0);
}

TEST(PathClock, stepsAtOnceWithoutARamp) {
  PathClock clock(0s);
  clock.start(at(0s));
  clock.slowDown(at(1s));
  EXPECT_EQ(clock.rate(at(1s)), 0.0);
  EXPECT_EQ(clock.pathTime(at(2s)), 1s);
  clock.speedUp(at(2s));
  EXPECT_EQ(clock.pathTime(at(3s)), 2s);
}

}  // namespace
}  // namespace cobot_command::simulator
