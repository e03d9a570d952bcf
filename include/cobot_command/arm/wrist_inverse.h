// The inverse when the joints 4 to 6 are given: which J1 to J3 bring a point behind the flange to a place.
//
// Of moves whose wrist joints run by themselves while a tool stays on its line. Closed form; names and
// derivation are in doc/kinematics.md.
#pragma once

#include <optional>

#include <boost/container/static_vector.hpp>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/types.h"

namespace cobot_command::arm {

/// Which of the up to four solutions.
struct WristBranch {
  bool in_front = true;      ///< s > 0: the arm reaches forwards; else over its head, behind axis 1
  bool bent_forward = true;  ///< J3 + delta > 0: at axis 3 the arm bends to where joint 1 points

  friend bool operator==(const WristBranch& a, const WristBranch& b) {
    return a.in_front == b.in_front && a.bent_forward == b.bent_forward;
  }
  friend bool operator!=(const WristBranch& a, const WristBranch& b) { return !(a == b); }
};

struct WristSolution {
  JointVector joints;  ///< J1..J3 in (-pi, pi], J4..J6 as they were given
  WristBranch branch;
};

using WristSolutions = boost::container::static_vector<WristSolution, 4>;

/// How far a posture is from where two branches meet; each is zero exactly there.
struct WristSingularityDistance {
  double shoulder = 0;  ///< |s|: of the moved frame's origin from the plane through axis 1 and along z1 [m]
  double elbow = 0;     ///< |sin(J3 + delta)|; 0, too, where the origin is on axis 3 (within 1e-9 m)
};

/// An arm with a tool; a value, safe to share between threads. Joint limits are not considered anywhere here.
class WristArm {
 public:
  /// `tool`: the moved frame in the flange [m]. Only its origin counts.
  WristArm(const ArmModel& arm, const Pose& tool);

  /// All ways (at most four, no two of the same branch) to bring the moved frame's origin to `origin` in the
  /// robot base [m] with J4..J6 as in `wrist` [rad]. On a singularity two branches meet: both are reported,
  /// with the same joints. Empty when the origin is out of reach, when a number is not finite, and when the
  /// origin is on axis 3 for these wrist joints, as joint 3 does not matter then. With the origin on axis 1
  /// joint 1 does not matter, and is any.
  [[nodiscard]] WristSolutions solutions(const Eigen::Vector3d& wrist, const Eigen::Vector3d& origin) const;

  /// The one of solutions() of this branch, with J1..J3 at the turns nearest to `reference`; J1 of
  /// `reference` where it does not matter. Allocates no memory.
  [[nodiscard]] std::optional<JointVector> solve(const Eigen::Vector3d& wrist, const Eigen::Vector3d& origin,
                                                 const WristBranch& branch,
                                                 const JointVector& reference) const;

  /// Whole turns of a joint do not change it. On a singularity the value is false.
  [[nodiscard]] WristBranch branchOf(const JointVector& joints) const;

  [[nodiscard]] WristSingularityDistance singularityDistance(const JointVector& joints) const;

 private:
  /// What hangs rigidly at axis 3 while the wrist joints are as they are.
  struct Forearm {
    double length = 0;  ///< l: from axis 3 to the moved frame's origin, in the plane of the arm [m]
    double delta = 0;   ///< how far that is turned from the link between the axes 3 and 4 [rad]
    double across = 0;  ///< w: of the origin out of that plane, along z1 [m]
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
  /// By which a posture tells its branch, and how far it is from the next one.
  struct Place {
    double forward = 0;  ///< s [m]
    double sine = 0;     ///< of J3 + delta
  };

  [[nodiscard]] Forearm forearmWith(const Eigen::Vector3d& wrist) const;
  /// Of the solution in front; nothing within the cylinder around axis 1.
  [[nodiscard]] std::optional<InPlane> shoulderSide(const Forearm& forearm,
                                                    const Eigen::Vector3d& origin) const;
  /// Of the solution that is bent forwards; nothing where the triangle does not close.
  [[nodiscard]] std::optional<Bend> bendFor(const Forearm& forearm, const InPlane& place) const;
  [[nodiscard]] Eigen::Vector3d armJoints(const Forearm& forearm, const Eigen::Vector3d& origin,
                                          InPlane place, Bend bend, const WristBranch& branch) const;
  [[nodiscard]] Place placeOf(const JointVector& joints) const;

  DhLengths lengths_;
  Eigen::Vector3d tool_;
};

}  // namespace cobot_command::arm
