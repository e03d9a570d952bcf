#include "cobot_command/motion/pvt_leads.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <variant>

#include "profiles/ramped_profile.h"

namespace cobot_command::motion {
namespace {

/// By which share of the highest acceleration a cubic may be above it, or below none.
constexpr double kAllowed = 0.005;
/// Where that does not do, so many times as much is tried.
constexpr double kMore = 1.1;
/// There it does not get further from its plan than that share of what the steepest acceleration makes of a
/// segment: in a corner it leaves its way by that.
constexpr double kFarthest = 0.015;

std::optional<RampShape> rampsOf(const Command& command) {
  return std::visit(
      [](const auto& move) -> std::optional<RampShape> {
        using Move = std::decay_t<decltype(move)>;
        if constexpr (std::is_same_v<Move, JointMove>) {
          return move.ramps;
        } else if constexpr (std::is_same_v<Move, StraightMove> || std::is_same_v<Move, ArcMove> ||
                             std::is_same_v<Move, WristMove>) {
          return move.rates.ramps;
        } else {
          return std::nullopt;
        }
      },
      command);
}

RampedProfile profileOf(const Trajectory& move, const RampShape& ramps) {
  const double up = toSeconds(move.timeUp());
  const double down = toSeconds(move.timeDown());
  return {{up, toSeconds(move.duration()) - up - down, down}, ramps};
}

/// Between two of the times. Of its cubic the speeds at both ends say the acceleration in the middle, and the
/// places how much that grows from one end to the other.
struct Segment {
  double length = 0.0;
  double middle = 0.0;
  double growth = 0.0;    ///< with the places of the move
  double highest = 0.0;   ///< acceleration of the move, at least 0
  double lowest = 0.0;    ///< likewise, at most 0
  double steepest = 0.0;  ///< what the shares of it are of

  /// It may grow by, where that share is allowed.
  [[nodiscard]] double most(double allowed) const {
    return 2.0 * std::max(0.0, std::min(highest - middle, middle - lowest) + allowed * steepest);
  }
  [[nodiscard]] double within(double allowed) const {
    return std::clamp(growth, -most(allowed), most(allowed));
  }
  /// The way that each unit of growth costs.
  [[nodiscard]] double cost() const { return length * length / 12.0; }
};
using SegmentIterator = std::vector<Segment>::const_iterator;

/// Segments of which none grows more than it may, and which together go as far as with the places of the
/// move.
class Levelled {
 public:
  Levelled(SegmentIterator begin, SegmentIterator end) : begin_(begin), end_(end) {
    for (update(); std::abs(missing_) > room_; update()) allowed_ *= kMore;
    share_ = room_ > 0.0 ? missing_ / room_ : 0.0;
  }

  [[nodiscard]] double growthOf(const Segment& segment) const {
    return segment.within(allowed_) + std::abs(share_) * towards(segment);
  }
  [[nodiscard]] bool isAsFlatAsTheMove() const { return allowed_ == kAllowed; }

 private:
  void update() {
    missing_ = room_ = 0.0;
    for (auto segment = begin_; segment != end_; ++segment) {
      missing_ += segment->cost() * (segment->growth - segment->within(allowed_));
    }
    for (auto segment = begin_; segment != end_; ++segment) {
      room_ += segment->cost() * std::abs(towards(*segment));
    }
  }
  /// What it may grow more, or less, for the others.
  [[nodiscard]] double towards(const Segment& segment) const {
    return std::copysign(segment.most(allowed_), missing_) - segment.within(allowed_);
  }

  SegmentIterator begin_;
  SegmentIterator end_;
  double allowed_ = kAllowed;
  double missing_ = 0.0;  ///< growth, times its cost
  double room_ = 0.0;
  double share_ = 0.0;
};

/// A move at its times.
class Leads {
 public:
  Leads(const RampedProfile& profile, const std::vector<Duration>& times) : profile_(profile) {
    times_.reserve(times.size());
    for (const Duration time : times) times_.push_back(std::clamp(toSeconds(time), 0.0, profile.duration()));
    addSegments(times);
    leads_.assign(times.size(), 0.0);
  }

