// A list of script commands, planned end to end: where each motion starts, how long it takes, whether it can
// be made. Sends and moves nothing; the simulated arm plans with the same code.
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

/// What a plan knows of where the arm will stand [rad]: 1 degree. The stream rounds far finer, but real arms
/// are calibrated one by one, and tools are turned up to 0.6 degrees from where the nominal geometry has
/// them.
inline constexpr double kStartTolerance = degToRad(1.0);

/// A blend radius for which the path on one side of the corner is too short.
struct BlendMisfit {
  double radius = 0.0;     ///< as it was asked for [m]
  double allowed = 0.0;    ///< half of the length of the TCP's path in this step [m]
  bool of_before = false;  ///< the radius is that of the motion before, this step's path is the one behind it
};

struct PlannedStep {
  /// False: a motion of which nobody can say more, as its start, base or TCP is not known; or a stop of one.
  bool planned = true;
  /// As the arm makes it if nothing comes behind; null for what is no motion, and for what is not planned.
  motion::TrajectoryPtr trajectory;
  Duration start{};     ///< since the sequence began; before the end of the step before it, where it blends
  Duration duration{};  ///< from there to a stop at its own end
  /// The motion is planned all the same, with as much of the blend as there is room for.
  std::optional<BlendMisfit> misfit;
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
  /// takes no time; so do the points of a PVT, which is one motion, made at its PVTExit. Velocities that are
  /// set are no motions here: nobody knows how long they last. A stop while there is motion leaves the arm
  /// where nobody knows: it is no step that is planned. A motion with a blend value passes into the next one,
  /// unless the TCP changes or the script waits for a tag between them.
  ///
  /// `arrival`: when the robot gets the command, since the sequence began. One that arrives after the motion
  /// before it has ended starts from rest then; one that arrives after the place where it could have blended
  /// blends with what is left.
  [[nodiscard]] Result<PlannedStep, motion::Refusal> append(const script::ScriptCommand& command,
                                                            Duration arrival = Duration::zero());

  /// Base, TCP and project speed of what follows, from somebody who knows them better. Another TCP than
  /// before ends the blend.
  void follow(const Start& frames);

  /// False: nobody knows where the last motion ends.
  [[nodiscard]] bool jointsKnown() const { return end_.has_value(); }
  /// Where the last motion ends [rad]. Precondition: jointsKnown().
  [[nodiscard]] const arm::JointVector& joints() const { return *end_; }
  /// What the next motion is planned with; an unknown frame stands as the identity.
  [[nodiscard]] motion::Setting setting() const;
  [[nodiscard]] bool framesKnown() const { return base_ && tcp_; }
  /// Where a sequence would start that comes behind this one.
  [[nodiscard]] Start end() const { return {end_, base_, tcp_, speed_override_}; }
  /// When the last motion that was planned comes to a stop.
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
  motion::TrajectoryPtr last_;          // what passes into the motion behind it
  std::optional<motion::Blend> blend_;  // of it; nothing when it stops
  PvtBlock pvt_;                        // since its PVTEnter
};

}  // namespace cobot_command::planning
