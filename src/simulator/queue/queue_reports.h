// What the queue has to tell, in order, and the tags that a fault reports too late.
#pragma once

#include <utility>
#include <vector>

#include "queue/queue_entry.h"

#include "cobot_command/simulator/fault_switches.h"

namespace cobot_command::simulator {

class QueueReports {
 public:
  /// `stale_tag`: are tags that are dropped reported with the next motion?
  explicit QueueReports(FaultSwitch& stale_tag) : stale_tag_(stale_tag) {}

  void add(QueueEvent event) { events_.push_back(std::move(event)); }
  void settle(const std::vector<QueuedTag>& tags, bool complete) {
    for (const QueuedTag& tag : tags) events_.emplace_back(TagSettled{tag, complete});
  }
  void drop(const std::vector<QueuedTag>& tags) {
    for (const QueuedTag& tag : tags) events_.emplace_back(TagDropped{tag});
  }
  /// The same, unless the fault keeps them.
  void dropOrKeep(const std::vector<QueuedTag>& tags) {
    if (tags.empty() || !stale_tag_.take()) return drop(tags);
    stale_.insert(stale_.end(), tags.begin(), tags.end());
  }
  void settleKept() { settle(std::exchange(stale_, {}), true); }
  void forgetKept() { stale_.clear(); }

  [[nodiscard]] std::vector<QueueEvent> take() { return std::exchange(events_, {}); }

 private:
  FaultSwitch& stale_tag_;
  std::vector<QueuedTag> stale_;
  std::vector<QueueEvent> events_;
};

}  // namespace cobot_command::simulator
