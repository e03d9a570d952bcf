// How long a program has waited for permits, cycle by cycle.
#pragma once

#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

#include "cobot_command/common/time.h"

namespace cobot_command::blocks {

class CycleWaits {
 public:
  /// A goal may last for months: of so many cycles it is known, the first ones are forgotten.
  static constexpr std::size_t kMost = 10000;

  void beginCycle() {
    waits_.push_back(Duration::zero());
    if (waits_.size() > kMost) waits_.pop_front();
  }
  /// Precondition: a cycle has begun.
  void add(Duration waited) { waits_.back() += waited; }
  /// By cycle, the last one maybe not whole. None is left.
  [[nodiscard]] std::vector<Duration> take() {
    const auto waits = std::exchange(waits_, {});
    return {waits.begin(), waits.end()};
  }

 private:
  std::deque<Duration> waits_;
};

}  // namespace cobot_command::blocks
