// Numbers in what a script sends with ListenSend(): of a float or float[], four bytes each, the lowest first,
// one behind the other (TM 1.5). The payload does not tell how many they are: who has asked knows.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/common/result.h"
#include "cobot_command/protocol/message.h"

namespace cobot_command::protocol {

/// Exactly `count` finite numbers. Refused: another length, and numbers that are none; the message names the
/// first one.
[[nodiscard]] Result<std::vector<float>, MessageFault> parseFloats(std::string_view payload,
                                                                   std::size_t count);
[[nodiscard]] std::string floatPayload(const std::vector<float>& numbers);

}  // namespace cobot_command::protocol
