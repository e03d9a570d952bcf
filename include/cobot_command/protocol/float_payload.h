// Payload of ListenSend() with a float or float[]: four bytes per number, little endian, concatenated (TM
// 1.5). The payload does not contain the count; the requesting side must know it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/common/result.h"
#include "cobot_command/protocol/message.h"

namespace cobot_command::protocol {

/// Exactly `count` finite numbers. Refused: another length; a number that is not finite, and the message
/// names the first one.
[[nodiscard]] Result<std::vector<float>, MessageFault> parseFloats(std::string_view payload,
                                                                   std::size_t count);
[[nodiscard]] std::string floatPayload(const std::vector<float>& numbers);

}  // namespace cobot_command::protocol
