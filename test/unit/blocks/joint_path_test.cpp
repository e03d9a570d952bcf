// Planned motions as points.

#include "cobot_command/blocks/shared/joint_path.h"

#include <memory>

#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace std::chrono_literals;

/// All joints at the second since the start, all at 1 rad/s.
class Steady final : public motion::Trajectory {
 public:
  explicit Steady(Duration duration) : duration_(duration) {}
  [[nodiscard]] Duration duration() const override { return duration_; }
  [[nodiscard]] motion::JointState at(Duration time) const override {
    return {arm::JointVector::Constant(toSeconds(time)), arm::JointVector::Ones()};
  }
  [[nodiscard]] Duration timeUp() const override { return Duration::zero(); }
  [[nodiscard]] Duration timeDown() const override { return Duration::zero(); }

 private:
  Duration duration_;
};

motion::TrajectoryPtr steady(Duration duration) {
  return std::make_shared<Steady>(duration);
}

TEST(JointPath, hasPointsAtMost20MillisecondsApartButAtMost100) {
  EXPECT_EQ(jointPath(Steady(19ms)).size(), 2u);
  EXPECT_EQ(jointPath(Steady(1s)).size(), 52u);
  EXPECT_EQ(jointPath(Steady(1h)).size(), 100u);
  const auto path = jointPath(Steady(1s));
  for (std::size_t i = 1; i < path.size(); ++i) EXPECT_LE(path[i].time - path[i - 1].time, Duration(20ms));
}

TEST(JointPath, goesFromTheStartToTheEndOrAsFarAsAskedFor) {
  const auto whole = jointPath(Steady(1s));
  EXPECT_EQ(whole.front().time, Duration::zero());
  EXPECT_EQ(whole.back().time, Duration(1s));
  EXPECT_DOUBLE_EQ(whole.back().joints[5], 1.0);
  EXPECT_DOUBLE_EQ(whole.back().velocities[5], 1.0);
  EXPECT_EQ(jointPath(Steady(1s), 300ms).back().time, Duration(300ms));
  EXPECT_EQ(jointPath(Steady(1s), 2s).back().time, Duration(1s));
}

TEST(JointPath, isOnePointForNoMotion) {
  EXPECT_EQ(jointPath(Steady(0s)).size(), 1u);
  EXPECT_TRUE(jointPath(std::vector<motion::TrajectoryPtr>()).empty());
}

TEST(JointPath, putsMotionsOneBehindTheOtherWithoutDoublePoints) {
  const auto path = jointPath({steady(1s), steady(0s), steady(500ms)});
  EXPECT_EQ(path.front().time, Duration::zero());
  EXPECT_EQ(path.back().time, Duration(1500ms));
  for (std::size_t i = 1; i < path.size(); ++i) EXPECT_GT(path[i].time, path[i - 1].time);
}

}  // namespace
}  // namespace cobot_command::testing
