// The speed override of all commands of this layer, which multiplies the speeds of the goals (SRCI:
// ChangeSpeedOverride).
#pragma once

#include <functional>
#include <string>

namespace cobot_command::command {

/// SRCI number: the value is not within 0..100 %.
inline constexpr int kSpeedOverrideRange = 0x8D23;

/// Applies to everything that is sent from now on, until another value is set.
class SpeedOverride {
 public:
  /// 0..100; at 0 the robot is paused, and nothing is sent.
  void set(double percent) {
    percent_ = percent;
    if (percent > 0) share_ = percent / 100;
  }
  [[nodiscard]] double percent() const { return percent_; }
  [[nodiscard]] bool isZero() const { return percent_ == 0; }
  /// Share of the speeds that are planned and sent, (0, 1]. At 0 % the previous share, with which the robot
  /// resumes.
  [[nodiscard]] double share() const { return share_; }

 private:
  double percent_ = 100;
  double share_ = 1;
};

struct OverrideAnswer {
  bool success = false;
  int error_id = 0;
  std::string message;  ///< in plain words
  /// [%] of its own speeds at which the present motion runs, times the project speed; without a motion: of
  /// the next one. 0: the robot is paused.
  double effective = 0;
};

/// Called once: at once, or when the controller has answered a Pause() or Resume().
using OverrideReply = std::function<void(const OverrideAnswer& answer)>;

}  // namespace cobot_command::command
