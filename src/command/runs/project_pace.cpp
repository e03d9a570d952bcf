#include "runs/project_pace.h"

#include <chrono>

namespace cobot_command::command {
namespace {

/// The stream has shown by then what was so at its beginning.
constexpr Duration kShown = std::chrono::milliseconds(50);

}  // namespace

std::optional<Origin> ProjectPace::see(const CommandOrder& order, const robot::RobotWatch& robot,
                                       Duration executed) {
  const auto& status = robot.status();
  if (is_seen_ || !order.plan || !order.origin || !status || !status->project_speed_percent) {
    return std::nullopt;
  }
  is_seen_ = executed >= kShown;
  const double speed = robot.speedOverride();
  if (speed == planned_for_.value_or(order.origin->start.speed_override)) return std::nullopt;
  planned_for_ = speed;
  Origin origin = *order.origin;
  origin.start.speed_override = speed;
  if (origin.behind) origin.behind->follow(origin.start);
  return origin;
}

}  // namespace cobot_command::command
