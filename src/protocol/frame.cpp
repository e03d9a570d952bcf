#include "cobot_command/protocol/frame.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>

#include "characters.h"
#include <fmt/format.h>

namespace cobot_command::protocol {

std::uint8_t checksum(std::string_view bytes) {
  // Four independent words at a time: the loop then runs as fast as memory, not as fast as one XOR after
  // another.
  std::array<std::uint64_t, 4> lanes{};
  while (bytes.size() >= sizeof(lanes)) {
    std::array<std::uint64_t, 4> block;
    std::memcpy(block.data(), bytes.data(), sizeof(block));
    for (std::size_t i = 0; i < lanes.size(); ++i) lanes[i] ^= block[i];
    bytes.remove_prefix(sizeof(block));
  }
  std::uint64_t folded = lanes[0] ^ lanes[1] ^ lanes[2] ^ lanes[3];
  folded ^= folded >> 32;
  folded ^= folded >> 16;
  folded ^= folded >> 8;
  auto sum = static_cast<std::uint8_t>(folded);
  for (const char byte : bytes) sum = static_cast<std::uint8_t>(sum ^ static_cast<unsigned char>(byte));
  return sum;
}

std::string encodeFrame(std::string_view header, std::string_view data) {
  return encodeFrame(header, {data});
}

std::string encodeFrame(std::string_view header, std::initializer_list<std::string_view> data) {
  assert(!header.empty() && std::all_of(header.begin(), header.end(), isLetter));
  std::size_t size = 0;
  for (const std::string_view part : data) size += part.size();
  assert(size <= kMaxDataLength);
  constexpr std::string_view kHexDigits = "0123456789ABCDEF";
  const fmt::format_int length(size);

  std::string frame;
  frame.reserve(header.size() + length.size() + size + std::size_t{9});
  frame += '$';
  frame += header;
  frame += ',';
  frame.append(length.data(), length.size());
  frame += ',';
  for (const std::string_view part : data) frame += part;
  frame += ',';
  const std::uint8_t sum = checksum(std::string_view(frame).substr(1));
  frame += '*';
  frame += kHexDigits[sum >> 4u];
  frame += kHexDigits[sum & 0x0Fu];
  frame += "\r\n";
  return frame;
}

}  // namespace cobot_command::protocol
