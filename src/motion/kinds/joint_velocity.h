// A velocity of the joints, kept for a while: in closed form.
#pragma once

#include "cobot_command/motion/velocity.h"

namespace cobot_command::motion {

/// All times in s.
struct VelocityTimes {
  double ramp;
  double steady;  ///< between the ramps, as it was asked for
};

/// `velocity` [rad/s] as the arm is to have it; see planVelocity().
[[nodiscard]] Result<VelocityMotion, Refusal> planJointVelocity(const arm::ArmModel& arm,
                                                                const JointState& now,
                                                                const arm::JointVector& velocity,
                                                                const VelocityTimes& times,
                                                                const Setting& setting);

}  // namespace cobot_command::motion
