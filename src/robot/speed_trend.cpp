#include "cobot_command/robot/speed_trend.h"

namespace cobot_command::robot {

void SpeedTrend::see(const link::RobotStatus& status) {
  if (!status.tool_speed) {
    forget();
    return;
  }
  speeds_.push_back({status.received, *status.tool_speed});
  while (speeds_.size() > 1 && speeds_[1].at + kSpan <= status.received) speeds_.pop_front();
}

std::optional<Trend> SpeedTrend::trend() const {
  if (speeds_.empty() || speeds_.front().at + kSpan > speeds_.back().at) return std::nullopt;
  const double change = speeds_.back().value - speeds_.front().value;
  if (change > kChange) return Trend::Accelerating;
  if (change < -kChange) return Trend::Decelerating;
  return speeds_.back().value > kMoving ? Trend::ConstantVelocity : Trend::Standing;
}

}  // namespace cobot_command::robot
