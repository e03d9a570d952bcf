// What is on the wire counts: the cubics between the points of a PVT, read from its text, are nowhere steeper
// or faster than what was asked for, whatever the law and the jerk.
#include <algorithm>
#include <cmath>
#include <random>

#include "path_support.h"
#include "wire_support.h"

#include "cobot_command/path/pvt_block.h"

namespace cobot_command::path {
namespace {

/// What a cubic may be above what was asked for.
constexpr double kShare = 0.01;
/// Five decimals of a degree, half of the last one wrong at both ends of 25 ms [deg/s^2].
constexpr double kRounding = 0.1;

/// How far the wire was above what was asked for.
struct Excess {
  int ramps = 0;
  int above_5_percent = 0;
  double acceleration = 0;  ///< the largest, as a share
  double speed = 0;

  void add(double of_acceleration, double of_speed) {
    ++ramps;
    above_5_percent += of_acceleration > 0.05 ? 1 : 0;
    acceleration = std::max(acceleration, of_acceleration);
    speed = std::max(speed, of_speed);
  }
};

double above(double found, double asked, double rounding) {
  return (std::abs(found) - rounding) / asked - 1;
}

class PvtAcceleration : public Paths {
 protected:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  int any(int last) { return std::uniform_int_distribution<int>(0, last)(engine_); }

  PathPoint anyRamps(PathPoint point, double least_jerk, double most_jerk) {
    point.profile_type = any(3);
    point.acceleration_jerk = uniform(least_jerk, most_jerk);
    point.deceleration_jerk = uniform(least_jerk, most_jerk);
    return point;
  }
  PathPoint anyJointMove(double least_jerk, double most_jerk) {
    PathPoint point =
        toJoints({uniform(-90, 90), uniform(-40, 40), uniform(60, 120), uniform(-40, 40), 90, 0});
    point.speed = uniform(10, 120);
    point.acceleration = uniform(50, 1500);
    point.deceleration = uniform(50, 1500);
    return anyRamps(point, least_jerk, most_jerk);
  }
  PathPoint anyLine(double least_jerk, double most_jerk) {
    PathPoint point =
        incremental(toPose({uniform(-100, 100), uniform(-100, 100), uniform(-100, 100), 0, 0, 0}));
    point.speed = uniform(20, 400);
    point.acceleration = uniform(200, 3000);
    point.deceleration = uniform(200, 3000);
    return anyRamps(point, least_jerk, most_jerk);
  }
  [[nodiscard]] std::vector<WireCubic> wireOf(const PathPlan& plan,
                                              Duration segment = motion::kLeastSegment) const {
    const PvtBlock block = sampleBlock(plan, 0, plan.points().size() - 1, segment);
    return path::wireOf(script::toText(scriptOf(block, {})), scene.start);
  }
  /// Of the joints, each of which has its share of what was asked of that with the longest way.
  void addJointMove(const PathPoint& point, Excess& excess, Duration segment = motion::kLeastSegment) const {
    const PathPlan plan = planned({point});
    const arm::JointVector way = endOf(plan) - scene.start;
    const double longest = way.cwiseAbs().maxCoeff();
    double acceleration = 0;
    double speed = 0;
    for (const WireCubic& cubic : wireOf(plan, segment)) {
      for (Eigen::Index i = 0; i < 6; ++i) {
        const double share = way[i] / longest;
        if (std::abs(share) < 0.1) continue;
        for (const int end : {0, 1}) {
          const double found = cubic.accelerationAt(end)[i] / share;
          const double asked = found > 0 ? point.acceleration : point.deceleration;
          acceleration = std::max(acceleration, above(found, asked, kRounding / std::abs(share)));
        }
        speed = std::max(speed, above(cubic.highestSpeed()[i] / share, point.speed, 1e-4));
      }
    }
    excess.add(acceleration, speed);
  }
  /// Of the flange on its line.
  void addLine(const PathPoint& point, Excess& excess) const {
    PathPlanner planner(scene);
    if (planner.append(sectionOf({point}))) return;
    const Eigen::Vector3d way = place(endOf(planner.plan())) - place(scene.start);
    double acceleration = 0;
    double speed = 0;
    for (const WireCubic& cubic : wireOf(planner.plan())) {
      constexpr double kStep = 1e-3;
      const auto at = [&](double time) {
        return place(cubic.placeAt(time).unaryExpr(&degToRad)).dot(way.normalized());
      };
      for (double time = kStep; time + kStep < cubic.duration + 1e-9; time += kStep) {
        const double found = mToMm((at(time + kStep) + at(time - kStep) - 2 * at(time)) / (kStep * kStep));
        acceleration =
            std::max(acceleration, above(found, found > 0 ? point.acceleration : point.deceleration, 4));
        speed = std::max(speed, above(mToMm(at(time + kStep) - at(time)) / kStep, point.speed, 0.1));
      }
    }
    excess.add(acceleration, speed);
  }
  /// Of joints that may have what both motions of a corner have.
  void addBlock(const PathPlan& plan, std::size_t first, std::size_t last, Excess& excess) const {
    const PvtBlock block = sampleBlock(plan, first, last);
    double acceleration = 0;
    double speed = 0;
    Duration begin = plan.points()[first].start;
    for (const WireCubic& cubic :
         path::wireOf(script::toText(scriptOf(block, {})), plan.at(begin).position)) {
      const Duration end = begin + fromSeconds(cubic.duration);
      const arm::JointVector most = allowed(plan, begin, end, steeper);
      const arm::JointVector fastest = allowed(plan, begin, end, speedOf);
      for (Eigen::Index i = 0; i < 6; ++i) {
        const double found =
            std::max(std::abs(cubic.accelerationAt(0)[i]), std::abs(cubic.accelerationAt(1)[i]));
        if (most[i] > 20) acceleration = std::max(acceleration, above(found, most[i], kRounding));
        if (fastest[i] > 2) speed = std::max(speed, above(cubic.highestSpeed()[i], fastest[i], 1e-4));
      }
      begin = end;
    }
    excess.add(acceleration, speed);
  }
  /// Of all motions that move the arm then, each joint has its share.
  template <class Value>
  [[nodiscard]] static arm::JointVector allowed(const PathPlan& plan, Duration begin, Duration end,
                                                Value value) {
    arm::JointVector allowed = arm::JointVector::Zero();
    for (const PlannedPoint& point : plan.points()) {
      if (point.start >= end || point.end() <= begin) continue;
      const arm::JointVector way = point.motion->end().position - point.motion->at({}).position;
      allowed += value(point.point) * way.cwiseAbs() / way.cwiseAbs().maxCoeff();
    }
    return allowed;
  }
  static double steeper(const PathPoint& point) { return std::max(point.acceleration, point.deceleration); }
  static double speedOf(const PathPoint& point) { return point.speed; }
  [[nodiscard]] Excess aroundCorners(double least_jerk, double most_jerk) {
    Excess excess;
    for (int run = 0; run < 60; ++run) {
      std::vector<PathPoint> points;
      for (int i = 0; i < 5; ++i) {
        points.push_back(blending(anyJointMove(least_jerk, most_jerk), uniform(5, 100)));
      }
      PathPlanner planner(scene);
      if (planner.append(sectionOf(points))) continue;
      for (std::size_t first = 0; first < points.size();) {
        const std::size_t last = endOfBlock(planner.plan(), first);
        addBlock(planner.plan(), first, last, excess);
        first = last + 1;
      }
    }
    EXPECT_GT(excess.ramps, 50);
    return excess;
  }
  [[nodiscard]] Eigen::Vector3d place(const arm::JointVector& joints) const {
    return arm::forwardKinematics(scene.arm, joints).translation();
  }
  static void expectKept(const Excess& excess) {
    EXPECT_LE(excess.acceleration, kShare)
        << excess.above_5_percent << " of " << excess.ramps << " are above 5 %";
    EXPECT_LE(excess.speed, kShare);
    EXPECT_GT(excess.ramps, 50);
  }

