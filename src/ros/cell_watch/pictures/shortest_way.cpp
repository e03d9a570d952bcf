#include "cell_watch/pictures/shortest_way.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace cobot_command::ros_adapter {
namespace {

using Eigen::Vector3d;

bool isMover(const WatchView& view, const std::string& name) {
  return std::any_of(view.movers.begin(), view.movers.end(),
                     [&](const WatchView::Mover& mover) { return mover.name == name; });
}

/// The bodies of that name of that thing, where they were measured.
cell::Capsules bodiesOf(const WatchView& view, const std::string& thing, const std::string& name) {
  cell::Capsules found;
  for (const cell::SeenBodies& seen : view.bodies) {
    for (std::size_t body = 0; seen.name == thing && body < seen.capsules.size(); ++body) {
      if (seen.body_names[body] == name) found.push_back(seen.capsules[body]);
    }
  }
  return found;
}

Vector3d nearestOn(const cell::Capsule& core, const Vector3d& point) {
  const Vector3d along = core.to - core.from;
  const double length = along.squaredNorm();
  const double part = length > 0 ? std::clamp((point - core.from).dot(along) / length, 0.0, 1.0) : 0.0;
  return core.from + part * along;
}

/// On both cores. Where the lines through them are closest, if that is on both; else one end is closest.
std::pair<Vector3d, Vector3d> nearestOnCores(const cell::Capsule& a, const cell::Capsule& b) {
  const Vector3d u = a.to - a.from;
  const Vector3d v = b.to - b.from;
  std::vector<Vector3d> on_first{a.from, a.to, nearestOn(a, b.from), nearestOn(a, b.to)};
  const Vector3d normal = u.cross(v);
  if (const double area = normal.squaredNorm(); area > 0) {
    const double part = (b.from - a.from).cross(v).dot(normal) / area;
    on_first.emplace_back(a.from + std::clamp(part, 0.0, 1.0) * u);
  }
  std::pair<Vector3d, Vector3d> nearest{a.from, nearestOn(b, a.from)};
  for (const Vector3d& point : on_first) {
    const Vector3d other = nearestOn(b, point);
    if ((point - other).norm() < (nearest.first - nearest.second).norm()) nearest = {point, other};
  }
  return nearest;
}

const cell::PairStatus* closestPair(const WatchView& view) {
  const cell::PairStatus* closest = nullptr;
  for (const cell::PairStatus& pair : view.status.pairs) {
    if (!pair.known || !pair.exact || !isMover(view, pair.second)) continue;
    if (closest == nullptr || pair.distance < closest->distance) closest = &pair;
  }
  return closest;
}

}  // namespace

std::optional<ShortestWay> shortestWay(const WatchView& view) {
  const cell::PairStatus* const pair = closestPair(view);
  if (pair == nullptr) return std::nullopt;
  const cell::Capsules here = bodiesOf(view, pair->first, pair->first_body);
  const cell::Capsules there = bodiesOf(view, pair->second, pair->second_body);
  if (here.empty() || there.empty()) return std::nullopt;
  const cell::Nearest nearest = cell::nearestOf(here, there);
  auto [from, to] = nearestOnCores(here[nearest.first], there[nearest.second]);
  // From surface to surface, where they do not reach into each other.
  const Vector3d way = to - from;
  if (nearest.distance > 0) {
    const Vector3d direction = way.normalized();
    from += here[nearest.first].radius * direction;
    to -= there[nearest.second].radius * direction;
  }
  return ShortestWay{from, to, nearest.distance, pair->breached};
}

}  // namespace cobot_command::ros_adapter
