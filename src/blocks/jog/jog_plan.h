// A jog before it begins: its velocity, and how far the arm can go with it. What is in the way is known from
// the start, so that nothing has to be planned while the arm moves.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/blocks/jog.h"
#include "cobot_command/blocks/shared/order.h"
#include "cobot_command/blocks/shared/planning_scene.h"
#include "cobot_command/common/result.h"
#include "cobot_command/motion/command.h"
#include "cobot_command/motion/refusal.h"

namespace cobot_command::blocks {

/// Of each short move: from rest to its speed, and back; and for as long it would go on at that speed. With
/// both alike two of them overlap so that the speed stays.
inline constexpr Duration kJogRamp = std::chrono::milliseconds(60);
inline constexpr Duration kJogPiece = kJogRamp;

/// Its measure is the drive: seconds at full speed, by a project speed of 100 %. Every joint, or the TCP,
/// goes as far as its velocity takes it in that time. Of an increment it is a share: 1 is the whole of it.
struct JogPlan {
  bool of_joints = false;
  arm::JointVector joint_rate = arm::JointVector::Zero();  ///< [rad/s]
  motion::TcpVelocity tcp_rate;                            ///< along and about the axes of the active base
  int percent = 10;                                        ///< of the reference, as the controller takes it
  std::shared_ptr<const arm::ArmModel> arm;
  motion::Setting setting;  ///< active base and TCP, project speed
  arm::JointVector start = arm::JointVector::Zero();
  arm::Pose tcp_start = arm::Pose::Identity();       ///< in the robot base
  double reach = 0;                                  ///< the drive after which it has to stand [s]
  arm::JointVector rest = arm::JointVector::Zero();  ///< where that is
  std::optional<motion::Refusal> obstacle;           ///< that is there; nothing: ten minutes are over
  std::optional<double> step;                        ///< 1, of an increment; nothing: hold to run
  bool by_velocity = false;   ///< the controller may be given one, and has not refused it
  bool is_in_metres = false;  ///< it takes that of the TCP in m/s and rad/s, not in mm/s and deg/s
  Duration stop_time{};       ///< that the controller needs to bring it to rest

  /// The drive that has brought the arm there; `last`: where it was before, for turns beyond half of one.
  [[nodiscard]] double driveAt(const arm::JointVector& joints, double last) const;
  /// What a drive means [m], [rad]; of joints: of the fastest one.
  [[nodiscard]] double wayOf(double drive) const;
  [[nodiscard]] double turnOf(double drive) const;

  /// What is in the way, for people. Precondition: there is an obstacle.
  [[nodiscard]] std::string obstacleText() const;

  /// One move; `passes_on`: it blends into the one behind it.
  [[nodiscard]] Order move(double drive, bool passes_on) const;
  /// The mode in which the controller takes velocities, with the first one.
  [[nodiscard]] Order enterVelocity() const;
  /// The same velocity again, or none.
  [[nodiscard]] Order setVelocity(bool rests) const;
  [[nodiscard]] static Order leaveVelocity();
};

/// Precondition: the goal was checked, model and start of the scene are known.
[[nodiscard]] Result<std::shared_ptr<const JogPlan>, Failure> planJog(const JogGoal& goal,
                                                                      const PlanningScene& scene);

}  // namespace cobot_command::blocks