  /// The ramps by themselves, where the cruise between them has segments of its own.
  [[nodiscard]] std::vector<double> level() {
    constexpr double kRounding = 1e-9;  // [s]
    const double top = profile_.timeUp() - kRounding;
    const double fall = profile_.duration() - profile_.timeDown() + kRounding;
    const auto up = std::lower_bound(times_.begin(), times_.end(), top) - times_.begin();
    const auto down = std::upper_bound(times_.begin(), times_.end(), fall) - times_.begin() - 1;
    const auto count = static_cast<std::ptrdiff_t>(segments_.size());
    if (up > down) {
      level(0, count);
    } else {
      level(0, up);
      level(down, count);
    }
    return std::move(leads_);
  }

 private:
  void addSegments(const std::vector<Duration>& times);
  void level(std::ptrdiff_t from, std::ptrdiff_t to) {
    const Levelled levelled(segments_.begin() + from, segments_.begin() + to);
    double ahead = 0.0;
    double farthest = 0.0;
    double most = 0.0;
    for (std::ptrdiff_t i = from; i + 1 < to; ++i) {
      const Segment& segment = segments_[static_cast<std::size_t>(i)];
      ahead += segment.cost() * (segment.growth - levelled.growthOf(segment));
      const double rate = rates_[static_cast<std::size_t>(i + 1)];
      if (rate > 0.0) leads_[static_cast<std::size_t>(i + 1)] = ahead / rate;
      farthest = std::max(farthest, std::abs(ahead));
      most = std::max(most, kFarthest * segment.length * segment.length);
    }
    most *= std::max(profile_.steepestUp(), profile_.steepestDown());
    if (levelled.isAsFlatAsTheMove() || farthest <= most) return;
    for (std::ptrdiff_t i = from; i + 1 < to; ++i) leads_[static_cast<std::size_t>(i + 1)] *= most / farthest;
  }

  const RampedProfile& profile_;
  std::vector<double> times_;  ///< within the move
  std::vector<double> rates_;
  std::vector<Segment> segments_;
  std::vector<double> leads_;
};

void Leads::addSegments(const std::vector<Duration>& times) {
  double before = profile_.progress(times_.front());
  rates_.push_back(0.0);
  segments_.reserve(times.size());
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double here = profile_.progress(times_[i]);
    rates_.push_back(times[i] >= profile_.time() ? 0.0 : profile_.rate(times_[i]));
    Segment segment;
    segment.length = toSeconds(times[i] - times[i - 1]);
    segment.middle = (rates_[i] - rates_[i - 1]) / segment.length;
    segment.growth = 6.0 * ((rates_[i - 1] + rates_[i]) * segment.length - 2.0 * (here - before)) /
                     (segment.length * segment.length);
    const bool rises = times_[i - 1] < profile_.timeUp() - 1e-9;
    const bool falls = profile_.duration() - times_[i] < profile_.timeDown() - 1e-9;
    segment.highest = rises ? profile_.steepestUp() : 0.0;
    segment.lowest = falls ? -profile_.steepestDown() : 0.0;
    segment.steepest = std::min(profile_.steepestUp(), profile_.steepestDown());
    segments_.push_back(segment);
    before = here;
  }
}

}  // namespace

std::vector<double> leadsAt(const Command& command, const Trajectory& move,
                            const std::vector<Duration>& times) {
  const auto ramps = rampsOf(command);
  if (!ramps || move.duration() == Duration::zero() || times.size() < 3) {
    return std::vector<double>(times.size(), 0.0);
  }
  const RampedProfile profile = profileOf(move, *ramps);
  return Leads(profile, times).level();
}

}  // namespace cobot_command::motion
