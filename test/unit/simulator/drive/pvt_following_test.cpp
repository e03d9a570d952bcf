// Arms that do not follow a PVT as it is.
#include "drive/pvt_following.h"

#include <cmath>

#include <gtest/gtest.h>

namespace cobot_command::simulator {
namespace {

using namespace std::chrono_literals;

/// All joints from 0 to 1 rad and at rest at both ends, in a second.
class Smooth final : public motion::Trajectory {
 public:
  [[nodiscard]] static double way(double t) { return t * t * (3 - 2 * t); }
  [[nodiscard]] Duration duration() const override { return 1s; }
  [[nodiscard]] Duration timeUp() const override { return 100ms; }
  [[nodiscard]] Duration timeDown() const override { return 100ms; }
  [[nodiscard]] motion::JointState at(Duration time) const override {
    const double t = toSeconds(std::clamp<Duration>(time, 0s, 1s));
    return {arm::JointVector::Constant(way(t)), arm::JointVector::Constant(6 * t * (1 - t))};
  }
};

const motion::TrajectoryPtr smooth = std::make_shared<Smooth>();

double angle(const motion::TrajectoryPtr& path, Duration time) {
  return path->at(time).position[3];
}
double speed(const motion::TrajectoryPtr& path, Duration time) {
  return path->at(time).velocity[3];
}

TEST(StraightBetween, isAtThePointsAtTheirTimesAndEvenBetweenThem) {
  const auto path = straightBetween(smooth, {200ms, 500ms, 1s});
  for (const Duration time : {Duration(0s), Duration(200ms), Duration(500ms), Duration(1s)}) {
    EXPECT_DOUBLE_EQ(angle(path, time), angle(smooth, time));
  }
  EXPECT_DOUBLE_EQ(angle(path, 100ms), Smooth::way(0.2) / 2);
  EXPECT_DOUBLE_EQ(angle(path, 350ms), (Smooth::way(0.2) + Smooth::way(0.5)) / 2);
  const double even = (Smooth::way(0.5) - Smooth::way(0.2)) / 0.3;
  EXPECT_DOUBLE_EQ(speed(path, 200ms), even);
  EXPECT_DOUBLE_EQ(speed(path, 499ms), even);
}

TEST(StraightBetween, takesTheSameTimeAndRestsAtTheEnd) {
  const auto path = straightBetween(smooth, {500ms});
  EXPECT_EQ(path->duration(), 1s);
  EXPECT_EQ(path->timeDown(), 100ms);
  EXPECT_DOUBLE_EQ(angle(path, 750ms), 0.75) << "from the last point straight to the end";
  EXPECT_EQ(angle(path, 2s), 1);
  EXPECT_EQ(speed(path, 1s), 0);
  EXPECT_EQ(angle(path, -1s), 0);
}

TEST(StraightBetween, takesTimesTwiceOrBehindTheEndAsNoPointsOfTheirOwn) {
  const auto path = straightBetween(smooth, {0s, 500ms, 500ms, 3s});
  EXPECT_DOUBLE_EQ(angle(path, 250ms), 0.25);
  EXPECT_DOUBLE_EQ(angle(path, 750ms), 0.75);
}

TEST(Behind, standsAtTheStartAndComesToTheSameEndLater) {
  const auto path = behind(smooth, 50ms);
  EXPECT_EQ(path->duration(), 1050ms);
  EXPECT_EQ(angle(path, 50ms), 0);
  EXPECT_EQ(speed(path, 49ms), 0);
  EXPECT_EQ(angle(path, 550ms), angle(smooth, 500ms));
  EXPECT_EQ(speed(path, 550ms), speed(smooth, 500ms));
  EXPECT_EQ(path->end().position, smooth->end().position);
}

TEST(Behind, isThePathItselfWithoutALag) {
  EXPECT_EQ(behind(smooth, 0s), smooth);
}

}  // namespace
}  // namespace cobot_command::simulator
