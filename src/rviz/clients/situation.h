// What may keep a robot from doing what it is told, and whether a refusal is still of that.
#pragma once

#include <array>

namespace cobot_command::rviz_plugin {

/// Whether there is a command node, its link, emergency stop, error, safeguard and pause.
using Situation = std::array<int, 6>;

/// A message about a refusal goes when its cause has gone: the situation is another one than when it came.
class Validity {
 public:
  /// A refusal came.
  void begin() { looks_ = 0; }
  /// Once a look.
  [[nodiscard]] bool isOver(const Situation& now) {
    if (looks_ >= kSettled) return now != then_;
    ++looks_;
    then_ = now;
    return false;
  }

 private:
  static constexpr int kSettled = 5;  ///< the status of the robot may come after the refusal

  int looks_ = 0;
  Situation then_{};
};

}  // namespace cobot_command::rviz_plugin
