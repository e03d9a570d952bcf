#include "cobot_command/path/retrace.h"

#include <algorithm>

#include "retrace_stretch.h"
#include "way_search.h"

namespace cobot_command::path {
namespace {

/// The robot may have been moved on behind what was seen of it last.
constexpr Duration kFurther = std::chrono::seconds(3);

}  // namespace

std::optional<Duration> placeOn(const DrivenPath& driven, const arm::JointVector& joints,
                                const std::function<bool()>& give_up) {
  if (driven.isEmpty()) return std::nullopt;
  const WaySpan span{driven.begin(), std::min(driven.end(), driven.reached() + kFurther)};
  return placeBetween(driven, joints, span, std::clamp(driven.last(), span.from, span.until), give_up);
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
