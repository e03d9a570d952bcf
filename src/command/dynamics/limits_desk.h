// The software limits: between which angles of the joints every motion is planned, at most those of the
// model; and how they compare with those of the controller's safety functions. And what 100 % of speeds are
// of.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "forecast/forecast.h"

#include "cobot_command/command/actions.h"
#include "cobot_command/command/dynamics.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::command {

class LimitsDesk {
 public:
  /// All have to live longer.
  LimitsDesk(Forecast& forecast, const robot::RobotWatch& robot, std::vector<Action>& actions)
      : forecast_(forecast), robot_(robot), actions_(actions) {}

  /// Nothing without a model.
  [[nodiscard]] std::optional<LimitsReport> limits() const;
  /// `under_way`: a goal is, or waits, or something of this layer may move the robot.
  [[nodiscard]] DynamicsAnswer write(const SoftwareLimits& limits, bool under_way);
  /// Nothing without a model.
  [[nodiscard]] std::optional<ReferenceDynamics> reference() const;

  // --- Those of the safety functions, which nobody changes but by the pendant.
  /// Each frame of the stream; while none comes that has them, what the last one has told counts on.
  void see(const link::RobotStatus& status);
  /// There may be another robot now.
  void forget() { theirs_.reset(); }
  /// The controller streams them, and there is a model.
  [[nodiscard]] bool areCompared() const { return theirs_ && forecast_.arm() != nullptr; }
  /// Where ours go beyond them, in words; "": nowhere, or they are not compared.
  [[nodiscard]] std::string excess() const;

 private:
  Forecast& forecast_;
  const robot::RobotWatch& robot_;
  std::vector<Action>& actions_;
  std::optional<SoftwareLimits> theirs_;
};

}  // namespace cobot_command::command
