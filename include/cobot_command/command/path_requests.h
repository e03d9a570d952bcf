// What is asked of paths from outside of their goals.
#pragma once

namespace cobot_command::command {

struct TrackingSwitch {
  int object = 0;
  bool on = false;
  bool automatic = false;  ///< from now on it switches itself to what the next goal wants
};

}  // namespace cobot_command::command
