// Where on a driven path joints are.
#pragma once

#include <functional>
#include <optional>

#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"
#include "cobot_command/path/driven_path.h"

namespace cobot_command::path {

struct WaySpan {
  Duration from{};
  Duration until{};
};

/// The nearest to `around`, by time, of the places in the span that the joints are at
/// (DrivenPath::kSamePlace). `give_up`, asked now and then, ends the search without one. Precondition:
/// it has pieces, and `around` is in the span.
[[nodiscard]] std::optional<Duration> placeBetween(const DrivenPath& driven, const arm::JointVector& joints,
                                                   const WaySpan& span, Duration around,
                                                   const std::function<bool()>& give_up = {});

}  // namespace cobot_command::path
