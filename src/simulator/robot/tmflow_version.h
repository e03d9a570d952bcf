// Versions of TMflow, as the settings name them.
#pragma once

#include <string>

#include "cobot_command/tm_script/functions.h"

namespace cobot_command::simulator {

/// The first with priority commands and the new WaitQueueTag.
inline constexpr tm_script::Version kPriorityCommands{1, 82};

/// "1.80"; what is no version is taken for that one.
[[nodiscard]] tm_script::Version tmflowVersion(const std::string& text);

}  // namespace cobot_command::simulator
