// Waits for the reason of an event that the script port has reported first: a tag that is `false`, or a
// connection that was closed. The status stream has its own connection, and shows the error or the emergency
// stop a frame later.
#pragma once

#include <string>

#include "cobot_command/common/time.h"

namespace cobot_command::robot {

class ReasonWait {
 public:
  /// Text for people during the wait; `what`: the end that is known so far.
  [[nodiscard]] static std::string text(const std::string& what) {
    return what + "; the status stream may show the reason";
  }

  void begin(Instant now) {
    last_ = now;
    frames_ = 0;
  }
  /// Call it for a frame without the reason. True: the wait is over. Frames that arrive together count once,
  /// because all of them may have been delayed.
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
