#include "cobot_command/cell/bodies/capsule.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace cobot_command::cell {
namespace {

using Eigen::Vector3d;

double squaredDistanceToSegment(const Vector3d& point, const Vector3d& from, const Vector3d& along,
                                double squared_length) {
  const Vector3d to_point = point - from;
  const double reached = to_point.dot(along);
  if (reached <= 0) return to_point.squaredNorm();
  // Also where the segment is a point, as nothing is above its length then.
  if (reached >= squared_length) return (to_point - along).squaredNorm();
  return (to_point - (reached / squared_length) * along).squaredNorm();
}

/// Of two segments, by their ends: what is left where the lines that they are of come closest beside them.
double squaredDistanceByEnds(const Capsule& a, const Capsule& b, const Vector3d& u, const Vector3d& v) {
  const double uu = u.squaredNorm();
  const double vv = v.squaredNorm();
  return std::min(
      {squaredDistanceToSegment(a.from, b.from, v, vv), squaredDistanceToSegment(a.to, b.from, v, vv),
       squaredDistanceToSegment(b.from, a.from, u, uu), squaredDistanceToSegment(b.to, a.from, u, uu)});
}

double squaredCoreDistance(const Capsule& a, const Capsule& b) {
  const Vector3d u = a.to - a.from;
  const Vector3d v = b.to - b.from;
  const Vector3d between = b.from - a.from;
  // The cross product, as it keeps its digits where the segments are next to parallel.
  const Vector3d normal = u.cross(v);
  const double area = normal.squaredNorm();
  const double s = between.cross(v).dot(normal);
  const double t = between.cross(u).dot(normal);
  const bool inside = s > 0 && s < area && t > 0 && t < area;
  if (!inside) return squaredDistanceByEnds(a, b, u, v);
  // From the place on one to the other segment, and not to the place on it: of segments that are next to
  // parallel rounding moves both along the segments by far more than it moves this distance.
  const double vv = v.squaredNorm();
  const double squared = squaredDistanceToSegment(a.from + (s / area) * u, b.from, v, vv);
  // Of parallel segments s and t are what rounding left; the ends know better.
  constexpr double kParallel = 1e-12;  // square of the sine
  if (area > kParallel * u.squaredNorm() * vv) return squared;
  return std::min(squared, squaredDistanceByEnds(a, b, u, v));
}

/// The distance of one coordinate from an interval, as it changes along a segment.
struct Excess {
  double from = 0;
  double along = 0;
  double lower = 0;
  double upper = 0;

  /// Of the coordinate at t beyond the interval; below it negative.
  [[nodiscard]] double at(double t) const {
    const double place = from + t * along;
    return place < lower ? place - lower : std::max(0.0, place - upper);
  }
};
using Excesses = std::array<Excess, 3>;

double squaredSum(const Excesses& excesses, double t) {
  double sum = 0;
  for (const Excess& excess : excesses) sum += excess.at(t) * excess.at(t);
  return sum;
}

/// Half of the derivative of squaredSum(), which never falls.
double halfSlope(const Excesses& excesses, double t) {
  double slope = 0;
  for (const Excess& excess : excesses) slope += excess.along * excess.at(t);
  return slope;
}

/// Where coordinates enter or leave their intervals within the segment, from its beginning to its end.
struct Bends {
  std::array<double, 8> at{};
  std::size_t count = 0;
};
Bends bendsOf(const Excesses& excesses) {
  Bends bends;
  bends.at[bends.count++] = 0;
  for (const Excess& excess : excesses) {
    for (const double limit : {excess.lower, excess.upper}) {
      const double t = excess.along == 0 ? 0 : (limit - excess.from) / excess.along;
      if (t > 0 && t < 1) bends.at[bends.count++] = t;
    }
  }
  bends.at[bends.count++] = 1;
  std::sort(bends.at.begin(), bends.at.begin() + bends.count);
  return bends;
}

/// Around a whole capsule.
struct Ball {
  Vector3d centre;
  double radius = 0;
};
std::vector<Ball> ballsAround(const Capsules& capsules) {
  std::vector<Ball> balls;
  balls.reserve(capsules.size());
  for (const Capsule& capsule : capsules) {
    const double half_length = 0.5 * (capsule.to - capsule.from).norm();
    balls.push_back({0.5 * (capsule.from + capsule.to), half_length + capsule.radius});
  }
  return balls;
}

/// Two that are likely to be near each other: most other pairs of two robots are farther, by their balls
/// alone.
std::pair<std::size_t, std::size_t> closestCentres(const std::vector<Ball>& first,
                                                   const std::vector<Ball>& second) {
  std::pair<std::size_t, std::size_t> closest{0, 0};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (std::size_t j = 0; j < second.size(); ++j) {
      const double squared = (first[i].centre - second[j].centre).squaredNorm();
      if (squared < least) {
        least = squared;
        closest = {i, j};
      }
    }
  }
  return closest;
}

