// What a decoder gives, as text that can be compared: "HEADER:DATA" for a frame, the kind for a fault.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cobot_command/protocol/frame_decoder.h"

namespace cobot_command::protocol {

inline std::vector<std::string> drain(FrameDecoder& decoder) {
  std::vector<std::string> events;
  while (const auto event = decoder.next()) {
    const auto* frame = std::get_if<Frame>(&*event);
    events.push_back(frame != nullptr ? frame->header + ':' + frame->data
                                      : toString(std::get<DecodeFault>(*event).kind));
  }
  return events;
}

inline std::vector<std::string> decode(std::string_view bytes, FrameDecoder decoder = {}) {
  decoder.feed(bytes);
  return drain(decoder);
}

/// Fed in a first piece and others of one size.
inline std::vector<std::string> decodeInPieces(std::string_view bytes, std::size_t first, std::size_t others,
                                               FrameDecoder decoder = {}) {
  std::vector<std::string> events;
  for (std::size_t size = first; !bytes.empty(); size = others) {
    size = size < bytes.size() ? size : bytes.size();
    decoder.feed(bytes.substr(0, size));
    bytes.remove_prefix(size);
    for (auto& event : drain(decoder)) events.push_back(std::move(event));
  }
  return events;
}

}  // namespace cobot_command::protocol
