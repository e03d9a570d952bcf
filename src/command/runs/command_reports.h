// What is told of one command while it is under way.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "forecast/command_order.h"
#include "runs/command_clock.h"

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/blocks/shared/outcome.h"
#include "cobot_command/common/time.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::command {

class CommandReports {
 public:
  /// All have to live longer. `arm`: nullptr: no model.
  CommandReports(const CommandOrder& order, const robot::RobotWatch& robot, CommandClock& clock,
                 const arm::ArmModel* arm);

  void tell(blocks::Phase phase, std::string text, Instant now);
  /// It is executed, or waits for the motion in front of it.
  void goOn(Instant now);
  /// The time of a command that is under way stands still as long as the robot is held.
  void followHold(bool under_way, Instant now);
  /// That was told last.
  [[nodiscard]] blocks::Phase phase() const { return phase_; }
  /// It is being executed, and how far it is was told a while ago.
  [[nodiscard]] bool due(Instant now) const;

  /// What is new since the last call.
  [[nodiscard]] std::vector<blocks::Progress> take() { return std::exchange(progress_, {}); }

 private:
  [[nodiscard]] std::optional<double> distance() const;

  const CommandOrder& order_;
  const robot::RobotWatch& robot_;
  CommandClock& clock_;
  const arm::ArmModel* arm_;
  blocks::Phase phase_ = blocks::Phase::Sent;
  Instant told_at_{};
  std::vector<blocks::Progress> progress_;
};

}  // namespace cobot_command::command
