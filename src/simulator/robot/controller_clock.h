// The controller's clock, which shows 2000-01-01 00:00:00 at Instant{}, as texts.
#pragma once

#include <string>
#include <string_view>

#include "cobot_command/common/time.h"

namespace cobot_command::simulator {

/// The time in a format as GetNow() has: yyyy yy MM M dd d HH H hh h mm m ss s, f for each digit of a second,
/// tt for AM and PM; all else stands as it is.
[[nodiscard]] std::string clockText(Instant time, std::string_view format = "yyyy-MM-dd HH:mm:ss");
/// Hours, minutes and seconds: 00:01:05.
[[nodiscard]] std::string durationText(Duration duration);

}  // namespace cobot_command::simulator
