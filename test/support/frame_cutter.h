// Cuts a stream into frames and what is none, without loss: for who passes it on.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "cobot_command/protocol/frame.h"

namespace cobot_command::testing {

class FrameCutter {
 public:
  /// A frame whose end is where its LENGTH says, whatever its checksum; or other bytes.
  using Piece = std::variant<protocol::Frame, std::string>;

  void feed(std::string_view bytes) { buffer_ += bytes; }
  /// Nothing while the beginning of a frame waits for its end.
  [[nodiscard]] std::optional<Piece> next();

 private:
  enum class Found { Frame, NoFrame, TooShort };
  [[nodiscard]] Found look(protocol::Frame& frame, std::size_t& size) const;
  [[nodiscard]] std::string take(std::size_t size);

  std::string buffer_;
};

}  // namespace cobot_command::testing
