// Plans what the arm does in the queue; why it cannot be done is one of the controller's errors.
#pragma once

#include <optional>

#include "drive/moving_arm.h"
#include "queue/queue_entry.h"
#include "queue/tool_and_base.h"

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/result.h"
#include "cobot_command/motion/trajectory.h"
#include "cobot_command/simulator/fault_switches.h"

namespace cobot_command::simulator {

class MotionPlanner {
 public:
  struct Options {
    Duration stop_time{};          ///< from one velocity to another
    bool checks_payload = true;    ///< no motion with more than the model carries
    bool accept_zero_ramp = true;  ///< a time to top speed of 0 is the shortest that the arm allows
    double speed_override = 1.0;   ///< project speed, (0, 1]
    bool live_speed = false;       ///< it counts for what is under way, too
    Duration pvt_lag{};            ///< by which the arm follows a PVT late
  };

  /// `pvt_linear`: does the arm go straight between the points of a PVT?
  MotionPlanner(const arm::ArmModel& arm, Options options, const FaultSwitch& pvt_linear)
      : arm_(arm), options_(options), pvt_linear_(pvt_linear) {}

  [[nodiscard]] bool liveSpeed() const { return options_.live_speed; }

  /// For what is planned from then on, (0, 1].
  void setSpeedOverride(double override) { options_.speed_override = override; }

  /// From rest to rest.
  [[nodiscard]] Result<ArmMotion, RobotError> plan(const arm::JointVector& start,
                                                   const MotionRequest& request,
                                                   const ToolAndBase& setting) const {
    return plan(start, request, setting, options_.speed_override);
  }
  /// From the state that the arm has; `lasting`: so long, if it is not renewed.
  [[nodiscard]] Result<ArmMotion, RobotError> planVelocity(const motion::JointState& now,
                                                           const Velocity& velocity,
                                                           std::optional<Duration> lasting,
                                                           const ToolAndBase& setting) const;

  struct Blended {
    ArmMotion next;
    Duration overlap;  ///< so long before the end of `before`
  };
  /// The motion that `before`, which blends, passes into; `left`: to its end. Nothing when the arm stops
  /// between them: without overlap, or as the next one cannot be made, which is told when its turn comes.
  [[nodiscard]] std::optional<Blended> planBehind(const ArmMotion& before, Duration left,
                                                  const MotionRequest& request,
                                                  const ToolAndBase& setting) const;

 private:
  [[nodiscard]] Result<ArmMotion, RobotError> plan(const arm::JointVector& start,
                                                   const MotionRequest& request, const ToolAndBase& setting,
                                                   double speed_override) const;
  [[nodiscard]] std::optional<RobotError> overloadBy(const ToolAndBase& setting) const;
  /// As the arm makes it.
  [[nodiscard]] ArmMotion followed(ArmMotion motion, const planning::PvtBlock& pvt) const;

  const arm::ArmModel& arm_;
  Options options_;
  const FaultSwitch& pvt_linear_;
};

}  // namespace cobot_command::simulator
