// Whether the tool accelerates or decelerates, from the speeds in the status stream.
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
  /// Time span in which a change is measured.
  static constexpr Duration kSpan = std::chrono::milliseconds(100);
  static constexpr double kChange = 0.010;  ///< smallest speed change in that time that counts [m/s]
  static constexpr double kMoving = 0.005;  ///< above this speed the tool moves [m/s]

  void see(const link::RobotStatus& status);
  /// The stream stopped.
  void forget() { speeds_.clear(); }

  /// nullopt: the speed is not streamed, or not for long enough.
  [[nodiscard]] std::optional<Trend> trend() const;

 private:
  struct Speed {
    Instant at;
    double value;
  };
  std::deque<Speed> speeds_;  ///< the first one is at least as old as the span
};

}  // namespace cobot_command::robot
