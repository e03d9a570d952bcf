// Time that a program has waited for permits, for each cycle.
#pragma once

#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

#include "cobot_command/common/time.h"

namespace cobot_command::blocks {

class CycleWaits {
 public:
  /// Number of cycles that are kept. Older ones are dropped, because a goal may run for months.
  static constexpr std::size_t kMost = 10000;

  void beginCycle() {
    waits_.push_back(Duration::zero());
    if (waits_.size() > kMost) waits_.pop_front();
  }
  /// Precondition: a cycle has begun.
  void add(Duration waited) { waits_.back() += waited; }
  /// One value for each cycle; the last cycle may be incomplete. The record is empty afterwards.
  [[nodiscard]] std::vector<Duration> take() {
    const auto waits = std::exchange(waits_, {});
    return {waits.begin(), waits.end()};
  }

 private:
  std::deque<Duration> waits_;
};

}  // namespace cobot_command::blocks
