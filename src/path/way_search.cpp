#include "way_search.h"

#include <algorithm>
#include <utility>

namespace cobot_command::path {
namespace {

constexpr Duration kSearchStep = std::chrono::milliseconds(10);
constexpr Duration kFinest = std::chrono::microseconds(5);
/// Where a way turns round it is next to itself: of places within that the nearest one counts.
constexpr Duration kTurn = std::chrono::milliseconds(500);
/// By which a joint may leave the chord of a step [rad]: 40 rad/s^2 do.
constexpr double kSagitta = 5e-4;
constexpr int kStepsBetweenQuestions = 256;

/// Of the joint that is farthest off the chord [rad].
double gapToChord(const arm::JointVector& joints, const arm::JointVector& a, const arm::JointVector& b) {
  const arm::JointVector chord = b - a;
  const double length = chord.squaredNorm();
  const double share = length > 0 ? std::clamp(chord.dot(joints - a) / length, 0.0, 1.0) : 0.0;
  return (a + share * chord - joints).cwiseAbs().maxCoeff();
}

class WaySearch {
 public:
  WaySearch(const DrivenPath& driven, const arm::JointVector& joints, const WaySpan& span)
      : driven_(driven), joints_(joints), span_(span) {}

  /// From there to a step further, or back; nothing: the joints are not on that.
  [[nodiscard]] std::optional<Duration> onStep(Duration from, Duration step) const {
    const Duration to = within(from + step);
    if (gapToChord(joints_, at(from), at(to)) > DrivenPath::kSamePlace + kSagitta) return std::nullopt;
    const Duration nearest = downhill(from + (to - from) / 2);
    return isAt(nearest) ? std::optional(nearest) : std::nullopt;
  }
  [[nodiscard]] Duration nearestAbout(Duration place) const;
  [[nodiscard]] Duration within(Duration time) const { return std::clamp(time, span_.from, span_.until); }

 private:
  [[nodiscard]] arm::JointVector at(Duration time) const { return driven_.at(time).position; }
  [[nodiscard]] double gapAt(Duration time) const { return (at(time) - joints_).norm(); }
  [[nodiscard]] bool isAt(Duration time) const { return DrivenPath::isSamePlace(at(time), joints_); }
  [[nodiscard]] Duration downhill(Duration time) const;

  const DrivenPath& driven_;
  const arm::JointVector& joints_;
  WaySpan span_;
};

Duration WaySearch::downhill(Duration time) const {
  double gap = gapAt(time);
  for (Duration step = kSearchStep / 2; step >= kFinest;) {
    const Duration before = within(time - step);
    const Duration behind = within(time + step);
    const double gap_before = gapAt(before);
    const double gap_behind = gapAt(behind);
    if (std::min(gap_before, gap_behind) >= gap) {
      step /= 2;
      continue;
    }
    time = gap_before <= gap_behind ? before : behind;
    gap = std::min(gap_before, gap_behind);
  }
  return time;
}

Duration WaySearch::nearestAbout(Duration place) const {
  Duration nearest = place;
  for (Duration from = within(place - kTurn); from < within(place + kTurn); from += kSearchStep) {
    const auto other = onStep(from, kSearchStep);
    if (other && gapAt(*other) < gapAt(nearest)) nearest = *other;
  }
  return nearest;
}

}  // namespace

std::optional<Duration> placeBetween(const DrivenPath& driven, const arm::JointVector& joints,
                                     const WaySpan& span, Duration around,
                                     const std::function<bool()>& give_up) {
  const WaySearch search(driven, joints, span);
  Duration front = around;
  Duration back = around;
  for (int steps = 1; steps == 1 || front < span.until || back > span.from; ++steps) {
    for (const auto& [place, step] : {std::pair(front, kSearchStep), std::pair(back, -kSearchStep)}) {
      if (const auto found = search.onStep(place, step)) return search.nearestAbout(*found);
    }
    front = search.within(front + kSearchStep);
    back = search.within(back - kSearchStep);
    if (steps % kStepsBetweenQuestions == 0 && give_up && give_up()) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace cobot_command::path
