// The life sign of the controller: how often it is asked for, and until when the next frame has to come.
#pragma once

#include <algorithm>
#include <chrono>
#include <optional>

#include "cobot_command/common/time.h"

namespace cobot_command::command {

class LifeSign {
 public:
  /// Between two questions, so that one may be lost: a third of the limit, but not below 5 ms.
  [[nodiscard]] static Duration periodOf(Duration limit) {
    return std::max<Duration>(std::chrono::milliseconds(5), limit / 3);
  }

  /// From now on it has to come in time, whatever was before.
  void begin(Duration limit, Instant now) {
    limit_ = limit;
    last_ = now;
    worst_ = Duration::zero();
  }
  /// Another limit; what was heard stays.
  void change(Duration limit) { limit_ = limit; }
  void end() { limit_.reset(); }

  /// When the last frame came; it may be told again.
  void heard(Instant at) {
    if (at <= last_) return;
    worst_ = std::max(worst_, at - last_);
    last_ = at;
  }
  /// Nothing: it is not watched.
  [[nodiscard]] std::optional<Instant> deadline() const {
    return limit_ ? std::optional(last_ + *limit_) : std::nullopt;
  }
  [[nodiscard]] Duration worstGap() const { return worst_; }

 private:
  std::optional<Duration> limit_;
  Instant last_{};
  Duration worst_{};
};

}  // namespace cobot_command::command
