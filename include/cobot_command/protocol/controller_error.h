// What the numbers of Error_Code mean.
#pragma once

#include <string_view>

namespace cobot_command::protocol {

/// The meaning of a code in a few words; empty for one that is not known here. The controller has 766 of them
/// (manual I848, error codes); these are those of motion and set-up (TM 2.6).
[[nodiscard]] std::string_view meaningOfError(int code);

}  // namespace cobot_command::protocol
