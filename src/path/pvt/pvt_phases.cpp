#include "pvt/pvt_phases.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace cobot_command::path {
namespace {

constexpr Duration kMillisecond = std::chrono::milliseconds(1);
constexpr double kNever = std::numeric_limits<double>::infinity();

Duration wholeMilliseconds(Duration time) {
  return time - time % kMillisecond;
}

/// Equal to within a millisecond.
void divideEvenly(Duration from, Duration to, Duration segment, std::vector<Duration>& ends) {
  const auto count = std::max<Duration::rep>(1, (to - from) / segment);
  const Duration::rep whole = (to - from) / kMillisecond;
  for (Duration::rep i = 1; i <= count; ++i) ends.push_back(from + whole * i / count * kMillisecond);
}

/// By how much a cubic over `length` misses a unit jump of the acceleration within it, at most: the closed
/// form of the Hermite cubic of (t - at)^2 / 2 behind the jump.
double missOf(Duration at, Duration length) {
  const double share = toSeconds(std::min(at, length - at)) / toSeconds(length);
  const double left = 1.0 - 1.5 * share;
  const double miss = 4.0 / 27.0 * share * left * left * left / ((1.0 - share) * (1.0 - share));
  return miss * toSeconds(length) * toSeconds(length);
}

double missOf(const PvtPhase& phase, const std::vector<Duration>& ends) {
  double miss = 0.0;
  for (const Duration kink : phase.kinks) {
    const auto end = std::lower_bound(ends.begin(), ends.end(), kink);
    const Duration begin = end == ends.begin() ? phase.begin : *(end - 1);
    if (kink > begin) miss += missOf(kink - begin, *end - begin);
  }
  return miss;
}

/// With a segment of its own at the front, at the back or at both, so that what misses a kink is short.
std::vector<Duration> dividedAround(const PvtPhase& phase, Duration segment) {
  std::vector<Duration> best;
  divideEvenly(phase.begin, phase.end, segment, best);
  double least = missOf(phase, best);
  constexpr std::array<std::pair<int, int>, 3> kEnds{{{1, 0}, {0, 1}, {1, 1}}};
  for (const auto& [front, back] : kEnds) {
    const Duration from = phase.begin + front * segment;
    const Duration to = phase.end - back * segment;
    if (to - from < segment && to != from) continue;
    std::vector<Duration> ends;
    if (front == 1) ends.push_back(from);
    if (to != from) divideEvenly(from, to, segment, ends);
    if (back == 1) ends.push_back(phase.end);
    if (const double miss = missOf(phase, ends); miss < least) {
      least = miss;
      best = std::move(ends);
    }
  }
  return best;
}

/// The way of one point on which no other one moves the arm: where that begins and ends, and between them the
/// ends of its ramps. In order.
class LonelyWay {
 public:
  LonelyWay(const PathPlan& plan, std::size_t point, bool is_first, bool is_last)
      : is_first_(is_first), is_last_(is_last) {
    const PlannedPoint& own = plan.points()[point];
    const Duration front = is_first ? Duration::zero() : plan.points()[point - 1].overlap;
    const Duration back = is_last ? Duration::zero() : own.overlap;
    before_ = own.start;
    behind_ = own.end();
    edges_ = {own.start + front, own.start + own.motion->timeUp(), own.end() - own.motion->timeDown(),
              own.end() - back};
    for (Duration& edge : edges_) edge = wholeMilliseconds(edge);
    std::sort(edges_.begin(), edges_.end());
  }

  [[nodiscard]] const std::array<Duration, 4>& edges() const { return edges_; }
  /// Of the edges those, at least `segment` apart, with which the cubics miss the least.
  [[nodiscard]] std::vector<Duration> kept(Duration segment) const {
    std::vector<Duration> distinct(edges_.begin(), edges_.end());
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
    if (areApart(distinct, segment)) return distinct;
    std::vector<Duration> best = distinct;
    double least = kNever;
    for (unsigned chosen = (1U << distinct.size()) - 1; chosen > 0; --chosen) {
      std::vector<Duration> some;
      for (std::size_t i = 0; i < distinct.size(); ++i) {
        if ((chosen >> i & 1U) != 0) some.push_back(distinct[i]);
      }
      if (const double miss = missWith(some, segment); miss < least) {
        least = miss;
        best = std::move(some);
      }
    }
    return best;
  }

 private:
  [[nodiscard]] static bool areApart(const std::vector<Duration>& times, Duration segment) {
    return std::adjacent_find(times.begin(), times.end(),
                              [&](Duration a, Duration b) { return b - a < segment; }) == times.end();
  }
  [[nodiscard]] double missWith(const std::vector<Duration>& times, Duration segment) const {
    if ((is_first_ && times.front() != edges_.front()) || (is_last_ && times.back() != edges_.back())) {
      return kNever;
    }
    std::vector<Duration> all{times};
    if (!is_first_) all.insert(all.begin(), before_);
    if (!is_last_) all.push_back(behind_);
    if (!areApart(all, segment)) return kNever;
    double miss = 0.0;
    for (std::size_t i = 1; i < all.size(); ++i) {
      PvtPhase phase{all[i - 1], all[i]};
      for (const Duration edge : edges_) {
        if (edge > phase.begin && edge < phase.end) phase.kinks.push_back(edge);
      }
      miss += missOf(phase, segmentsOf(phase, segment));
    }
    return miss;
  }

  bool is_first_;
  bool is_last_;
  Duration before_{};  ///< where the overlap in front of it begins
  Duration behind_{};  ///< where the one behind it ends
  std::array<Duration, 4> edges_{};
};

struct Anchor {
  Duration time{};
  std::size_t point = 0;
};

/// Room for `end`: with longer segments than overlaps are, neighbours may be too near.
void add(std::vector<Anchor>& anchors, const Anchor& anchor, bool is_end, Duration segment) {
  if (!anchors.empty() && anchor.time - anchors.back().time < segment) {
    if (!is_end) return;
    if (anchors.size() > 1) anchors.pop_back();
  }
  anchors.push_back(anchor);
}

}  // namespace

std::vector<PvtPhase> phasesOf(const PathPlan& plan, std::size_t first, std::size_t last, Duration segment) {
  while (last > first && plan.points()[last].motion->duration() == Duration::zero()) --last;
  std::vector<Anchor> anchors;
  std::vector<Duration> edges;
  for (std::size_t point = first; point <= last; ++point) {
    const LonelyWay way(plan, point, point == first, point == last);
    const std::vector<Duration> kept = way.kept(segment);
    for (std::size_t i = 0; i < kept.size(); ++i) {
      add(anchors, {kept[i], point}, point == last && i + 1 == kept.size(), segment);
    }
    edges.insert(edges.end(), way.edges().begin(), way.edges().end());
  }
  std::vector<PvtPhase> phases;
  auto edge = edges.begin();
  for (std::size_t i = 1; i < anchors.size(); ++i) {
    PvtPhase phase{anchors[i - 1].time, anchors[i].time, anchors[i].point};
    for (; edge != edges.end() && *edge < phase.end; ++edge) {
      if (*edge > phase.begin) phase.kinks.push_back(*edge);
    }
    phases.push_back(std::move(phase));
  }
  return phases;
}

std::vector<Duration> segmentsOf(const PvtPhase& phase, Duration segment) {
  if (!phase.kinks.empty()) return dividedAround(phase, segment);
  std::vector<Duration> ends;
  divideEvenly(phase.begin, phase.end, segment, ends);
  return ends;
}

}  // namespace cobot_command::path
