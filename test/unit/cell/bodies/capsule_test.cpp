#include "cobot_command/cell/bodies/capsule.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cell_test_support.h"
#include <gtest/gtest.h>

namespace cobot_command::cell {
namespace {

using Eigen::Vector3d;

Vector3d pointOf(const Capsule& capsule, double t) {
  return capsule.from + t * (capsule.to - capsule.from);
}

/// By trying the points of one core against the other segment, which is exact for each; too large by at most
/// half a step.
double sampledDistance(const Capsule& a, const Capsule& b, int steps) {
  double least = (a.from - b.from).norm();
  for (int i = 0; i <= steps; ++i) {
    const Vector3d point = pointOf(a, static_cast<double>(i) / steps);
    const Vector3d along = b.to - b.from;
    const double length = along.squaredNorm();
    const double t = length > 0 ? std::clamp((point - b.from).dot(along) / length, 0.0, 1.0) : 0.0;
    least = std::min(least, (point - pointOf(b, t)).norm());
  }
  return least;
}

double sampledDistance(const Capsule& capsule, const AlignedBox& box, int steps) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i) {
    const Vector3d point = pointOf(capsule, static_cast<double>(i) / steps);
    least = std::min(least, (point - point.cwiseMax(box.lower).cwiseMin(box.upper)).norm());
  }
  return least;
}

double halfStep(const Capsule& capsule, int steps) {
  return 0.5 * (capsule.to - capsule.from).norm() / steps + 1e-12;
}

/// Any two, and such as make closed forms fail: points, parallel ones, on one line, next to parallel.
struct Pair {
  Capsule a;
  Capsule b;
};
Pair randomPair(RandomNumbers& random, int kind) {
  Pair pair{{random.point(1), random.point(1), 0.1}, {random.point(1), random.point(1), 0.2}};
  const Vector3d along = pair.a.to - pair.a.from;
  if (kind == 1) pair.a.to = pair.a.from;
  if (kind == 2) pair.b.to = pair.b.from;
  if (kind == 3) pair = {{pair.a.from, pair.a.from, 0.1}, {pair.b.from, pair.b.from, 0.2}};
  if (kind == 4) pair.b.to = pair.b.from + random.within(-2, 2) * along;
  if (kind == 5) {
    pair.b = {pair.a.from + random.within(-2, 2) * along, pair.a.from + random.within(-2, 2) * along, 0.2};
  }
  if (kind == 6) pair.b.to = pair.b.from + along + std::pow(10.0, random.within(-16, -3)) * random.point(1);
  if (kind == 7) {
    const Vector3d middle = pointOf(pair.a, 0.5);
    const Vector3d turned = along + std::pow(10.0, random.within(-12, -2)) * random.point(1);
    pair.b = {middle - random.within(0, 1) * turned, middle + random.within(0, 1) * turned, 0.2};
  }
  return pair;
}

TEST(CoreDistance, isTheLeastOfAllPairsOfPoints) {
  RandomNumbers random(1);
  for (int i = 0; i < 8000; ++i) {
    const Pair pair = randomPair(random, i % 8);
    constexpr int kSteps = 200;
    const double found = coreDistance(pair.a, pair.b);
    const double sampled = sampledDistance(pair.a, pair.b, kSteps);
    ASSERT_LE(found, sampled + 1e-12) << i;
    ASSERT_GE(found, sampled - halfStep(pair.a, kSteps)) << i;
    ASSERT_NEAR(found, coreDistance(pair.b, pair.a), 1e-9) << i;
    ASSERT_NEAR(distanceBetween(pair.a, pair.b), found - pair.a.radius - pair.b.radius, 1e-12);
  }
}

TEST(CoreDistance, isZeroWhereSegmentsCross) {
  RandomNumbers random(2);
  for (int i = 0; i < 2000; ++i) {
    // The last ones cross at an angle of 1e-9 rad.
    const Capsule a{random.point(1), random.point(1), 0};
    const Vector3d turned = (a.to - a.from) + std::pow(10.0, -9.0 * i / 2000) * random.point(1);
    const Vector3d crossing = pointOf(a, random.within(0.1, 0.9));
    const Capsule b{crossing - random.within(0, 1) * turned, crossing + random.within(0, 1) * turned, 0};
    ASSERT_LT(coreDistance(a, b), 1e-9) << i;
  }
}

TEST(CoreDistance, doesNotDependOnTheFrame) {
  RandomNumbers random(3);
  for (int i = 0; i < 1000; ++i) {
    const Pair pair = randomPair(random, i % 8);
    const arm::Pose frame = random.pose(2);
    ASSERT_NEAR(coreDistance(placed(frame, pair.a), placed(frame, pair.b)), coreDistance(pair.a, pair.b),
                1e-9);
  }
}

