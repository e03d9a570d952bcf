// What a status client reads out of the bytes that it got.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "cobot_command/protocol/frame_decoder.h"
#include "cobot_command/protocol/status_items.h"

namespace cobot_command::simulator::test {

inline std::vector<protocol::StatusFrame> framesIn(const std::string& bytes) {
  protocol::FrameDecoder decoder;
  decoder.feed(bytes);
  std::vector<protocol::StatusFrame> frames;
  while (const auto event = decoder.next()) {
    frames.push_back(protocol::parseStatusFrame(std::get<protocol::Frame>(*event)).value());
  }
  return frames;
}

inline std::vector<protocol::StatusItem> itemsOf(const protocol::StatusFrame& frame) {
  return protocol::parseBinaryItems(frame.content).value();
}

inline protocol::StatusItem itemNamed(const protocol::StatusFrame& frame, const std::string& name) {
  for (const protocol::StatusItem& item : itemsOf(frame)) {
    if (item.name == name) return item;
  }
  ADD_FAILURE() << "no item " << name;
  return {};
}

inline bool flag(const protocol::StatusFrame& frame, const std::string& name) {
  return protocol::item::asBool(itemNamed(frame, name)).value();
}

/// The content of a BINARY read request.
inline std::string readRequest(const std::vector<std::string>& names) {
  std::string content;
  for (const std::string& name : names) {
    content += static_cast<char>(name.size());
    content += '\0';
    content += name;
  }
  return content;
}

}  // namespace cobot_command::simulator::test
