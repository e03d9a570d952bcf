#include "cobot_command/robot/stranger_watch.h"

#include <fmt/format.h>

namespace cobot_command::robot {
namespace {

/// The stream is behind, and an arm settles, for much less than that.
constexpr Duration kSettled = std::chrono::seconds(1);

}  // namespace

void StrangerWatch::see(const RobotWatch& robot, bool ours, Instant now) {
  if (ours) {
    idle_since_.reset();
  } else if (!idle_since_) {
    idle_since_ = now;
  }
  moves_ = idle_since_ && now - *idle_since_ >= kSettled && robot.moving() == true;
}

std::string StrangerWatch::text() const {
  std::string text;
  if (tag_) {
    text = fmt::format(
        "another client commands this controller: tag {} was reported, which this node did not assign",
        *tag_);
  }
  if (moves_) {
    text += fmt::format(
        "{}the robot moves though no command of this node is running: another client, the project, the "
        "pendant or a person moves it",
        text.empty() ? "" : "; ");
  }
  return text;
}

}  // namespace cobot_command::robot
