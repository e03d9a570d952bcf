// Which postures reach a pose: closed form, all branches, each with its pose bits.
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
  JointVector joints;  ///< each joint in (-pi, pi], whatever the limits; see nearestTurn()
  PoseBits bits;
};

using Branches = boost::container::static_vector<Branch, 8>;

/// All postures (at most eight, no two with the same bits) that bring the flange to `flange` in the robot
/// base [m]. Joint limits are not considered. Empty when the pose is out of reach, not finite, or its linear
/// part is not a rotation (tolerance 1e-6).
///
/// On a singularity two branches meet; both are reported, with distinct bits and the same joints. On the
/// wrist singularity (J5 = 0 or 180 degrees) only J4 +- J6 is determined: J6 is then that of `reference`, the
/// posture from which the arm comes, or as near to it as the reach allows.
[[nodiscard]] Branches allBranches(const ArmModel& arm, const Pose& flange,
                                   const JointVector& reference = JointVector::Zero());

/// The one of allBranches() with these bits, to the last digit, at half the cost; nothing when there is none.
[[nodiscard]] std::optional<JointVector> branchWith(const ArmModel& arm, const Pose& flange,
                                                    const PoseBits& bits,
                                                    const JointVector& reference = JointVector::Zero());

/// The same posture with every joint turned by whole turns to be nearest to `reference` while inside the
/// limits; exactly half a turn from it a joint stays as it is. Nothing when a joint has no turn inside its
/// limits, or is not finite.
[[nodiscard]] std::optional<JointVector> nearestTurn(const ArmModel& arm, const JointVector& joints,
                                                     const JointVector& reference);

/// Why no posture can be given.
struct IkRefusal {
  enum class Reason {
    NotFinite,        ///< the pose or the reference is not finite, or the pose's axes are not a rotation
    OutOfReach,       ///< no posture at all reaches the pose
    BitsNotPossible,  ///< it can be reached, but not with these pose bits
    OutsideLimits     ///< the posture with these bits has a joint outside its limits
  };
  Reason reason = Reason::OutOfReach;
  int joint = -1;       ///< 0..5 for OutsideLimits, else -1
  std::string message;  ///< found, allowed, what to do
};

/// The posture with exactly these bits, inside the limits, at the turn nearest to `reference`.
[[nodiscard]] Result<JointVector, IkRefusal> postureFor(const ArmModel& arm, const Pose& flange,
                                                        const PoseBits& bits, const JointVector& reference);

}  // namespace cobot_command::arm
