#include "cobot_command/protocol/float_payload.h"

#include <cmath>

#include "little_endian.h"
#include <fmt/format.h>

namespace cobot_command::protocol {

namespace {

auto fault(std::string message) {
  return refuse(MessageFault{MessageFault::Kind::Data, std::move(message)});
}

}  // namespace

Result<std::vector<float>, MessageFault> parseFloats(std::string_view payload, std::size_t count) {
  // Divided, not multiplied: a count from elsewhere must not wrap around.
  if (payload.size() % sizeof(float) != 0 || payload.size() / sizeof(float) != count) {
    return fault(fmt::format("expected {} float{} in {} bytes, found {} byte{}", count, count == 1 ? "" : "s",
                             count * sizeof(float), payload.size(), payload.size() == 1 ? "" : "s"));
  }
  std::vector<float> numbers;
  numbers.reserve(count);
  for (std::string_view left = payload; !left.empty(); left.remove_prefix(sizeof(float))) {
    numbers.push_back(readNumber<float>(left));
    if (std::isfinite(numbers.back())) continue;
    return fault(
        fmt::format("expected finite numbers, number {} of {} is {}", numbers.size(), count, numbers.back()));
  }
  return numbers;
}

std::string floatPayload(const std::vector<float>& numbers) {
  std::string payload;
  for (const float number : numbers) appendNumber(payload, number);
  return payload;
}

}  // namespace cobot_command::protocol
