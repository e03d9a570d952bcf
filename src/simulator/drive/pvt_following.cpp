#include "drive/pvt_following.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace cobot_command::simulator {

namespace {

class Straight final : public motion::Trajectory {
 public:
  Straight(motion::TrajectoryPtr path, const std::vector<Duration>& times) : path_(std::move(path)) {
    corners_.push_back({Duration::zero(), path_->at(Duration::zero()).position});
    for (const Duration time : times) add(std::min(time, path_->duration()));
    add(path_->duration());
  }

  [[nodiscard]] Duration duration() const override { return path_->duration(); }
  [[nodiscard]] Duration timeUp() const override { return path_->timeUp(); }
  [[nodiscard]] Duration timeDown() const override { return path_->timeDown(); }
  [[nodiscard]] motion::JointState at(Duration time) const override {
    if (time >= duration()) return path_->end();
    const auto later = std::upper_bound(corners_.begin() + 1, corners_.end(), time,
                                        [](Duration at, const Corner& corner) { return at < corner.time; });
    const Corner& from = *(later - 1);
    const double duration = toSeconds(later->time - from.time);
    const arm::JointVector velocity = (later->position - from.position) / duration;
    return {from.position + velocity * toSeconds(std::max(time - from.time, Duration::zero())), velocity};
  }

 private:
  struct Corner {
    Duration time;
    arm::JointVector position;
  };

  /// Straight from corner to corner.
  [[nodiscard]] Result<motion::JointRange, motion::Unbounded> rangeWithin(Duration from,
                                                                          Duration to) const override {
    motion::JointRange range = motion::JointRange::of(at(from).position);
    range.include(at(to).position);
    auto corner = std::upper_bound(corners_.begin(), corners_.end(), from,
                                   [](Duration at, const Corner& one) { return at < one.time; });
    for (; corner != corners_.end() && corner->time < to; ++corner) range.include(corner->position);
    return range;
  }

  void add(Duration time) {
    if (time > corners_.back().time) corners_.push_back({time, path_->at(time).position});
  }

  motion::TrajectoryPtr path_;
  std::vector<Corner> corners_;
};

class Late final : public motion::Trajectory {
 public:
  Late(motion::TrajectoryPtr path, Duration lag) : path_(std::move(path)), lag_(lag) {}

  [[nodiscard]] Duration duration() const override { return path_->duration() + lag_; }
  [[nodiscard]] Duration timeUp() const override { return path_->timeUp(); }
  [[nodiscard]] Duration timeDown() const override { return path_->timeDown(); }
  [[nodiscard]] motion::JointState at(Duration time) const override {
    if (time >= lag_) return path_->at(time - lag_);
    return {path_->at(Duration::zero()).position, arm::JointVector::Zero()};
  }

 private:
  [[nodiscard]] Result<motion::JointRange, motion::Unbounded> rangeWithin(Duration from,
                                                                          Duration to) const override {
    return path_->jointRange(from - lag_, to - lag_);
  }

  motion::TrajectoryPtr path_;
  Duration lag_;
};

}  // namespace

motion::TrajectoryPtr straightBetween(const motion::TrajectoryPtr& path, const std::vector<Duration>& times) {
  return path->duration() > Duration::zero() ? std::make_shared<Straight>(path, times) : path;
}

motion::TrajectoryPtr behind(const motion::TrajectoryPtr& path, Duration lag) {
  return lag > Duration::zero() ? std::make_shared<Late>(path, lag) : path;
}

}  // namespace cobot_command::simulator
