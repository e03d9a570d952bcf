// Whether all are to stand, and what is to be told of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cobot_command/cell/monitor/monitor.h"
#include "cobot_command/cell/monitor/monitor_state.h"
#include "cobot_command/common/time.h"

namespace cobot_command::cell::monitor {

class Alarm {
 public:
  explicit Alarm(MonitorSettings::Mode mode) : mode_(mode) {}

  void warn(std::string text);
  void ended(Breach breach);
  /// A reason to stop all has come.
  void raise(const std::string& why, Instant now);
  /// One moves by what is known of it now: a stop may have been lost, or it was started again.
  void moving(Instant now);
  void reset() { why_.reset(); }

  [[nodiscard]] bool latched() const { return why_.has_value(); }
  /// The first reason; only while it is latched.
  [[nodiscard]] const std::string& why() const { return *why_; }
  [[nodiscard]] std::vector<MonitorAction> takeActions();

 private:
  void stopAll(std::string why, Instant now);

  MonitorSettings::Mode mode_;
  std::optional<std::string> why_;
  Instant stopped_;  ///< all were told to stop last
  std::vector<MonitorAction> actions_;
};

}  // namespace cobot_command::cell::monitor
