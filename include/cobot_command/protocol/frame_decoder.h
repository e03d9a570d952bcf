// Bytes in, frames and faults out: the incremental decoder for both directions and both ports.
//
// DATA is cut by LENGTH, never by searching; frames may arrive split or merged. Nothing that a peer sends
// makes it throw, loop, or store more than one frame of kMaxDataLength. Not thread-safe: one decoder for each
// connection.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "cobot_command/protocol/frame.h"

namespace cobot_command::protocol {

/// What was wrong with bytes that looked like a frame; in the controller's order of checks.
struct DecodeFault {
  enum class Kind {
    Garbage,   ///< bytes before a '$' were skipped; the controller does not answer these
    Length,    ///< LENGTH missing, not a number, negative, over the limit, or DATA is not followed by ",*"
               ///< (CPERR 01)
    Checksum,  ///< CS is not two hexadecimal digits or not the XOR (CPERR 02)
    Header     ///< HEADER is empty or overlong, or holds bytes that no header has (CPERR 03)
  };
  Kind kind = Kind::Garbage;
  std::string message;  ///< found, expected
  std::string bytes;    ///< what was dropped, at most the first 256 bytes
};

/// "garbage", "length", "checksum", "header"
[[nodiscard]] const char* toString(DecodeFault::Kind kind);

using DecodeEvent = std::variant<Frame, DecodeFault>;

class FrameDecoder {
 public:
  struct Options {
    /// Accept an empty LENGTH and search for ",*CS\r\n" instead: some bridges send it (fact sheet 1.6). Off
    /// by default.
    bool accept_empty_length = false;
  };

  FrameDecoder() = default;
  explicit FrameDecoder(Options options) : options_(options) {}

  /// Takes the next bytes of the stream, in pieces of any size.
  void feed(std::string_view bytes);

  /// The next complete frame or fault, in the order of the stream; nothing when more bytes are needed.
  /// After a fault it goes on at the next '$' that can start a frame.
  [[nodiscard]] std::optional<DecodeEvent> next();

  /// Bytes that are stored and not yet part of an event.
  [[nodiscard]] std::size_t pending() const { return buffer_.size() - begin_; }

  /// Forgets all bytes: for a new connection.
  void reset();

 private:
  Options options_;
  std::string buffer_;
  std::size_t begin_ = 0;
};

}  // namespace cobot_command::protocol
