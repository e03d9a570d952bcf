#include "simulation/simulated_clock.h"

#include <gtest/gtest.h>

namespace cobot_command::runtime {
namespace {

using std::chrono::hours;
using std::chrono::microseconds;
using std::chrono::milliseconds;

const SimulatedClock::RealTime kStart{hours(1000)};

TEST(SimulatedClock, startsAtZero) {
  EXPECT_EQ(SimulatedClock(1, kStart).stepTo(kStart), Instant{});
}

TEST(SimulatedClock, goesAsRealTimeDoesAtScaleOne) {
  SimulatedClock clock(1, kStart);
  EXPECT_EQ(clock.stepTo(kStart + milliseconds(15)), Instant(milliseconds(15)));
  EXPECT_EQ(clock.stepTo(kStart + milliseconds(40)), Instant(milliseconds(40)));
}

TEST(SimulatedClock, goesFasterOrSlowerByItsScale) {
  SimulatedClock fast(20, kStart);
  EXPECT_EQ(fast.stepTo(kStart + milliseconds(10)), Instant(milliseconds(200)));
  SimulatedClock slow(0.5, kStart);
  EXPECT_EQ(slow.stepTo(kStart + milliseconds(10)), Instant(milliseconds(5)));
}

TEST(SimulatedClock, neverGoesBack) {
  SimulatedClock clock(1, kStart);
  clock.stepTo(kStart + milliseconds(50));
  EXPECT_EQ(clock.stepTo(kStart + milliseconds(20)), Instant(milliseconds(50)));
  EXPECT_EQ(clock.stepTo(kStart + milliseconds(60)), Instant(milliseconds(60)));
  clock.jumpTo(Instant(milliseconds(10)));
  EXPECT_EQ(clock.stepTo(kStart + milliseconds(60)), Instant(milliseconds(60)));
}

TEST(SimulatedClock, standsStillForWhatWasSleptThrough) {
  SimulatedClock clock(2, kStart);
  EXPECT_EQ(clock.stepTo(kStart + hours(8)), Instant(2 * SimulatedClock::kLongestStep));
  EXPECT_EQ(clock.stepTo(kStart + hours(8) + milliseconds(1)),
            Instant(2 * SimulatedClock::kLongestStep + milliseconds(2)));
}

TEST(SimulatedClock, goesOnFromWhereItJumpedTo) {
  SimulatedClock clock(1, kStart);
  clock.jumpTo(Instant(hours(1)));
  EXPECT_EQ(clock.stepTo(kStart + milliseconds(3)), Instant(hours(1) + milliseconds(3)));
}

TEST(SimulatedClock, tellsWhenToStepForAnEvent) {
  SimulatedClock clock(10, kStart);
  EXPECT_EQ(clock.realTimeOf(Instant(milliseconds(30))), kStart + milliseconds(3));
  clock.stepTo(kStart + milliseconds(2));
  EXPECT_EQ(clock.realTimeOf(Instant(milliseconds(30))), kStart + milliseconds(3));
  EXPECT_EQ(clock.realTimeOf(Instant(milliseconds(10))), kStart + milliseconds(2)) << "overdue: at once";
}

TEST(SimulatedClock, isNeverTooEarlyForAnEvent) {
  for (const double scale : {0.01, 0.3, 1.0, 7.0, 100.0}) {
    SimulatedClock clock(scale, kStart);
    const Instant event(microseconds(777));
    EXPECT_GE(clock.stepTo(clock.realTimeOf(event)) + std::chrono::nanoseconds(1), event) << scale;
  }
}

TEST(SimulatedClock, doesNotWaitLongerThanWhatCountsAsLived) {
  const SimulatedClock clock(1, kStart);
  EXPECT_EQ(clock.realTimeOf(Instant(hours(1))), kStart + SimulatedClock::kLongestWait);
  EXPECT_EQ(clock.realTimeOf(Instant::max()), kStart + SimulatedClock::kLongestWait);
  EXPECT_LT(SimulatedClock::kLongestWait, SimulatedClock::kLongestStep);
}

}  // namespace
}  // namespace cobot_command::runtime
