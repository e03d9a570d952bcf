// Inverse kinematics with given joints 4 to 6: finds J1 to J3 that bring a point fixed to the flange to a
// position.
//
// Used for moves whose wrist joints are interpolated separately while a tool stays on its line. Closed form;
// doc/kinematics.md has the names and the derivation.
#pragma once

#include <optional>

#include <boost/container/static_vector.hpp>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/types.h"

namespace cobot_command::arm {

/// Selects one of up to four solutions.
struct WristBranch {
  bool in_front = true;      ///< s > 0: the arm reaches forward; otherwise overhead, to the rear of axis 1
  bool bent_forward = true;  ///< J3 + delta > 0: at axis 3 the arm bends towards the direction of joint 1

  friend bool operator==(const WristBranch& a, const WristBranch& b) {
    return a.in_front == b.in_front && a.bent_forward == b.bent_forward;
  }
  friend bool operator!=(const WristBranch& a, const WristBranch& b) { return !(a == b); }
};

struct WristSolution {
  JointVector joints;  ///< J1..J3 in (-pi, pi], J4..J6 as given
  WristBranch branch;
};

using WristSolutions = boost::container::static_vector<WristSolution, 4>;

/// Distance of a posture from where two branches coincide; exactly there its value is zero.
struct WristSingularityDistance {
  double shoulder = 0;  ///< |s|: of the moved frame's origin from the plane through axis 1 and along z1 [m]
  double elbow = 0;     ///< |sin(J3 + delta)|; also 0 if the origin is on axis 3 (within 1e-9 m)
};

/// An arm with a tool; a value, safe to share between threads. It ignores joint limits.
class WristArm {
 public:
  /// `tool`: the moved frame in the flange [m]. Only its origin is used.
  WristArm(const ArmModel& arm, const Pose& tool);

  /// All solutions (at most four, no two of the same branch) that bring the origin of the moved frame to
  /// `origin` in the robot base [m], with J4..J6 as in `wrist` [rad]. At a singularity two branches coincide:
  /// both are returned, with the same joints. Empty if the origin is out of reach, if a number is not finite,
  /// or if the origin is on axis 3 with these wrist joints, because joint 3 then has no effect. With the
  /// origin on axis 1 joint 1 has no effect and is arbitrary.
  [[nodiscard]] WristSolutions solutions(const Eigen::Vector3d& wrist, const Eigen::Vector3d& origin) const;

  /// The solution of this branch, with J1..J3 at the turns nearest to `reference`. J1 is that of `reference`
  /// if it has no effect. Allocates no memory.
  [[nodiscard]] std::optional<JointVector> solve(const Eigen::Vector3d& wrist, const Eigen::Vector3d& origin,
                                                 const WristBranch& branch,
                                                 const JointVector& reference) const;

  /// Whole turns of a joint do not change the branch. At a singularity the value is false.
  [[nodiscard]] WristBranch branchOf(const JointVector& joints) const;

  [[nodiscard]] WristSingularityDistance singularityDistance(const JointVector& joints) const;

 private:
  /// The part that is rigidly attached at axis 3 for given wrist joints.
  struct Forearm {
    double length = 0;  ///< l: from axis 3 to the origin of the moved frame, in the plane of the arm [m]
    double delta = 0;   ///< angle between it and the link from axis 3 to axis 4 [rad]
    double across = 0;  ///< w: offset of the origin from that plane, along z1 [m]
  };
  /// From the shoulder to the origin, in the plane of the arm [m].
  struct InPlane {
    double forward = 0;  ///< s
    double up = 0;       ///< h
  };
  /// Of J3 + delta.
  struct Bend {
    double sine = 0;
    double cosine = 1;
  };
  /// The values that determine the branch of a posture and its distance from the next branch.
  struct Place {
    double forward = 0;  ///< s [m]
    double sine = 0;     ///< of J3 + delta
  };

  [[nodiscard]] Forearm forearmWith(const Eigen::Vector3d& wrist) const;
  /// For the solution in front; std::nullopt within the cylinder around axis 1.
  [[nodiscard]] std::optional<InPlane> shoulderSide(const Forearm& forearm,
                                                    const Eigen::Vector3d& origin) const;
  /// For the solution bent forward; std::nullopt if the triangle does not close.
  [[nodiscard]] std::optional<Bend> bendFor(const Forearm& forearm, const InPlane& place) const;
  [[nodiscard]] Eigen::Vector3d armJoints(const Forearm& forearm, const Eigen::Vector3d& origin,
                                          InPlane place, Bend bend, const WristBranch& branch) const;
  [[nodiscard]] Place placeOf(const JointVector& joints) const;

  DhLengths lengths_;
  Eigen::Vector3d tool_;
};

}  // namespace cobot_command::arm
