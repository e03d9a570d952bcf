// What each program begins with.
#pragma once

#include "draft.h"

namespace cobot_command::rapid {

/// The predefined types, data and routines, bound once, on the first call. Each check begins with a copy.
[[nodiscard]] const Draft& predefinedDraft();

}  // namespace cobot_command::rapid
