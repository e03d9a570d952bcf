// The pose configuration: three bits that select one of up to eight postures of a pose.
//
// Source: I848-E-03 appendix figure (page 241); thesis 4.3.1, figures 4.3.1 to 4.3.4. The numbers are those
// of the controller (Config1 0/1, Config2 2/3, Config3 4/5).
#pragma once

#include <array>
#include <optional>
#include <string>

#include "cobot_command/arm/types.h"

namespace cobot_command::arm {

class ArmModel;

enum class Shoulder : int { Righty = 0, Lefty = 1 };
enum class Elbow : int { Above = 2, Below = 3 };
enum class Wrist : int { NoFlip = 4, Flip = 5 };

struct PoseBits {
  Shoulder shoulder = Shoulder::Righty;
  Elbow elbow = Elbow::Above;
  Wrist wrist = Wrist::NoFlip;

  /// {Config1, Config2, Config3} as in a TM script.
  [[nodiscard]] std::array<int, 3> numbers() const;
  /// From Config1..3 of a TM script; std::nullopt if one is outside 0..1, 2..3, 4..5.
  [[nodiscard]] static std::optional<PoseBits> fromNumbers(int config1, int config2, int config3);

  friend bool operator==(const PoseBits& a, const PoseBits& b) {
    return a.shoulder == b.shoulder && a.elbow == b.elbow && a.wrist == b.wrist;
  }
  friend bool operator!=(const PoseBits& a, const PoseBits& b) { return !(a == b); }
};

/// The bits of a posture; whole turns of a joint do not change them. At a singularity (J3 = 0, J5 = 0 or the
/// wrist centre on the shoulder cylinder) the strict inequalities of the manual do not define a bit. The
/// "else" case of the manual then applies (Lefty, Below, Flip).
[[nodiscard]] PoseBits poseBitsOf(const ArmModel& arm, const JointVector& joints);

/// As text: "RIGHTY ABOVE NOFLIP".
[[nodiscard]] std::string toString(const PoseBits& bits);

}  // namespace cobot_command::arm
