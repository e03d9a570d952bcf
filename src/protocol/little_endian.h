// Numbers as BINARY items hold them.
#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>

#include <boost/endian/conversion.hpp>

namespace cobot_command::protocol {

/// An integer of the size of the number.
template <class Number>
using Word = std::conditional_t<
    sizeof(Number) == 8, std::uint64_t,
    std::conditional_t<sizeof(Number) == 4, std::uint32_t,
                       std::conditional_t<sizeof(Number) == 2, std::uint16_t, std::uint8_t>>>;

/// Precondition: there is place for sizeof(Number) bytes.
template <class Number>
void writeNumber(char* place, Number number) {
  static_assert(std::is_integral_v<Number> || std::numeric_limits<Number>::is_iec559);
  Word<Number> word{};
  std::memcpy(&word, &number, sizeof(word));
  boost::endian::native_to_little_inplace(word);
  std::memcpy(place, &word, sizeof(word));
}

template <class Number>
void appendNumber(std::string& bytes, Number number) {
  std::array<char, sizeof(number)> raw;
  writeNumber(raw.data(), number);
  bytes.append(raw.data(), raw.size());
}

/// Precondition: bytes has sizeof(Number) bytes.
template <class Number>
[[nodiscard]] Number readNumber(std::string_view bytes) {
  assert(bytes.size() >= sizeof(Number));
  Word<Number> word{};
  std::memcpy(&word, bytes.data(), sizeof(word));
  boost::endian::little_to_native_inplace(word);
  Number number{};
  std::memcpy(&number, &word, sizeof(word));
  return number;
}

}  // namespace cobot_command::protocol
