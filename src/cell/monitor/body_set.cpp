#include "monitor/body_set.h"

#include <algorithm>
#include <limits>

namespace cobot_command::cell::monitor {
namespace {

Ball ballOf(const Capsule& capsule) {
  return {0.5 * (capsule.from + capsule.to), 0.5 * (capsule.to - capsule.from).norm() + capsule.radius};
}

/// Between two balls; no capsules in them are closer.
double distanceOf(const Ball& a, const Ball& b) {
  return (a.centre - b.centre).norm() - a.radius - b.radius;
}

/// Of all pairs of bodies, the least distance and the least that it may be.
class Search {
 public:
  Search(const BodySet& first, const BodySet& second) : first_(first), second_(second) {
    gap_.distance = std::numeric_limits<double>::infinity();
    gap_.lowest = std::numeric_limits<double>::infinity();
  }

  /// A close pair first saves most of the others.
  void begin(const Gap& hint) {
    if (hint.first < first_.balls.size() && hint.second < second_.balls.size()) {
      measure(hint.first, hint.second);
    }
  }

  Gap all() {
    for (std::size_t i = 0; i < first_.balls.size(); ++i) {
      if (!matters(first_.balls[i], second_.hull, first_.growth[i] + second_.most_growth)) continue;
      for (std::size_t j = 0; j < second_.balls.size(); ++j) {
        if (matters(first_.balls[i], second_.balls[j], first_.growth[i] + second_.growth[j])) measure(i, j);
      }
    }
    return gap_;
  }

 private:
  /// Whether bodies in these balls, that grow by that, may be closer than what was found.
  [[nodiscard]] bool matters(const Ball& a, const Ball& b, double growth) const {
    // Against rounding: so much farther is looked at, too.
    constexpr double kRounding = 1e-9;
    const double reach = a.radius + b.radius + std::max(gap_.distance, gap_.lowest + growth) + kRounding;
    return reach > 0 && (a.centre - b.centre).squaredNorm() <= reach * reach;
  }

  void measure(std::size_t i, std::size_t j) {
    if (first_.fixed[i] != 0 && second_.fixed[j] != 0) return;
    const double distance = distanceBetween(first_.capsules[i], second_.capsules[j]);
    gap_.lowest = std::min(gap_.lowest, distance - first_.growth[i] - second_.growth[j]);
    if (distance >= gap_.distance) return;
    gap_.distance = distance;
    gap_.first = i;
    gap_.second = j;
  }

  const BodySet& first_;
  const BodySet& second_;
  Gap gap_;
};

}  // namespace

void BodySet::encloseAll() {
  balls.clear();
  Eigen::Vector3d lower = capsules.front().from;
  Eigen::Vector3d upper = lower;
  for (const Capsule& capsule : capsules) {
    balls.push_back(ballOf(capsule));
    lower = lower.cwiseMin(capsule.from).cwiseMin(capsule.to);
    upper = upper.cwiseMax(capsule.from).cwiseMax(capsule.to);
  }
  hull = {0.5 * (lower + upper), 0};
  for (const Capsule& capsule : capsules) {
    const double from = (capsule.from - hull.centre).norm();
    const double to = (capsule.to - hull.centre).norm();
    hull.radius = std::max(hull.radius, std::max(from, to) + capsule.radius);
  }
}

void BodySet::standStill() {
  growth.assign(capsules.size(), 0.0);
  most_growth = 0;
}

BodySet fixedSet(const Capsules& capsules) {
  BodySet set;
  set.capsules = capsules;
  set.fixed.assign(capsules.size(), 1);
  set.standStill();
  set.encloseAll();
  return set;
}

double Gap::uncertainty() const {
  // Of bodies that never move against each other both are infinite.
  return lowest < distance ? distance - lowest : 0;
}

Gap gapBetween(const BodySet& first, const BodySet& second, double exact_within, const Gap& hint) {
  const double bound = distanceOf(first.hull, second.hull);
  const double growth = first.most_growth + second.most_growth;
  if (bound - growth > exact_within) {
    Gap gap;
    gap.distance = bound;
    gap.lowest = bound - growth;
    gap.exact = false;
    gap.first = hint.first;
    gap.second = hint.second;
    return gap;
  }
  Search search(first, second);
  search.begin(hint);
  return search.all();
}

}  // namespace cobot_command::cell::monitor