TEST(NearestOf, areTheFirstOfAllPairsThatAreTheNearest) {
  RandomNumbers random(5);
  for (int i = 0; i < 2000; ++i) {
    const double size = i % 2 == 0 ? 3 : 0.3;
    Capsules first;
    Capsules second;
    for (int k = 0; k < 6; ++k) {
      first.push_back({random.point(size), random.point(size), random.within(0, 0.3)});
      second.push_back({random.point(size), random.point(size), random.within(0, 0.3)});
      if (i % 5 == 0) first.back().to = first.back().from;
      if (i % 3 == 0) second.back().to = second.back().from;
    }
    second.push_back(second.front());
    first.push_back(first[3]);
    Nearest expected{std::numeric_limits<double>::infinity(), 0, 0};
    for (std::size_t a = 0; a < first.size(); ++a) {
      for (std::size_t b = 0; b < second.size(); ++b) {
        const double distance = distanceBetween(first[a], second[b]);
        if (distance < expected.distance) expected = {distance, a, b};
      }
    }
    const Nearest found = nearestOf(first, second);
    ASSERT_EQ(found.distance, expected.distance);
    ASSERT_EQ(found.first, expected.first);
    ASSERT_EQ(found.second, expected.second);
  }
}

TEST(BoxAround, holdsEachCapsuleAndTouchesOne) {
  const AlignedBox box = boxAround({{{0, 0, 0}, {1, 0, 0}, 0.1}, {{0, 2, -1}, {0, 2, -1}, 0.5}});
  EXPECT_TRUE(box.lower.isApprox(Vector3d(-0.5, -0.1, -1.5)));
  EXPECT_TRUE(box.upper.isApprox(Vector3d(1.1, 2.5, 0.1)));
}

/// So that whoever compares boxes first leaves out no pair that matters, however deep one is in the other.
TEST(LeastDistance, ofBoxesIsNoMoreThanBetweenWhatIsInThem) {
  RandomNumbers random(6);
  for (int i = 0; i < 2000; ++i) {
    const Capsules first(1, randomPair(random, i % 6).a);
    const Capsules second{randomPair(random, 0).b, randomPair(random, 0).a};
    ASSERT_LE(leastDistance(boxAround(first), boxAround(second)), nearestOf(first, second).distance + 1e-12);
  }
  const AlignedBox box{{0, 0, 0}, {1, 1, 1}};
  EXPECT_DOUBLE_EQ(leastDistance(box, {{4, 5, 0.5}, {5, 6, 2}}), 5);
  EXPECT_EQ(leastDistance(box, {{0.5, 0.5, 0.5}, {2, 2, 2}}), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isinf(leastDistance(boxAround({}), boxAround({{{0, 0, 0}, {1, 0, 0}, 0.1}}))));
}

TEST(NearestOf, areFoundWhereAllIsAtOnePlace) {
  const Capsules points(3, Capsule{{1, 2, 3}, {1, 2, 3}, 0.1});
  EXPECT_DOUBLE_EQ(nearestOf(points, points).distance, -0.2);
  const Capsules lines(3, Capsule{{1, 2, 3}, {1, 2, 3}, 0});
  EXPECT_DOUBLE_EQ(nearestOf(lines, lines).distance, 0);
}

TEST(DistanceToSegment, isThatOfItsNearestPoint) {
  EXPECT_DOUBLE_EQ(distanceToSegment({1, 3, 0}, {0, 0, 0}, {2, 0, 0}), 3);
  EXPECT_DOUBLE_EQ(distanceToSegment({-3, 4, 0}, {0, 0, 0}, {2, 0, 0}), 5);
  EXPECT_DOUBLE_EQ(distanceToSegment({5, 0, 4}, {0, 0, 0}, {2, 0, 0}), 5);
  EXPECT_DOUBLE_EQ(distanceToSegment({0, 0, 2}, {0, 0, 0}, {0, 0, 0}), 2);
}

TEST(CoreDistance, toABoxIsTheLeastOfAllPoints) {
  RandomNumbers random(4);
  for (int i = 0; i < 8000; ++i) {
    const Vector3d one = random.point(0.5);
    const Vector3d other = i % 4 == 0 ? (one + 0.02 * Vector3d::Ones()).eval() : random.point(0.5);
    const AlignedBox box{one.cwiseMin(other), one.cwiseMax(other)};
    Capsule capsule{random.point(1), random.point(1), 0.1};
    if (i % 5 == 1) capsule.to = capsule.from;
    if (i % 5 == 2) capsule.to.x() = capsule.from.x();
    if (i % 5 == 3) capsule.to = capsule.from + random.within(-1, 1) * Vector3d::UnitY();
    constexpr int kSteps = 500;
    const double found = coreDistance(capsule, box);
    const double sampled = sampledDistance(capsule, box, kSteps);
    ASSERT_LE(found, sampled + 1e-12) << i;
    ASSERT_GE(found, sampled - halfStep(capsule, kSteps)) << i;
  }
}

}  // namespace
}  // namespace cobot_command::cell
