// Whether the tool gets faster or slower, by the speeds that the status stream tells.
#pragma once

#include <chrono>
#include <deque>
#include <optional>

#include "cobot_command/common/time.h"
#include "cobot_command/link/robot_status.h"

namespace cobot_command::robot {

enum class Trend { Standing, Accelerating, Decelerating, ConstantVelocity };

class SpeedTrend {
 public:
  /// So long a change is looked at.
  static constexpr Duration kSpan = std::chrono::milliseconds(100);
  static constexpr double kChange = 0.010;  ///< in that time, that counts as one [m/s]
  static constexpr double kMoving = 0.005;  ///< above that it moves [m/s]

  void see(const link::RobotStatus& status);
  /// The stream stopped.
  void forget() { speeds_.clear(); }

  /// Nothing: the speed is not streamed, or not for long enough.
  [[nodiscard]] std::optional<Trend> trend() const;

 private:
  struct Speed {
    Instant at;
    double value;
  };
  std::deque<Speed> speeds_;  ///< the first one is as old as the span, or older
};

}  // namespace cobot_command::robot