/// So much is a pair looked at that may be farther than the nearest, for what rounding takes [m].
constexpr double kRounding = 1e-9;

/// Whether what is in the balls may be as near to each other as this, or deeper in each other.
bool mayBeWithin(double distance, const Ball& a, const Ball& b) {
  const double reach = a.radius + b.radius + distance;
  return reach > 0 && (a.centre - b.centre).squaredNorm() <= reach * reach;
}

}  // namespace

AlignedBox boxAround(const Capsules& capsules) {
  const double infinity = std::numeric_limits<double>::infinity();
  AlignedBox box{Vector3d::Constant(infinity), Vector3d::Constant(-infinity)};
  for (const Capsule& capsule : capsules) {
    const Vector3d radius = Vector3d::Constant(capsule.radius);
    box.lower = box.lower.cwiseMin(capsule.from.cwiseMin(capsule.to) - radius);
    box.upper = box.upper.cwiseMax(capsule.from.cwiseMax(capsule.to) + radius);
  }
  return box;
}

Capsule placed(const arm::Pose& frame, const Capsule& capsule) {
  return {frame * capsule.from, frame * capsule.to, capsule.radius};
}

double distanceToSegment(const Vector3d& point, const Vector3d& from, const Vector3d& to) {
  const Vector3d along = to - from;
  return std::sqrt(squaredDistanceToSegment(point, from, along, along.squaredNorm()));
}

double coreDistance(const Capsule& a, const Capsule& b) {
  return std::sqrt(squaredCoreDistance(a, b));
}

double distanceBetween(const Capsule& a, const Capsule& b) {
  return coreDistance(a, b) - a.radius - b.radius;
}

double leastDistance(const AlignedBox& a, const AlignedBox& b) {
  const double apart = (a.lower - b.upper).cwiseMax(b.lower - a.upper).cwiseMax(0.0).norm();
  return apart > 0 ? apart : -std::numeric_limits<double>::infinity();
}

double coreDistance(const Capsule& capsule, const AlignedBox& box) {
  const Vector3d along = capsule.to - capsule.from;
  Excesses excesses;
  for (Eigen::Index i = 0; i < 3; ++i) {
    excesses[static_cast<std::size_t>(i)] = {capsule.from[i], along[i], box.lower[i], box.upper[i]};
  }
  // The square is convex, and between two bends a parabola: its least value is where the slope passes zero.
  const Bends bends = bendsOf(excesses);
  double before = halfSlope(excesses, 0);
  if (before >= 0) return std::sqrt(squaredSum(excesses, 0));
  for (std::size_t i = 1; i < bends.count; ++i) {
    const double behind = halfSlope(excesses, bends.at[i]);
    if (behind >= 0) {
      const double part = before / (before - behind);
      const double t = bends.at[i - 1] + part * (bends.at[i] - bends.at[i - 1]);
      return std::sqrt(squaredSum(excesses, t));
    }
    before = behind;
  }
  return std::sqrt(squaredSum(excesses, 1));
}

Nearest nearestOf(const Capsules& first, const Capsules& second) {
  const std::vector<Ball> first_balls = ballsAround(first);
  const std::vector<Ball> second_balls = ballsAround(second);
  Nearest nearest{std::numeric_limits<double>::infinity(), 0, 0};
  if (first.empty() || second.empty()) return nearest;
  const auto [some, other] = closestCentres(first_balls, second_balls);
  double limit = distanceBetween(first[some], second[other]) + kRounding;
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (std::size_t j = 0; j < second.size(); ++j) {
      if (!mayBeWithin(limit, first_balls[i], second_balls[j])) continue;
      const double distance = distanceBetween(first[i], second[j]);
      if (distance < nearest.distance) nearest = {distance, i, j};
      limit = std::min(limit, distance + kRounding);
    }
  }
  return nearest;
}

}  // namespace cobot_command::cell
