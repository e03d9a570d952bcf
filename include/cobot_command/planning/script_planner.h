// A list of script commands, planned end to end: where each motion starts, how long it takes, whether it can
// be made. Sends and moves nothing; the simulated arm plans with the same code.
#pragma once

#include <optional>
#include <utility>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/command.h"
#include "cobot_command/motion/refusal.h"
#include "cobot_command/motion/trajectory.h"
#include "cobot_command/planning/script_motion.h"
#include "cobot_command/protocol/script_command.h"

namespace cobot_command::planning {

struct PlannedStep {
  /// False: a motion of which nobody can say more, as its start, base or TCP is not known.
  bool planned = true;
  motion::TrajectoryPtr trajectory;  ///< null for what is no motion, and for what is not planned
  Duration start{};                  ///< since the sequence began
  Duration duration{};
};

/// A value: a copy can be tried out and thrown away.
class ScriptPlanner {
 public:
  /// What is known where the sequence begins.
  struct Start {
    std::optional<arm::JointVector> joints;                 ///< [rad]; absent: unknown
    std::optional<arm::Pose> base = arm::Pose::Identity();  ///< in the robot base [m]; absent: unknown
    std::optional<arm::Pose> tcp = arm::Pose::Identity();   ///< in the flange [m]; absent: unknown
    double speed_override = 1.0;                            ///< project speed, (0, 1]
  };

  ScriptPlanner(arm::ArmModel arm, const Start& start);
  ScriptPlanner(arm::ArmModel arm, const arm::JointVector& joints, const motion::Setting& setting)
      : ScriptPlanner(std::move(arm), Start{joints, setting.base, setting.tcp, setting.speed_override}) {}

  /// Plans `command` behind all before it. Refused: it is not appended.
  ///
  /// A change of base or TCP counts for what follows: by value, or by the names RobotBase and NOTOOL. After
  /// any other name that frame is unknown, and only motions in joint space are planned. After a motion that
  /// was not planned nothing is, until the next joint target says where the arm is again. Everything else
  /// takes no time and changes nothing.
  [[nodiscard]] Result<PlannedStep, motion::Refusal> append(const protocol::ScriptCommand& command);

  /// False: nobody knows where the last motion ends.
  [[nodiscard]] bool jointsKnown() const { return end_.has_value(); }
  /// Where the last motion ends [rad]. Precondition: jointsKnown().
  [[nodiscard]] const arm::JointVector& joints() const { return *end_; }
  /// What the next motion is planned with; an unknown frame stands as the identity.
  [[nodiscard]] motion::Setting setting() const;
  [[nodiscard]] bool framesKnown() const { return base_ && tcp_; }
  /// Where a sequence would start that comes behind this one.
  [[nodiscard]] Start end() const { return {end_, base_, tcp_, speed_override_}; }
  /// Of all motions that were planned.
  [[nodiscard]] Duration duration() const { return duration_; }

 private:
  using Appended = Result<PlannedStep, motion::Refusal>;

  [[nodiscard]] Appended append(const ScriptMotion& motion);
  [[nodiscard]] Appended appendUnplanned(const motion::Command& command);

  arm::ArmModel arm_;
  std::optional<arm::JointVector> end_;
  std::optional<arm::Pose> base_;
  std::optional<arm::Pose> tcp_;
  double speed_override_;
  Duration duration_{};
};

}  // namespace cobot_command::planning
