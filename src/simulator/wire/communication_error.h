// The CPERR code for a frame that could not be decoded; the same on both ports.
#pragma once

#include <optional>

#include "cobot_command/protocol/frame_decoder.h"
#include "cobot_command/protocol/message.h"

namespace cobot_command::simulator {

/// Nothing for what is passed over in silence: bytes between frames, and the torso of a frame at the end.
[[nodiscard]] inline std::optional<protocol::CommunicationErrorCode> codeFor(
    protocol::DecodeFault::Kind kind) {
  using Kind = protocol::DecodeFault::Kind;
  switch (kind) {
    case Kind::Length:
      return protocol::CommunicationErrorCode::Packet;
    case Kind::Checksum:
      return protocol::CommunicationErrorCode::Checksum;
    case Kind::Header:
      return protocol::CommunicationErrorCode::Header;
    case Kind::Garbage:
    case Kind::Incomplete:
      break;
  }
  return std::nullopt;
}

}  // namespace cobot_command::simulator
