// How fast all that is commanded here is to be, beside the speeds of the goals (SRCI: ChangeSpeedOverride).
#pragma once

#include <functional>
#include <string>

namespace cobot_command::command {

/// SRCI's number: it is not within 0..100 %.
inline constexpr int kSpeedOverrideRange = 0x8D23;

/// It counts for what is sent from now on, and holds until another one is set.
class SpeedOverride {
 public:
  /// 0..100; at 0 the robot is held, and nothing is sent.
  void set(double percent) {
    percent_ = percent;
    if (percent > 0) share_ = percent / 100;
  }
  [[nodiscard]] double percent() const { return percent_; }
  [[nodiscard]] bool isZero() const { return percent_ == 0; }
  /// Of the speeds of what is planned and sent, (0, 1]; at 0 % that of before: it goes on with it.
  [[nodiscard]] double share() const { return share_; }

 private:
  double percent_ = 100;
  double share_ = 1;
};

struct OverrideAnswer {
  bool success = false;
  int error_id = 0;
  std::string message;  ///< in plain words
  /// [%] of its own speeds that what moves the robot now has, times the project speed; of what is sent next,
  /// where nothing does. 0: the robot is held.
  double effective = 0;
};

/// Called once: at once, or when the controller has answered a Pause() or Resume().
using OverrideReply = std::function<void(const OverrideAnswer& answer)>;

}  // namespace cobot_command::command
