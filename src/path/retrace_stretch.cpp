#include "retrace_stretch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cobot_command::path {
namespace {

using std::chrono::milliseconds;

/// From rest to the rate, and to rest.
constexpr Duration kRamp = milliseconds(500);
/// Of a cut, from one side to the other.
constexpr Duration kStep{1};

/// From 0 to 1 and at rest at both, of a share of the ramp's time; before and behind it as at its ends.
double risen(double share) {
  const double x = std::clamp(share, 0.0, 1.0);
  return x * x * (3 - 2 * x);
}
double slopeOf(double share) {
  const double x = std::clamp(share, 0.0, 1.0);
  return 6 * x * (1 - x);
}
/// The integral of risen(), 0 to 1/2.
double wayOf(double share) {
  return share * share * share * (1 - share / 2);
}

double inRamps(Duration time) {
  return toSeconds(time) / toSeconds(kRamp);
}

/// Where it is on its way, 0..length, by its own time.
class RetraceLaw {
 public:
  RetraceLaw(const RetraceStretch& stretch, double rate)
      : length_(std::chrono::abs(stretch.to - stretch.from)),
        duration_(durationOf(stretch, rate)),
        rate_(toSeconds(length_) / toSeconds(duration_ - kRamp)) {}

  [[nodiscard]] Duration duration() const { return duration_; }
  [[nodiscard]] double rate(Duration time) const {
    return rate_ * std::min(risen(inRamps(time)), risen(inRamps(duration_ - time)));
  }
  [[nodiscard]] Duration way(Duration time) const {
    if (time > duration_ / 2) return length_ - way(duration_ - time);
    const double ramps = time < kRamp ? wayOf(inRamps(time)) : inRamps(time) - 0.5;
    return std::min(length_, fromSeconds(rate_ * ramps * toSeconds(kRamp)));
  }
  /// When it is there, between its ramps. Precondition: it moves.
  [[nodiscard]] Duration timeOf(Duration way) const {
    return fromSeconds(toSeconds(way) / rate_) + kRamp / 2;
  }

 private:
  Duration length_;
  Duration duration_;
  double rate_;
};

/// In the ramps as close as they may be; between them where the points of the path's own PVTs were, with
/// their leads, so that its cubics are those of the path. By its own time.
std::vector<DrivenPath::Knot> knotsOf(const RetraceLaw& law, const RetraceStretch& stretch,
                                      const DrivenPath& driven, std::size_t most) {
  std::vector<DrivenPath::Knot> knots;
  const auto add = [&](Duration time) { knots.push_back({time, arm::JointVector::Zero()}); };
  for (Duration time = motion::kLeastSegment; time <= kRamp; time += motion::kLeastSegment) add(time);
  const auto [low, high] = std::minmax(stretch.from, stretch.to);
  for (const DrivenPath::Knot& knot : driven.knots(low, high, most)) {
    const Duration time = law.timeOf(std::chrono::abs(knot.time - stretch.from));
    if (time <= kRamp || time >= law.duration() - kRamp) continue;
    knots.push_back({std::chrono::round<milliseconds>(time), knot.lead});
  }
  for (Duration left = kRamp; left >= Duration::zero(); left -= motion::kLeastSegment) {
    add(law.duration() - left);
  }
  std::stable_sort(knots.begin(), knots.end(),
                   [](const auto& one, const auto& other) { return one.time < other.time; });
  std::vector<DrivenPath::Knot> kept;
  for (const DrivenPath::Knot& knot : knots) {
    const Duration before = kept.empty() ? Duration::zero() : kept.back().time;
    if (knot.time - before >= motion::kLeastSegment) kept.push_back(knot);
  }
  kept.back() = {law.duration(), arm::JointVector::Zero()};
  return kept;
}

/// On the side of a cut on which its way is.
Duration asideOf(Duration time, const std::vector<DrivenPath::Cut>& cuts, bool is_behind) {
  for (const DrivenPath::Cut& cut : cuts) {
    if (time == cut.end || time == cut.end + kStep) return is_behind ? cut.end + kStep : cut.end;
  }
  return time;
}

}  // namespace

Duration durationOf(const RetraceStretch& stretch, double rate) {
  const Duration length = std::chrono::abs(stretch.to - stretch.from);
  const Duration at_rate = fromSeconds(toSeconds(length) / rate);
  return std::chrono::ceil<milliseconds>(std::max(at_rate, kRamp) + kRamp);
}

std::vector<RetraceStretch> stretchesOf(const Retrace& retrace, const DrivenPath& driven) {
  const std::vector<DrivenPath::Cut> cuts = driven.cuts();
  const bool forth = retrace.to > retrace.from;
  const Duration from = asideOf(retrace.from, cuts, forth);
  const Duration to = asideOf(retrace.to, cuts, !forth);
  std::vector<RetraceStretch> stretches;
  stretches.push_back({from, to, retrace.start, retrace.end.value_or(driven.at(to).position)});
  const auto add = [&](const DrivenPath::Cut& cut) {
    const Duration near = forth ? cut.end : cut.end + kStep;
    const Duration far = forth ? cut.end + kStep : cut.end;
    if (near <= std::min(from, to) || near >= std::max(from, to)) return;
    if (far <= std::min(from, to) || far >= std::max(from, to)) return;
    const arm::JointVector end = std::exchange(stretches.back().end, cut.joints);
    stretches.back().to = near;
    stretches.push_back({far, to, cut.joints, end});
  };
  if (forth) {
    std::for_each(cuts.begin(), cuts.end(), add);
  } else {
    std::for_each(cuts.rbegin(), cuts.rend(), add);
  }
  return stretches;
}

std::vector<motion::PvtJointPoint> pvtOf(const RetraceStretch& stretch, double rate, const DrivenPath& driven,
                                         std::size_t most) {
  const RetraceLaw law(stretch, rate);
  const int sign = stretch.to < stretch.from ? -1 : 1;
  const arm::JointVector off_start = stretch.start - driven.at(stretch.from).position;
  const arm::JointVector off_end = stretch.end - driven.at(stretch.to).position;
  std::vector<motion::PvtJointPoint> points;
  Duration before{};
  for (const auto& [time, lead] : knotsOf(law, stretch, driven, most)) {
    const motion::JointState there = driven.at(stretch.from + sign * law.way(time));
    const double from_start = inRamps(time);
    const double to_end = inRamps(law.duration() - time);
    motion::PvtJointPoint point;
    point.position =
        there.position + lead + (1 - risen(from_start)) * off_start + (1 - risen(to_end)) * off_end;
    point.velocity = sign * law.rate(time) * there.velocity +
                     (slopeOf(to_end) * off_end - slopeOf(from_start) * off_start) / toSeconds(kRamp);
    point.duration = toSeconds(time - before);
    before = time;
    points.push_back(point);
  }
  points.back().velocity.setZero();
  return points;
}

}  // namespace cobot_command::path
