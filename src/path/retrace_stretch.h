// A part of a retrace, from rest to rest, over a way without cuts.
#pragma once

#include <cstddef>
#include <vector>

#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/command.h"
#include "cobot_command/path/driven_path.h"
#include "cobot_command/path/retrace.h"

namespace cobot_command::path {

struct RetraceStretch {
  Duration from{};
  Duration to{};
  arm::JointVector start;  ///< at `from`, or next to it [rad]
  arm::JointVector end;    ///< at `to`, or next to it
};

/// In their order: from cut to cut.
[[nodiscard]] std::vector<RetraceStretch> stretchesOf(const Retrace& retrace, const DrivenPath& driven);

[[nodiscard]] Duration durationOf(const RetraceStretch& stretch, double rate);
/// More than `most` only where it is refused for that: then how many more nobody knows.
[[nodiscard]] std::vector<motion::PvtJointPoint> pvtOf(const RetraceStretch& stretch, double rate,
                                                       const DrivenPath& driven, std::size_t most);

}  // namespace cobot_command::path
