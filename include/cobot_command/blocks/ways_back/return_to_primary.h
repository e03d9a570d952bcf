// Moves the robot back to where its motions were interrupted, so that they can continue: ReturnToPrimary of
// SRCI.
// doc/actions/return_to_primary.md.
#pragma once

#include <optional>

#include "cobot_command/arm/types.h"
#include "cobot_command/blocks/shared/block_parts.h"

namespace cobot_command::blocks {

enum class ReturnMode {
  InterruptPosition = 0,  ///< where the robot came to rest
  EndPosition = 1         ///< the end of the interrupted motion
};
enum class ReturnTrajectory { Linear = 1, Ptp = 2 };

/// Target of the motion back.
struct ReturnTarget {
  arm::JointVector joints;  ///< [rad]
  arm::Pose tcp;            ///< with the present TCP, in the robot base [m]
  double distance_mm = 0;   ///< distance of the TCP from its present position
};

/// The core's data about the interruption.
struct ReturnPlace {
  ReturnTarget interrupted;
  std::optional<ReturnTarget> segment_end;  ///< nullopt: the robot executed no motion
  /// Difference of TCP, load or base from those of the interruption; nullopt: none.
  std::optional<Failure> difference;
};

struct ReturnToPrimaryGoal {
  static constexpr const char* kName = "return_to_primary";
  [[nodiscard]] static ErrorTable errors();

  int return_mode = 0;        ///< ReturnMode
  int trajectory_mode = 1;    ///< ReturnTrajectory
  double speed = 0;           ///< 0..100 %; 0: 10
  double distance_limit = 0;  ///< [mm] largest allowed distance of the TCP; 0: no limit
  bool allow_differences = false;
  std::optional<ReturnPlace> place;  ///< nullopt: nothing is interrupted
};

[[nodiscard]] GoalTraits traitsOf(const ReturnToPrimaryGoal& goal);
[[nodiscard]] std::vector<Failure> check(const ReturnToPrimaryGoal& goal);
/// Precondition: no violations.
[[nodiscard]] Order orderOf(const ReturnToPrimaryGoal& goal, const arm::Pose& base);

}  // namespace cobot_command::blocks
