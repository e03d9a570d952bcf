#include "cobot_command/arm/pose_bits.h"

#include <cmath>

#include "wrist_centre.h"
#include <fmt/format.h>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/units.h"

namespace cobot_command::arm {
namespace {

/// Positive in (0, 180] degrees and whole turns away from it: the bits name a posture, not its turns.
bool isPositive(double angle) {
  return std::remainder(angle, 2 * kPi) > 0;
}

}  // namespace

std::array<int, 3> PoseBits::numbers() const {
  return {static_cast<int>(shoulder), static_cast<int>(elbow), static_cast<int>(wrist)};
}

std::optional<PoseBits> PoseBits::fromNumbers(int config1, int config2, int config3) {
  const bool allowed =
      (config1 == 0 || config1 == 1) && (config2 == 2 || config2 == 3) && (config3 == 4 || config3 == 5);
  if (!allowed) return std::nullopt;
  return PoseBits{static_cast<Shoulder>(config1), static_cast<Elbow>(config2), static_cast<Wrist>(config3)};
}

PoseBits poseBitsOf(const ArmModel& arm, const JointVector& joints) {
  const bool righty = wristCentreDistance(arm.lengths(), joints) > 0;
  // Not "same sign": exactly on the singularity the manual's inequalities hold for neither side.
  const auto towards = [righty](double joint) { return isPositive(righty ? joint : -joint); };
  PoseBits bits;
  bits.shoulder = righty ? Shoulder::Righty : Shoulder::Lefty;
  bits.elbow = towards(joints[2]) ? Elbow::Above : Elbow::Below;
  bits.wrist = towards(joints[4]) ? Wrist::NoFlip : Wrist::Flip;
  return bits;
}

std::string toString(const PoseBits& bits) {
  return fmt::format("{} {} {}", bits.shoulder == Shoulder::Righty ? "RIGHTY" : "LEFTY",
                     bits.elbow == Elbow::Above ? "ABOVE" : "BELOW",
                     bits.wrist == Wrist::NoFlip ? "NOFLIP" : "FLIP");
}

}  // namespace cobot_command::arm
