#include "cobot_command/path/path_preview.h"

#include <algorithm>

#include "cobot_command/arm/forward_kinematics.h"

namespace cobot_command::path {
namespace {

constexpr Duration kDrawnStep = std::chrono::milliseconds(20);
/// Of a path with many points each has fewer places: it is looked at as a whole.
constexpr std::size_t kMostPlaces = 4000;
constexpr std::size_t kLeastPlaces = 4;  // of a point

class Preview {
 public:
  Preview(const PathPlan& plan, std::size_t first, const arm::ArmModel& arm)
      : plan_(plan), first_(first), arm_(arm) {}

  [[nodiscard]] PathPreview make() const {
    PathPreview preview;
    const std::size_t count = plan_.points().size();
    for (std::size_t i = first_; i < count; ++i) {
      preview.points.push_back(point(plan_.points()[i]));
      const bool moves_another =
          i > first_ && !plan_.points()[i].moved_frame.isApprox(plan_.points()[i - 1].moved_frame);
      if (i == first_ || moves_another) preview.lines.emplace_back();
      extend(preview.lines.back(), i);
    }
    return preview;
  }

 private:
  [[nodiscard]] Eigen::Vector3d placeOf(const PlannedPoint& point, const arm::JointVector& joints) const {
    return (arm::forwardKinematics(arm_, joints) * point.moved_frame).translation();
  }

  [[nodiscard]] PathPreview::Point point(const PlannedPoint& planned) const {
    PathPreview::Point point;
    point.index = planned.index;
    point.place = placeOf(planned, planned.motion->end().position);
    if (planned.overlap > Duration::zero()) {
      const auto leaves = planned.motion->at(planned.motion->duration() - planned.overlap);
      point.blend = (placeOf(planned, leaves.position) - point.place).norm();
    }
    return point;
  }

  /// From its begin to that of the next one.
  void extend(PathPreview::Line& line, std::size_t index) const {
    const PlannedPoint& point = plan_.points()[index];
    const bool is_last = index + 1 == plan_.points().size();
    const Duration end = is_last ? plan_.duration() : plan_.points()[index + 1].start;
    const std::size_t most = std::max(kLeastPlaces, kMostPlaces / (plan_.points().size() - first_));
    const auto steps = std::clamp<Duration::rep>((end - point.start) / kDrawnStep, 1, static_cast<int>(most));
    for (Duration::rep step = line.empty() ? 0 : 1; step <= steps; ++step) {
      const Duration time = point.start + (end - point.start) * step / steps;
      line.push_back(placeOf(point, plan_.at(time).position));
    }
  }

  const PathPlan& plan_;
  std::size_t first_;
  const arm::ArmModel& arm_;
};

}  // namespace

PathPreview previewOf(const PathPlan& plan, std::size_t first, const arm::ArmModel& arm) {
  return Preview(plan, first, arm).make();
}

}  // namespace cobot_command::path
