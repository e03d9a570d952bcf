// Motions that no goal waits for any more, and that may still be running. These are blended motions, which
// are done at their acceptance, and motions whose stop was not confirmed. The next command may follow a
// blended motion at once. After an unconfirmed stop it must wait.
#pragma once

#include <optional>
#include <string>

#include "cobot_command/common/time.h"
#include "cobot_command/robot/arrival.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::robot {

class LooseMotion {
 public:
  static constexpr const char* kMayStillMove = "the robot may still move";

  /// Whether the end position of the motion is known. Never: velocities, which continue until another command
  /// ends them.
  enum class End { Planned, Unknown, Never };
  /// The controller has a motion whose end no tag reports. `target`: expected position at its end, if known.
  void begin(const std::optional<Target>& target, End end, Instant now);
  /// The state of the robot is unknown. `why`: what was found. `target`: of the motion that should be
  /// stopped.
  void stopFailed(const std::string& why, const std::optional<Target>& target, Instant now);
  /// The motion was stopped, is done, or no client can be notified of it any more.
  void end() { *this = LooseMotion(); }
  /// A robot that is seen at standstill has no such motion, after the time that a motion needs to be seen.
  void see(const RobotWatch& robot, Instant now);

  [[nodiscard]] bool mayMove() const { return state_ != State::None; }
  /// The robot may move, and no motion can be planned from where it will stop.
  [[nodiscard]] bool endsUnknown() const { return mayMove() && end_ != End::Planned; }
  /// The robot may move, and the motion ends automatically.
  [[nodiscard]] bool endsByItself() const { return mayMove() && end_ != End::Never; }
  /// After an unconfirmed stop: no command may be sent before the robot is seen at standstill.
  [[nodiscard]] bool holdsBack() const { return state_ == State::Unstopped; }
  [[nodiscard]] const std::optional<Target>& target() const { return target_; }
  /// Text about an unconfirmed stop, for people; empty: there is none.
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  enum class State { None, Blended, Unstopped };

  State state_ = State::None;
  End end_ = End::Planned;
  Instant since_{};
  std::optional<Target> target_;
  std::string text_;
};

}  // namespace cobot_command::robot
