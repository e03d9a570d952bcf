#include "cobot_command/path/path_plan.h"

#include <algorithm>
#include <utility>

#include "cobot_command/motion/blend.h"

namespace cobot_command::path {

void PathPlan::append(PlannedPoint point, Duration overlap) {
  if (!points_.empty()) points_.back().overlap = overlap;
  point.start = duration() - overlap;
  points_.push_back(std::move(point));
}

PathPlan PathPlan::part(std::size_t first, std::size_t behind) const {
  if (first == behind) return PathPlan(first < points_.size() ? beginOf(first) : at(duration()).position);
  PathPlan part(beginOf(first));
  part.points_.assign(points_.begin() + static_cast<std::ptrdiff_t>(first),
                      points_.begin() + static_cast<std::ptrdiff_t>(behind));
  const Duration begin = points_[first].start;
  for (PlannedPoint& point : part.points_) point.start -= begin;
  part.points_.back().overlap = Duration::zero();
  return part;
}

arm::JointVector PathPlan::beginOf(std::size_t point) const {
  return points_[point].motion->at(Duration::zero()).position;
}

std::size_t PathPlan::begunAt(Duration time) const {
  const auto behind = std::upper_bound(points_.begin(), points_.end(), time,
                                       [](Duration at, const PlannedPoint& one) { return at < one.start; });
  return behind == points_.begin() ? 0 : static_cast<std::size_t>(behind - points_.begin()) - 1;
}

motion::JointState PathPlan::at(Duration time) const {
  if (points_.empty()) return {start_, arm::JointVector::Zero()};
  const std::size_t begun = begunAt(time);
  const PlannedPoint& point = points_[begun];
  if (begun == 0) return point.motion->at(time - point.start);
  const PlannedPoint& before = points_[begun - 1];
  return motion::stateIn(*before.motion, *point.motion, before.overlap, time - point.start);
}

PathPlan::Place PathPlan::placeAt(Duration time) const {
  const std::size_t begun = begunAt(time);
  const auto share_of = [&](std::size_t point) {
    return points_[point].motion->progress(time - points_[point].start);
  };
  if (begun > 0 && time < points_[begun - 1].end()) {
    return {begun - 1, share_of(begun - 1), true, share_of(begun)};
  }
  return {begun, share_of(begun), false, 0.0};
}

}  // namespace cobot_command::path
