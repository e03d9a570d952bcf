// change_speed_override: it counts for what is planned and sent from now on, and at 0 holds the robot by a
// Pause().
#pragma once

#include <functional>
#include <string>

#include "paths/path_turn.h"
#include "paths/pause_desk.h"
#include "runs/command_window.h"

#include "cobot_command/command/speed_override.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::command {

class SpeedDesk {
 public:
  /// What it uses of the core; all have to live longer.
  struct Core {
    SpeedOverride& speed;
    PauseDesk& pause;
    const PathTurn& turn;
    const CommandWindow& window;
    const robot::RobotWatch& robot;
    /// Something may move, of ours or not.
    std::function<bool()> may_move;
    /// What was planned of the goal that is next does not hold any more.
    std::function<void()> speeds_changed;
  };
  explicit SpeedDesk(Core core) : core_(std::move(core)) {}

  /// Out of range nothing changes.
  void set(double percent, const OverrideReply& reply, Instant now);
  [[nodiscard]] double percent() const { return core_.speed.percent(); }
  /// See OverrideAnswer.
  [[nodiscard]] double effective() const;

 private:
  void hold(const OverrideReply& reply, Instant now);
  void letGo(const OverrideReply& reply, Instant now);
  /// What is told besides what holds the robot.
  [[nodiscard]] std::string textOfNow() const;
  void answerWith(const OverrideReply& reply, const PauseDesk::Answer& answer, const std::string& text) const;
  void answerWith(const OverrideReply& reply, const PauseDesk::Answer& answer, const std::string& text,
                  double effective) const;
  /// Of a robot that nothing holds.
  [[nodiscard]] double speedOfNow() const;
  [[nodiscard]] bool isSafeguarded() const;

  Core core_;
};

}  // namespace cobot_command::command