  std::mt19937 engine_{20261127};
};

TEST_F(PvtAcceleration, ofJointsIsThatWhichWasAskedForWithAnyLawAndJerk) {
  Excess excess;
  for (int i = 0; i < 172; ++i) addJointMove(anyJointMove(5, 50), excess);
  expectKept(excess);
}

TEST_F(PvtAcceleration, isThatWhichWasAskedForWithoutJerkAndWithAllOfIt) {
  Excess excess;
  for (const double jerk : {0.0, 1.0, 75.0, 100.0}) {
    for (int i = 0; i < 40; ++i) addJointMove(anyJointMove(jerk, jerk), excess);
  }
  expectKept(excess);
}

TEST_F(PvtAcceleration, ofLinesIsThatWhichWasAskedForWithAnyLawAndJerk) {
  Excess excess;
  for (int i = 0; i < 100; ++i) addLine(anyLine(5, 50), excess);
  expectKept(excess);
}

/// Where their ends are nearer than a segment, a PVT cannot say both ramps as they are: as doc/path.md
/// admits.
TEST_F(PvtAcceleration, aroundCornersIsLittleMoreThanThatOfBothMotions) {
  const Excess excess = aroundCorners(5, 50);
  EXPECT_LE(excess.acceleration, 0.25);
  EXPECT_LE(excess.speed, 0.03);
  EXPECT_LT(10 * excess.above_5_percent, excess.ramps);
}

TEST_F(PvtAcceleration, aroundCornersWithoutJerkIsAtMostTwiceThatOfBothMotions) {
  const Excess excess = aroundCorners(0, 0);
  EXPECT_LE(excess.acceleration, 1.06);
  EXPECT_LE(excess.speed, 0.03);
  EXPECT_LT(4 * excess.above_5_percent, excess.ramps);
}

}  // namespace
}  // namespace cobot_command::path
