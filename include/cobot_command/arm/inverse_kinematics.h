// Inverse kinematics in closed form: all postures that reach a pose, each with its pose bits.
#pragma once

#include <optional>
#include <string>

#include <boost/container/static_vector.hpp>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/pose_bits.h"
#include "cobot_command/arm/types.h"
#include "cobot_command/common/result.h"

namespace cobot_command::arm {

struct Branch {
  JointVector joints;  ///< each joint in (-pi, pi], regardless of the limits; see nearestTurn()
  PoseBits bits;
};

using Branches = boost::container::static_vector<Branch, 8>;

/// All postures (at most eight, no two with the same bits) that bring the flange to `flange` in the robot
/// base [m]. Joint limits are ignored. Empty if the pose is out of reach or not finite, or if its linear part
/// is not a rotation (tolerance 1e-6).
///
/// At a singularity two branches coincide; both are returned, with different bits and the same joints. At the
/// wrist singularity (J5 = 0 or 180 degrees) only J4 +- J6 is determined: J6 is then that of `reference`, the
/// posture before the motion, or as near to it as the reach allows.
[[nodiscard]] Branches allBranches(const ArmModel& arm, const Pose& flange,
                                   const JointVector& reference = JointVector::Zero());

/// The posture of allBranches() with these bits, identical to the last digit, at half the cost; std::nullopt
/// if there is none.
[[nodiscard]] std::optional<JointVector> branchWith(const ArmModel& arm, const Pose& flange,
                                                    const PoseBits& bits,
                                                    const JointVector& reference = JointVector::Zero());

/// The same posture with whole turns added to each joint, so that it is nearest to `reference` within the
/// limits. A joint exactly half a turn from it is not changed. std::nullopt if a joint has no turn within its
/// limits or is not finite.
[[nodiscard]] std::optional<JointVector> nearestTurn(const ArmModel& arm, const JointVector& joints,
                                                     const JointVector& reference);

/// Why there is no posture.
struct IkRefusal {
  enum class Reason {
    NotFinite,        ///< the pose or the reference is not finite, or the axes of the pose are not a rotation
    OutOfReach,       ///< no posture reaches the pose
    BitsNotPossible,  ///< the pose can be reached, but not with these pose bits
    OutsideLimits     ///< the posture with these bits has a joint outside its limits
  };
  Reason reason = Reason::OutOfReach;
  int joint = -1;       ///< 0..5 for OutsideLimits, else -1
  std::string message;  ///< found, allowed, what to do
};

/// The posture with exactly these bits, within the limits, at the turn nearest to `reference`.
[[nodiscard]] Result<JointVector, IkRefusal> postureFor(const ArmModel& arm, const Pose& flange,
                                                        const PoseBits& bits, const JointVector& reference);

}  // namespace cobot_command::arm
