// What texts of parameters that name things can be.
#pragma once

#include "cobot_command/common/setting_kinds.h"

namespace cobot_command::ros_adapter {

/// As "/cell".
[[nodiscard]] setting_kinds::TextRule absoluteNamespace();
[[nodiscard]] setting_kinds::TextRule absolutePath();

}  // namespace cobot_command::ros_adapter
