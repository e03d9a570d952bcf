// A dead man's switch: who holds it has to show again and again that he is still there.
#pragma once

#include <chrono>

namespace cobot_command::rviz_plugin {

class Grip {
 public:
  using Time = std::chrono::steady_clock::time_point;
  /// Without a tick for longer than this nothing is held any more, until the next tick.
  static constexpr std::chrono::milliseconds kPatience{100};

  void take(Time now) {
    taken_ = true;
    ticked_ = now;
  }
  void tick(Time now) { ticked_ = now; }
  void letGo() { taken_ = false; }

  [[nodiscard]] bool isTaken() const { return taken_; }
  [[nodiscard]] bool holds(Time now) const { return taken_ && now - ticked_ <= kPatience; }

 private:
  bool taken_ = false;
  Time ticked_{};
};

}  // namespace cobot_command::rviz_plugin
