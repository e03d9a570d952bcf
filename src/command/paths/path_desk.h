// What paths are controlled by from outside of their goals: kept, changed and told.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cobot_command/command/actions.h"
#include "cobot_command/command/path_requests.h"
#include "cobot_command/path/path_controls.h"

namespace cobot_command::command {

class PathDesk {
 public:
  /// `actions` has to live longer.
  explicit PathDesk(std::vector<Action>& actions) : actions_(actions) {}

  [[nodiscard]] const path::PathControls& controls() const { return controls_; }
  /// Nothing: it is so now; else why not.
  [[nodiscard]] std::optional<std::string> switchTracking(const TrackingSwitch& request);
  /// Those that switch themselves. False: all are so already.
  bool switchAutomatic(const path::TrackingFlags& wanted);

 private:
  void use(const path::PathControls& controls);

  std::vector<Action>& actions_;
  path::PathControls controls_;
};

}  // namespace cobot_command::command
