// Back to where motions were interrupted, so that they can go on: ReturnToPrimary of SRCI.
// doc/actions/return_to_primary.md.
#pragma once

#include <optional>

#include "cobot_command/arm/types.h"
#include "cobot_command/blocks/shared/block_parts.h"

namespace cobot_command::blocks {

enum class ReturnMode {
  InterruptPosition = 0,  ///< where the robot came to rest
  EndPosition = 1         ///< the end of the motion that it was at
};
enum class ReturnTrajectory { Linear = 1, Ptp = 2 };

/// Where a way back ends.
struct ReturnTarget {
  arm::JointVector joints;  ///< [rad]
  arm::Pose tcp;            ///< with the TCP of now, in the robot base [m]
  double distance_mm = 0;   ///< of the TCP, from where it is now
};

/// What is known of the interruption; the core says so.
struct ReturnPlace {
  ReturnTarget interrupted;
  std::optional<ReturnTarget> segment_end;  ///< nothing: the robot was at no motion
  std::optional<Failure> difference;  ///< of TCP, load or base from those of then; nothing: there is none
};

struct ReturnToPrimaryGoal {
  static constexpr const char* kName = "return_to_primary";
  [[nodiscard]] static ErrorTable errors();

  int return_mode = 0;        ///< ReturnMode
  int trajectory_mode = 1;    ///< ReturnTrajectory
  double speed = 0;           ///< 0..100 %; 0: 10
  double distance_limit = 0;  ///< [mm] that the TCP may be away at most; 0: any
  bool allow_differences = false;
  std::optional<ReturnPlace> place;  ///< nothing: nothing is interrupted
};

[[nodiscard]] GoalTraits traitsOf(const ReturnToPrimaryGoal& goal);
[[nodiscard]] std::vector<Failure> check(const ReturnToPrimaryGoal& goal);
/// Precondition: no violations.
[[nodiscard]] Order orderOf(const ReturnToPrimaryGoal& goal, const arm::Pose& base);

}  // namespace cobot_command::blocks
