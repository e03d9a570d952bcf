// Plans a motion before a byte of it is sent: refused by name, or how long it will take.
#pragma once

#include <optional>

#include "failure.h"
#include "robot_watch.h"

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/command.h"

namespace cobot_command::blocks {

struct Plan {
  Duration duration{};
  Duration start_delay{};  ///< what is queued before it takes this long still
  arm::JointVector end;    ///< [rad]
};

class Preflight {
 public:
  explicit Preflight(std::optional<arm::ArmModel> arm) : arm_(std::move(arm)) {}

  /// From where the robot stands, or from where the commands in front of it will leave it. No plan without a
  /// model, and none as long as it is not known where the motion would start.
  [[nodiscard]] Result<std::optional<Plan>, Failure> plan(const motion::Command& command,
                                                          const RobotWatch& robot, Instant now) const;

  /// A blended command was sent: the next one starts at its end.
  void queue(const std::optional<Plan>& plan, Instant now);
  /// The queue tag of a planned motion came back: the next one starts at its end, until the stream, which is
  /// always a little behind, shows the robot standing.
  void arrive(const std::optional<Plan>& plan, Instant now);
  /// Nothing is queued any more, or nobody knows.
  void forget() { queue_end_.reset(); }

 private:
  struct QueueEnd {
    arm::JointVector joints;
    Instant time;  ///< when the robot gets there, if nothing holds it
  };
  [[nodiscard]] bool isQueued(const RobotWatch& robot, Instant now) const;

  std::optional<arm::ArmModel> arm_;
  std::optional<QueueEnd> queue_end_;
};

}  // namespace cobot_command::blocks
