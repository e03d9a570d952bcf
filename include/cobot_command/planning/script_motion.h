// Converts a motion line of a script (mm, degrees, ms, %) to a command of motion/ (SI).
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "cobot_command/common/result.h"
#include "cobot_command/motion/blend.h"
#include "cobot_command/motion/command.h"
#include "cobot_command/motion/refusal.h"
#include "cobot_command/script/script_command.h"

namespace cobot_command::planning {

/// The points between PVTEnter and PVTExit: one motion.
struct PvtBlock {
  bool cartesian = false;
  std::vector<script::PvtPoint> points;
};

/// The script commands that move the arm to a target.
using ScriptMotion = std::variant<script::Ptp, script::Line, script::Circle, script::MovePtp,
                                  script::MoveLine, script::PLine, script::MovePLine, PvtBlock>;

/// Refused if the pose bits are not 0..1, 2..3, 4..5. motion::plan does all other checks.
[[nodiscard]] Result<motion::Command, motion::Refusal> toMotion(const script::Ptp& ptp);
[[nodiscard]] Result<motion::Command, motion::Refusal> toMotion(const script::Line& line);
[[nodiscard]] Result<motion::Command, motion::Refusal> toMotion(const script::Circle& circle);
[[nodiscard]] Result<motion::Command, motion::Refusal> toMotion(const script::MovePtp& move);
[[nodiscard]] Result<motion::Command, motion::Refusal> toMotion(const script::MoveLine& move);
[[nodiscard]] Result<motion::Command, motion::Refusal> toMotion(const script::PLine& line);
[[nodiscard]] Result<motion::Command, motion::Refusal> toMotion(const script::MovePLine& move);
[[nodiscard]] Result<motion::Command, motion::Refusal> toMotion(const PvtBlock& pvt);
[[nodiscard]] Result<motion::Command, motion::Refusal> toMotion(const ScriptMotion& any);

/// The blend into the next motion; std::nullopt if the motion stops: a blend value of 0 or below. A value
/// above 100 % counts as 100 %. With a blend value precise positioning has no effect, because the arm does
/// not settle at a blended corner.
[[nodiscard]] std::optional<motion::Blend> blendOf(const ScriptMotion& motion);

}  // namespace cobot_command::planning
