// Plans a list of script commands end to end: where each motion starts, how long it takes, and whether it is
// possible. It sends and moves nothing. The simulated arm plans with the same code.
#pragma once

#include <optional>
#include <utility>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"
#include "cobot_command/common/units.h"
#include "cobot_command/motion/blend.h"
#include "cobot_command/motion/command.h"
#include "cobot_command/motion/refusal.h"
#include "cobot_command/motion/trajectory.h"
#include "cobot_command/planning/script_motion.h"
#include "cobot_command/script/script_command.h"

namespace cobot_command::planning {

/// Uncertainty of the start posture of a plan [rad]: 1 degree. The status stream rounds much finer, but real
/// arms are calibrated individually, and the orientation of their tools differs by up to 0.6 degrees from the
/// nominal geometry.
inline constexpr double kStartTolerance = degToRad(1.0);

/// A blend radius that is too large for the path on one side of the corner.
struct BlendMisfit {
  double radius = 0.0;     ///< as requested [m]
  double allowed = 0.0;    ///< half of the length of the TCP path of this step [m]
  bool of_before = false;  ///< the radius is that of the previous motion; the path of this step is the one
                           ///< after the corner
};

struct PlannedStep {
  /// False: a motion that cannot be planned because its start, base or TCP is unknown, or a stop during a
  /// motion.
  bool planned = true;
  /// As executed if no motion follows; null if the command is not a motion or is not planned.
  motion::TrajectoryPtr trajectory;
  Duration start{};  ///< since the start of the sequence; with a blend, before the end of the previous step
  Duration duration{};  ///< from there to a stop at its own end
  /// The motion is planned in spite of the misfit, with as much of the blend as possible.
  std::optional<BlendMisfit> misfit;
};

/// A value: a copy can be used to try commands and be discarded.
class ScriptPlanner {
 public:
  /// The known state at the start of the sequence.
  struct Start {
    std::optional<arm::JointVector> joints;                 ///< [rad]; absent: unknown
    std::optional<arm::Pose> base = arm::Pose::Identity();  ///< in the robot base [m]; absent: unknown
    std::optional<arm::Pose> tcp = arm::Pose::Identity();   ///< in the flange [m]; absent: unknown
    double speed_override = 1.0;                            ///< project speed, (0, 1]
  };

  ScriptPlanner(arm::ArmModel arm, const Start& start);
  ScriptPlanner(arm::ArmModel arm, const arm::JointVector& joints, const motion::Setting& setting)
      : ScriptPlanner(std::move(arm), Start{joints, setting.base, setting.tcp, setting.speed_override}) {}

  /// Plans `command` after all previous ones. A refused command is not appended.
  ///
  /// A change of base or TCP applies to the commands after it: by value, or by the names RobotBase and
  /// NOTOOL. After any other name that frame is unknown, and only motions in joint space are planned. After a
  /// motion that was not planned, no motion is planned until the next joint target defines the position of
  /// the arm again. All other commands take no time, including the points of a PVT, which is one motion
  /// executed at its PVTExit. Velocity commands are not planned, because their duration is unknown. After a
  /// stop during a motion the position of the arm is unknown, so that step is not planned. A motion with a
  /// blend value blends into the next one, unless the TCP changes or the script waits for a tag between them.
  ///
  /// `arrival`: when the robot receives the command, since the start of the sequence. A command that arrives
  /// after the previous motion has ended starts from rest then. A command that arrives too late for the full
  /// blend uses the remaining part.
  [[nodiscard]] Result<PlannedStep, motion::Refusal> append(const script::ScriptCommand& command,
                                                            Duration arrival = Duration::zero());

  /// Sets base, TCP and project speed for the following commands, from a better source. A TCP different from
  /// the previous one ends the blend.
  void follow(const Start& frames);

  /// False: the end of the last motion is unknown.
  [[nodiscard]] bool jointsKnown() const { return end_.has_value(); }
  /// The end of the last motion [rad]. Precondition: jointsKnown().
  [[nodiscard]] const arm::JointVector& joints() const { return *end_; }
  /// Settings of the next motion; an unknown frame is given as the identity.
  [[nodiscard]] motion::Setting setting() const;
  [[nodiscard]] bool framesKnown() const { return base_ && tcp_; }
  /// The start of a sequence that follows this one.
  [[nodiscard]] Start end() const { return {end_, base_, tcp_, speed_override_}; }
  /// When the last planned motion stops.
  [[nodiscard]] Duration duration() const { return duration_; }

 private:
  using Appended = Result<PlannedStep, motion::Refusal>;

  [[nodiscard]] Appended append(const ScriptMotion& motion, Duration arrival);
  PlannedStep stop(Duration arrival);
  void note(const script::ChangeBase& change);
  void note(const script::ChangeTcp& change);
  void note(const script::QueueTag& tag);
  void note(const script::PvtEnter& enter) { pvt_ = PvtBlock{enter.cartesian, {}}; }
  void note(const script::PvtPoint& point) { pvt_.points.push_back(point); }
  void note(const script::ContinueVJog& mode);
  void note(const script::ContinueVLine& mode);
  void note(const script::WaitQueueTag& wait);
  template <class Other>
  void note(const Other& /*changes nothing*/) {}
  [[nodiscard]] std::optional<BlendMisfit> misfitOf(const motion::Trajectory& trajectory,
                                                    const std::optional<motion::Blend>& blend) const;
  [[nodiscard]] Appended appendUnplanned(const motion::Command& command);

  arm::ArmModel arm_;
  std::optional<arm::JointVector> end_;
  std::optional<arm::Pose> base_;
  std::optional<arm::Pose> tcp_;
  double speed_override_;
  Duration duration_{};
  motion::TrajectoryPtr last_;          // blends into the next motion
  std::optional<motion::Blend> blend_;  // of last_; std::nullopt if it stops
  PvtBlock pvt_;                        // since its PVTEnter
};

}  // namespace cobot_command::planning
