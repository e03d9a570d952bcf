// How long the reason is awaited of what the script port told first: a tag that is `false`, a connection that
// was closed. The status stream, a connection of its own, shows the error or the emergency stop a frame
// later.
#pragma once

#include <string>

#include "cobot_command/common/time.h"

namespace cobot_command::robot {

class ReasonWait {
 public:
  /// For people, while it lasts; `what`: has ended, as far as it is known.
  [[nodiscard]] static std::string text(const std::string& what) {
    return what + "; the status stream may tell why";
  }

  void begin(Instant now) {
    last_ = now;
    frames_ = 0;
  }
  /// A frame without the reason. True: no more are awaited. Those that come in one piece count once, as they
  /// may all have been on their way for long.
  [[nodiscard]] bool endsWithFrame(Instant now) {
    if (now > last_) ++frames_;
    last_ = now;
    return frames_ >= kFrames;
  }

 private:
  static constexpr int kFrames = 3;
  Instant last_{};
  int frames_ = 0;
};

}  // namespace cobot_command::robot
