#include "cobot_command/path/retrace.h"

#include <algorithm>

#include "retrace_stretch.h"
#include "way_search.h"

namespace cobot_command::path {
namespace {

/// Between two places whose distance is told.
constexpr Duration kSpacing = std::chrono::milliseconds(10);
constexpr int kMostPlaces = 2000;

WaySpan spanOf(const DrivenPath& driven) {
  return {driven.begin(), driven.farthest()};
}

WayMiss missAt(const arm::JointVector& place, const arm::JointVector& joints) {
  WayMiss miss;
  miss.gap = (place - joints).cwiseAbs().maxCoeff(&miss.joint);
  return miss;
}

}  // namespace

std::optional<Duration> placeOn(const DrivenPath& driven, const arm::JointVector& joints,
                                const std::function<bool()>& give_up) {
  if (driven.isEmpty()) return std::nullopt;
  const WaySpan span = spanOf(driven);
  return placeBetween(driven, joints, span, std::clamp(driven.last(), span.from, span.until), give_up);
}

WayMiss missOf(const DrivenPath& driven, const arm::JointVector& joints) {
  const WaySpan span = spanOf(driven);
  const Duration spacing = std::max(kSpacing, (span.until - span.from) / kMostPlaces);
  WayMiss nearest = missAt(driven.at(span.until).position, joints);
  for (Duration time = span.from; time < span.until; time += spacing) {
    const WayMiss miss = missAt(driven.at(time).position, joints);
    if (miss.gap < nearest.gap) nearest = miss;
  }
  return nearest;
}

Duration durationOf(const Retrace& retrace, const DrivenPath& driven) {
  Duration duration{};
  for (const RetraceStretch& stretch : stretchesOf(retrace, driven)) {
    duration += durationOf(stretch, retrace.rate);
  }
  return duration;
}

std::optional<std::vector<motion::PvtJointPoint>> pvtOf(const Retrace& retrace, const DrivenPath& driven,
                                                        std::size_t most) {
  std::vector<motion::PvtJointPoint> points;
  for (const RetraceStretch& stretch : stretchesOf(retrace, driven)) {
    const auto more = pvtOf(stretch, retrace.rate, driven, most - points.size() + 1);
    points.insert(points.end(), more.begin(), more.end());
    if (points.size() > most) return std::nullopt;
  }
  return points;
}

}  // namespace cobot_command::path
