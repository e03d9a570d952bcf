// The frames of all links of an arm and the axes of its joints.
//
// An immutable value; safe to share between threads.
#pragma once

#include <array>
#include <cstddef>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/types.h"

namespace cobot_command::arm {

/// The base link and one link after each joint.
inline constexpr std::size_t kLinkCount = kJointCount + 1;

/// [0]: the base; [k]: the link that joint k (1 to 6) moves, with its origin on the axis of that joint.
using LinkFrames = std::array<Pose, kLinkCount>;

/// The rotation axis of a joint, right-handed.
struct JointAxis {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< any point on it [m]
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
};
/// [0] is the axis of joint 1.
using JointAxes = std::array<JointAxis, kJointCount>;

class LinkChain {
 public:
  explicit LinkChain(const ArmModel& arm);

  /// The frames of all links at these joints, with the robot base at `base` [m]. They are in the frame in
  /// which `base` is given.
  [[nodiscard]] LinkFrames framesAt(const JointVector& joints, const Pose& base = Pose::Identity()) const;

  /// The joint axes, in the same frame as `frames`.
  [[nodiscard]] JointAxes axesOf(const LinkFrames& frames) const;

  /// The flange in the frame of the last link.
  [[nodiscard]] const Pose& flange() const { return flange_; }

 private:
  struct Joint {
    Pose origin = Pose::Identity();                        ///< in the previous link, with the joint at zero
    Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< in the link after the joint
  };

  std::array<Joint, kJointCount> joints_;
  Pose flange_ = Pose::Identity();
};

}  // namespace cobot_command::arm
