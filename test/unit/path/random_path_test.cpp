// Random points of all kinds: a path is refused by a number of the manual, or it keeps what it promises.
#include <algorithm>
#include <map>
#include <random>

#include "path_support.h"

#include "cobot_command/motion/planner.h"
#include "cobot_command/path/pvt_block.h"

namespace cobot_command::path {
namespace {

class RandomPoints {
 public:
  explicit RandomPoints(unsigned seed) : engine_(seed) {}

  std::vector<PathPoint> path(int count) {
    std::vector<PathPoint> points;
    points.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) points.push_back(point());
    return points;
  }

 private:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  int any(int last) { return std::uniform_int_distribution<int>(0, last)(engine_); }

  /// Increments, as most of them can be reached.
  PathPoint point() {
    PathPoint point;
    point.move_type = number(MoveType::Incremental);
    point.target_type = any(2);
    point.interpolation = any(2);
    for (double& joint : point.joints) joint = uniform(-30, 30);
    for (std::size_t i = 6; i < 9; ++i) point.joints.at(i) = 0;
    for (std::size_t i = 0; i < 3; ++i) point.pose.at(i) = uniform(-120, 120);
    for (std::size_t i = 3; i < 6; ++i) point.pose.at(i) = uniform(-10, 10);
    point.termination_type = any(2) == 0 ? number(Termination::Stop) : number(Termination::Blend);
    point.command_tolerance = uniform(0, 20);
    point.profile_type = any(3);
    point.speed = uniform(5, 150);
    point.acceleration = uniform(50, 800);
    point.deceleration = uniform(50, 800);
    point.acceleration_jerk = uniform(0, 100);
    point.deceleration_jerk = uniform(0, 100);
    point.orientation_speed = uniform(10, 90);
    point.orientation_acceleration = uniform(50, 500);
    point.orientation_deceleration = uniform(50, 500);
    return point;
  }

  std::mt19937_64 engine_;
};

class RandomPaths : public Paths {
 protected:
  void expectKept(const PathPlan& plan) const {
    for (const PlannedPoint& point : plan.points()) {
      ASSERT_EQ(point.start % std::chrono::milliseconds(1), Duration::zero());
      ASSERT_EQ(point.motion->duration() % std::chrono::milliseconds(1), Duration::zero());
      ASSERT_LE(point.overlap, point.motion->duration() / 2);
    }
    const Duration step = std::chrono::milliseconds(1);
    for (Duration time{}; time <= plan.duration(); time += step) {
      const motion::JointState state = plan.at(time);
      ASSERT_LT(scene.arm.firstJointOutsideLimits(state.position), 0) << toSeconds(time);
      for (std::size_t i = 0; i < arm::kJointCount; ++i) {
        ASSERT_LE(std::abs(state.velocity[static_cast<Eigen::Index>(i)]),
                  scene.arm.limits().at(i).max_velocity * 1.01)
            << toSeconds(time);
      }
    }
  }
  /// Whoever makes the PVT takes it: the simulated arm plans with the same code.
  void expectSendable(const PathPlan& plan) const {
    arm::JointVector from = scene.start;
    for (std::size_t first = 0; first < plan.points().size();) {
      const std::size_t last = endOfBlock(plan, first);
      const PvtBlock block = sampleBlock(plan, first, last);
      first = last + 1;
      if (block.points.empty()) continue;
      const auto made = motion::plan(scene.arm, from, motion::Pvt{block.points}, {});
      ASSERT_TRUE(made) << made.error().message;
      from = (*made)->end().position;
    }
  }
};

TEST_F(RandomPaths, keepTheirLimitsOrAreRefusedByANumberOfTheManual) {
  RandomPoints random(20261123);
  std::map<int, int> refusals;
  int taken = 0;
  for (int i = 0; i < 150; ++i) {
    SCOPED_TRACE(i);
    PathPlanner planner(scene);
    const auto points = random.path(6);
    if (const auto refusal = planner.append(sectionOf(points))) {
      ++refusals[refusal->error_id];
      ASSERT_GE(refusal->index, 0);
      ASSERT_LT(refusal->index, 6);
      ASSERT_FALSE(refusal->found.empty());
      continue;
    }
    ++taken;
    expectKept(planner.plan());
    expectSendable(planner.plan());
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(taken, 30);
  EXPECT_GT(refusals.size(), 2U);
}

}  // namespace
}  // namespace cobot_command::path
