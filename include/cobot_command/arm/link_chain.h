// Where all links of an arm are, and the axes of its joints.
//
// A value, immutable after it is made; safe to share between threads.
#pragma once

#include <array>
#include <cstddef>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/types.h"

namespace cobot_command::arm {

/// The fixed link and one behind each joint.
inline constexpr std::size_t kLinkCount = kJointCount + 1;

/// [0]: the base; [k]: what joint k (1 to 6) moves, with its origin on the axis of that joint.
using LinkFrames = std::array<Pose, kLinkCount>;

/// The line that a joint turns about, by the right hand.
struct JointAxis {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< any point of it [m]
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
};
/// [0] is that of joint 1.
using JointAxes = std::array<JointAxis, kJointCount>;

class LinkChain {
 public:
  explicit LinkChain(const ArmModel& arm);

  /// The frames of all links at these joints, with the base of the robot at `base` [m]; in what `base` is in.
  [[nodiscard]] LinkFrames framesAt(const JointVector& joints, const Pose& base = Pose::Identity()) const;

  /// The axes of the joints, in what the frames are in.
  [[nodiscard]] JointAxes axesOf(const LinkFrames& frames) const;

  /// The flange, in the frame of the last link.
  [[nodiscard]] const Pose& flange() const { return flange_; }

 private:
  struct Joint {
    Pose origin = Pose::Identity();                        ///< in the link in front, while it is at zero
    Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< in the link behind it
  };

  std::array<Joint, kJointCount> joints_;
  Pose flange_ = Pose::Identity();
};

}  // namespace cobot_command::arm
