// The points of a PVT, from PVTEnter to PVTExit, and what is queued between them.
#pragma once

#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "queue/queue_entry.h"

namespace cobot_command::simulator {

class PvtRecorder {
 public:
  void open(bool cartesian) { open_.emplace(Open{{cartesian, {}}, {}, 0.0}); }
  [[nodiscard]] bool isOpen() const { return open_.has_value(); }

  // --- While it is open.
  void add(const script::PvtPoint& point) {
    open_->block.points.push_back(point);
    open_->time += point.duration;
  }
  /// It acts when the arm is at the last point.
  void add(QueueEntry between) {
    open_->between.emplace_back(PvtMark{open_->time});
    open_->between.push_back(std::move(between));
  }
  /// The whole: one motion, and behind it what is between, each behind its mark.
  [[nodiscard]] std::vector<QueueEntry> close() {
    std::vector<QueueEntry> all{MotionRequest(std::move(open_->block))};
    std::vector<QueueEntry> between = giveUp();
    all.insert(all.end(), std::move_iterator(between.begin()), std::move_iterator(between.end()));
    return all;
  }

  /// What was between its points; nothing when it is not open.
  [[nodiscard]] std::vector<QueueEntry> giveUp() {
    if (!open_) return {};
    Open given_up = *std::exchange(open_, std::nullopt);
    return std::move(given_up.between);
  }
  [[nodiscard]] std::size_t points() const { return open_ ? open_->block.points.size() : 0; }
  /// Entries between the points.
  [[nodiscard]] std::size_t size() const { return open_ ? open_->between.size() : 0; }

 private:
  struct Open {
    planning::PvtBlock block;
    std::vector<QueueEntry> between;
    double time = 0.0;  // of the last point [s]
  };

  std::optional<Open> open_;
};

}  // namespace cobot_command::simulator
