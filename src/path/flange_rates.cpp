#include "cobot_command/path/flange_rates.h"

#include "cobot_command/arm/forward_kinematics.h"

namespace cobot_command::path {
namespace {

/// Half of what an acceleration is taken over.
constexpr Duration kStep = std::chrono::milliseconds(1);

/// Linear, then angular, in the robot base.
arm::JointVector twistAt(const PathPlan& plan, Duration time, const arm::ArmModel& arm) {
  const motion::JointState state = plan.at(time);
  return arm::jacobianAt(arm, state.position) * state.velocity;
}

}  // namespace

FlangeRates flangeRatesAt(const PathPlan& plan, Duration time, const arm::ArmModel& arm) {
  if (time < Duration::zero() || time > plan.duration()) return {};
  const arm::JointVector velocity = twistAt(plan, time, arm);
  const arm::JointVector change = twistAt(plan, time + kStep, arm) - twistAt(plan, time - kStep, arm);
  const arm::JointVector acceleration = change / toSeconds(2 * kStep);
  return {velocity.head<3>().norm(), acceleration.head<3>().norm(), velocity.tail<3>().norm(),
          acceleration.tail<3>().norm()};
}

}  // namespace cobot_command::path
