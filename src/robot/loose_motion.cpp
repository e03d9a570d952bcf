#include "cobot_command/robot/loose_motion.h"

#include <fmt/format.h>

namespace cobot_command::robot {
namespace {

/// A motion is seen in the stream a little after its acceptance.
constexpr Duration kBegins = std::chrono::milliseconds(500);

}  // namespace

void LooseMotion::begin(const std::optional<Target>& target, End end, Instant now) {
  if (state_ == State::None) state_ = State::Blended;
  end_ = end;
  since_ = now;
  target_ = target;
}

void LooseMotion::stopFailed(const std::string& why, const std::optional<Target>& target, Instant now) {
  state_ = State::Unstopped;
  end_ = End::Unknown;
  since_ = now;
  target_ = target;
  text_ = fmt::format("a stop was not confirmed ({}): {}", why, kMayStillMove);
}

void LooseMotion::see(const RobotWatch& robot, Instant now) {
  if (mayMove() && now - since_ > kBegins && robot.moving() == false && !robot.held()) end();
}

}  // namespace cobot_command::robot
