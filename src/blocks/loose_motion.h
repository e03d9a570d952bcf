// Motions that no goal waits for any more, and that may still be under way: blended ones, which are done with
// their acceptance, and whatever a stop was to end that was not confirmed.
#pragma once

#include <optional>
#include <string>

#include "robot_watch.h"

#include "cobot_command/common/time.h"

namespace cobot_command::blocks {

class LooseMotion {
 public:
  static constexpr const char* kMayStillMove = "the robot may still move";

  /// The controller has a motion whose end no tag will tell.
  void begin(Instant now);
  /// Nobody knows what the robot does; `why`: what was found.
  void stopFailed(const std::string& why, Instant now);
  /// It was stopped, is done, or nobody can be told any more.
  void end() { *this = LooseMotion(); }
  /// A robot that is seen to stand has none, once a motion had the time to be seen.
  void see(const RobotWatch& robot, Instant now);

  [[nodiscard]] bool mayMove() const { return since_.has_value(); }
  /// Of a stop that failed, for people; empty: none did.
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::optional<Instant> since_;
  std::string text_;
};

}  // namespace cobot_command::blocks
