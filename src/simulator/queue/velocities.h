// The mode in which the arm takes velocities, of one kind, and when it ends by itself.
#pragma once

#include <algorithm>
#include <optional>

#include "queue/queue_entry.h"

#include "cobot_command/common/time.h"

namespace cobot_command::simulator {

class Velocities {
 public:
  void begin(const VelocityMode& mode, Instant now) {
    mode_ = mode;
    ends_at_ = mode.time_to_end ? now + *mode.time_to_end : Instant::max();
  }
  /// A velocity has come: the time to the end begins anew.
  void renew(Instant now) {
    if (mode_ && mode_->time_to_end) ends_at_ = now + *mode_->time_to_end;
  }
  /// Once the arm is at rest.
  void endAt(Instant now) { ends_at_ = now; }
  void drop() { mode_.reset(); }

  [[nodiscard]] bool on() const { return mode_.has_value(); }
  [[nodiscard]] bool takes(bool of_tcp) const { return mode_ && mode_->of_tcp == of_tcp; }
  /// Instant::max(): not by itself, or there is no mode.
  [[nodiscard]] Instant endsAt() const { return mode_ ? ends_at_ : Instant::max(); }
  /// For how long the arm keeps a velocity that nobody renews; absent: for good.
  [[nodiscard]] std::optional<Duration> lasting() const {
    if (!mode_) return std::nullopt;
    const auto& rest = mode_->time_to_rest;
    const auto& end = mode_->time_to_end;
    if (rest && end) return std::min(*rest, *end);
    return rest ? rest : end;
  }

 private:
  std::optional<VelocityMode> mode_;
  Instant ends_at_{};
};

}  // namespace cobot_command::simulator
