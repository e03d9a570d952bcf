#include "cobot_command/kinematics/posture.h"

#include <cmath>

#include "rounding.h"

namespace cobot_command::kinematics {

Turns turnsOf(const arm::ControllerJoints& joints_deg) {
  constexpr double kHalfTurn = 180, kTurn = 360;
  Turns turns{};
  for (std::size_t i = 0; i < turns.size(); ++i) {
    turns[i] = static_cast<int>(std::ceil((joints_deg[i] - kHalfTurn) / kTurn));
  }
  return turns;
}

Posture postureOf(const arm::JointVector& joints, const arm::PoseBits& bits) {
  Posture posture;
  posture.joints = shown(arm::toControllerJoints(joints));
  posture.bits = bits;
  posture.turns = turnsOf(posture.joints);
  return posture;
}

}  // namespace cobot_command::kinematics
