// What a motion line of a script (mm, degrees, ms, %) means for the arm: a command of motion/ (SI).
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

/// What stands between PVTEnter and PVTExit: one motion.
struct PvtBlock {
  bool cartesian = false;
  std::vector<script::PvtPoint> points;
};

/// The script commands that move the arm to a place.
using ScriptMotion = std::variant<script::Ptp, script::Line, script::Circle, script::MovePtp,
                                  script::MoveLine, script::PLine, script::MovePLine, PvtBlock>;

/// Refused when the pose bits are not 0..1, 2..3, 4..5; all other checks are motion::plan's.
[[nodiscard]] Result<motion::Command, motion::Refusal> toMotion(const script::Ptp& ptp);
[[nodiscard]] Result<motion::Command, motion::Refusal> toMotion(const script::Line& line);
[[nodiscard]] Result<motion::Command, motion::Refusal> toMotion(const script::Circle& circle);
[[nodiscard]] Result<motion::Command, motion::Refusal> toMotion(const script::MovePtp& move);
[[nodiscard]] Result<motion::Command, motion::Refusal> toMotion(const script::MoveLine& move);
[[nodiscard]] Result<motion::Command, motion::Refusal> toMotion(const script::PLine& line);
[[nodiscard]] Result<motion::Command, motion::Refusal> toMotion(const script::MovePLine& move);
[[nodiscard]] Result<motion::Command, motion::Refusal> toMotion(const PvtBlock& pvt);
[[nodiscard]] Result<motion::Command, motion::Refusal> toMotion(const ScriptMotion& any);

/// How the motion passes into the one behind it; nothing when it stops: a blend value of 0 or below. Above
/// 100 % is 100 %. With a blend value it does not matter whether precise positioning is on: nothing settles
/// at a corner that is passed.
[[nodiscard]] std::optional<motion::Blend> blendOf(const ScriptMotion& motion);

}  // namespace cobot_command::planning
