// Meanings of the controller's error codes (Error_Code).
#pragma once

#include <string_view>

namespace cobot_command::protocol {

/// Short meaning of a code; empty for an unknown code. The controller has 766 codes (manual I848, error
/// codes); this table has those of motion and setup (TM 2.6).
[[nodiscard]] std::string_view meaningOfError(int code);

}  // namespace cobot_command::protocol
