// Incremental decoder from bytes to frames and faults, for both directions and both ports.
//
// DATA is delimited by LENGTH, never by searching; frames may arrive split or merged. No input makes it
// throw, loop, or store more than one frame of kMaxDataLength. Not thread-safe: use one decoder per
// connection.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "cobot_command/protocol/frame.h"

namespace cobot_command::protocol {

/// The error in bytes that looked like a frame, in the order in which the controller checks.
struct DecodeFault {
  enum class Kind {
    Garbage,     ///< bytes before a '$' were skipped; the controller does not answer them
    Length,      ///< LENGTH is missing, not a number, negative or over the limit, or DATA is not followed by
                 ///< ",*CS\r\n" (CPERR 01)
    Checksum,    ///< CS is not two hexadecimal digits or not the XOR (CPERR 02)
    Header,      ///< HEADER is empty or too long, or has bytes that no header has (CPERR 03)
    Incomplete,  ///< the stream ended inside a frame; only after finish()
  };
  Kind kind = Kind::Garbage;
  std::string message;  ///< found, expected
  std::string bytes;    ///< the dropped bytes that were read, at most the first kMaxReportedBytes
};

/// The most bytes that a fault quotes. A run of garbage is reported when it ends or reaches this length.
inline constexpr std::size_t kMaxReportedBytes = 256;
/// The longest header that the decoder waits for; the known ones have five letters.
inline constexpr std::size_t kMaxHeaderLength = 16;

/// "garbage", "length", "checksum", "header", "incomplete"
[[nodiscard]] const char* toString(DecodeFault::Kind kind);

using DecodeEvent = std::variant<Frame, DecodeFault>;

/// The time is linear in the number of input bytes. The events and their content do not depend on how the
/// input is split into pieces.
///
/// Faults: a frame whose end is where its LENGTH says is dropped whole (Checksum, Header). Any other bad
/// frame (Length, overlong Header) has no known end, so the decoder looks for the next '$' that is followed
/// by a letter, from the byte after the bad frame's own '$'. In both cases a bad frame gives one fault, and a
/// run of garbage gives one. LENGTH is written as 25, 0x19 or 0b11001. The decoder waits for the "\r\n" of a
/// frame.
class FrameDecoder {
 public:
  struct Options {
    /// Accepts an empty LENGTH and searches for ",*CS\r\n" instead, because some bridges send it (TM 1.6).
    /// Off by default.
    bool accept_empty_length = false;
  };

  FrameDecoder() = default;
  explicit FrameDecoder(Options options) : options_(options) {}

  /// Adds the next bytes of the stream, in pieces of any size. Call next() after each piece until it returns
  /// nothing: this bounds the memory.
  void feed(std::string_view bytes);

  /// Marks the end of the stream: an incomplete frame is a fault now, and next() continues after it.
  void finish() { finished_ = true; }

  /// The next complete frame or fault, in the order of the stream; std::nullopt if more bytes are needed.
  [[nodiscard]] std::optional<DecodeEvent> next();

  /// The bytes of the last frame that next() returned, with length and checksum as the peer wrote them. Valid
  /// until the next call of any other function. Empty before the first frame.
  [[nodiscard]] std::string_view lastFrame() const {
    return std::string_view(buffer_).substr(begin_ - frame_size_, frame_size_);
  }

  /// Stored bytes that are not yet part of an event.
  [[nodiscard]] std::size_t pending() const { return buffer_.size() - begin_; }

  /// Discards all bytes, for a new connection.
  void reset() { *this = FrameDecoder(options_); }

 private:
  struct Candidate;

  [[nodiscard]] std::string_view rest() const { return std::string_view(buffer_).substr(begin_); }
  [[nodiscard]] std::optional<DecodeFault> skipToStart();
  [[nodiscard]] std::optional<DecodeEvent> readFrame();
  [[nodiscard]] bool scan(Candidate& candidate);
  [[nodiscard]] bool scanHeader(Candidate& candidate) const;
  [[nodiscard]] bool scanLength(Candidate& candidate);
  [[nodiscard]] bool searchEnd(Candidate& candidate);
  [[nodiscard]] bool scanEnd(Candidate& candidate) const;
  [[nodiscard]] DecodeFault drop(Candidate& candidate);
  void consume(std::size_t count);

  Options options_;
  std::string buffer_;
  std::size_t begin_ = 0;         ///< start of the unprocessed bytes in the buffer
  std::size_t frame_size_ = 0;    ///< size of the last returned frame, which ends at begin_
  std::size_t needed_ = 0;        ///< the frame at begin_ cannot progress with fewer pending bytes
  std::size_t start_sought_ = 0;  ///< number of pending bytes that contain no start of a frame
  std::size_t end_sought_ = 0;  ///< number of pending bytes that contain no end of a frame with empty LENGTH
  bool in_step_ = true;         ///< a frame starts at begin_, or the bytes there are garbage
  bool reported_ = false;       ///< out of step, and the fault was already returned
  bool finished_ = false;
};

}  // namespace cobot_command::protocol
