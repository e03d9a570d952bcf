// The robot's error: the controller's Error_Code for a motion that cannot be made (TM 2.6), and how long it
// stands.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/transition_table.h"
#include "cobot_command/motion/refusal.h"

namespace cobot_command::simulator {

struct RobotError {
  int code = 0;
  std::string text;  ///< for Error_Content and the log
};

/// The mapping is ours where only the codes are known; see doc/simulator.md. `reaches_end`: the
/// arm could be where the motion ends.
[[nodiscard]] RobotError robotErrorFor(const motion::Refusal& refusal, bool reaches_end);

/// Why the arm does not move with these masses [kg]: one is below 0, or they are more than the model carries.
[[nodiscard]] std::optional<RobotError> overload(const arm::ArmModel& arm, double tool, double load);

enum class ErrorState {
  None,
  OfMotion,  ///< a motion was not made: until the next one is queued
  OfRobot    ///< the robot itself has failed: until it is cleared
};
enum class ErrorEvent { MotionFailed, RobotFailed, MotionQueued, Cleared };
enum class ErrorAction { Keep, Forget };

struct ErrorTable {
  using S = ErrorState;
  using E = ErrorEvent;
  using A = ErrorAction;
  using Row = Transition<S, E, A>;

  // clang-format off
  static constexpr Row kRows[] = {
    // from         event             to            action
    {S::None,     E::MotionFailed,  S::OfMotion,  A::Keep},
    {S::None,     E::RobotFailed,   S::OfRobot,   A::Keep},

    {S::OfMotion, E::MotionFailed,  S::OfMotion,  A::Keep},
    {S::OfMotion, E::RobotFailed,   S::OfRobot,   A::Keep},
    {S::OfMotion, E::MotionQueued,  S::None,      A::Forget},
    {S::OfMotion, E::Cleared,       S::None,      A::Forget},

    {S::OfRobot,  E::RobotFailed,   S::OfRobot,   A::Keep},
    {S::OfRobot,  E::Cleared,       S::None,      A::Forget},
  };
  // clang-format on
};

class ErrorLatch {
 public:
  void motionFailed(RobotError error) { on(ErrorEvent::MotionFailed, std::move(error)); }
  void robotFailed(RobotError error) { on(ErrorEvent::RobotFailed, std::move(error)); }
  void motionQueued() { on(ErrorEvent::MotionQueued, {}); }
  void clear() { on(ErrorEvent::Cleared, {}); }

  /// No motion is made before it is cleared.
  [[nodiscard]] bool stands() const { return state_ == ErrorState::OfRobot; }
  [[nodiscard]] const std::optional<RobotError>& error() const { return error_; }

 private:
  void on(ErrorEvent event, RobotError error);

  ErrorState state_ = ErrorState::None;
  std::optional<RobotError> error_;
};

}  // namespace cobot_command::simulator
