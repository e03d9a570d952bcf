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
    Garbage,     ///< bytes before a '$' were skipped; the controller does not answer these
    Length,      ///< LENGTH missing, not a number, negative, over the limit, or DATA is not followed by
                 ///< ",*CS\r\n" (CPERR 01)
    Checksum,    ///< CS is not two hexadecimal digits or not the XOR (CPERR 02)
    Header,      ///< HEADER is empty or overlong, or holds bytes that no header has (CPERR 03)
    Incomplete,  ///< the stream ended inside a frame; only after finish()
  };
  Kind kind = Kind::Garbage;
  std::string message;  ///< found, expected
  std::string bytes;    ///< what was dropped, as far as it was read, at most the first kMaxReportedBytes
};

/// The most bytes that a fault quotes; a run of garbage is reported when it ends or when it is this long.
inline constexpr std::size_t kMaxReportedBytes = 256;
/// The longest header that is waited for; the known ones have five letters.
inline constexpr std::size_t kMaxHeaderLength = 16;

/// "garbage", "length", "checksum", "header", "incomplete"
[[nodiscard]] const char* toString(DecodeFault::Kind kind);

using DecodeEvent = std::variant<Frame, DecodeFault>;

/// Time is linear in the bytes that are fed, in pieces of any size; which events come, and what they say,
/// does not depend on the pieces.
///
/// Faults: a frame whose end is where its LENGTH says is dropped whole (Checksum, Header). Any other bad
/// frame has no known end (Length, overlong Header), so the decoder looks for the next '$' that is followed
/// by a letter, from the byte after the bad frame's own '$'. Either way there is one fault for one bad frame,
/// and one for a run of garbage. LENGTH is written as 25, 0x19 or 0b11001. A frame without "\r\n" is waited
/// for.
class FrameDecoder {
 public:
  struct Options {
    /// Accept an empty LENGTH and search for ",*CS\r\n" instead: some bridges send it (TM 1.6). Off
    /// by default.
    bool accept_empty_length = false;
  };

  FrameDecoder() = default;
  explicit FrameDecoder(Options options) : options_(options) {}

  /// Takes the next bytes of the stream, in pieces of any size. Call next() until it gives nothing after each
  /// piece: that is what keeps the memory bounded.
  void feed(std::string_view bytes);

  /// No more bytes will come: what is incomplete is a fault now, and next() goes on behind it.
  void finish() { finished_ = true; }

  /// The next complete frame or fault, in the order of the stream; nothing when more bytes are needed.
  [[nodiscard]] std::optional<DecodeEvent> next();

  /// The frame that next() gave last, as it came: with its length and checksum as the peer wrote them. Until
  /// the next call of anything else than this; empty before the first frame.
  [[nodiscard]] std::string_view lastFrame() const {
    return std::string_view(buffer_).substr(begin_ - frame_size_, frame_size_);
  }

  /// Bytes that are stored and not yet part of an event.
  [[nodiscard]] std::size_t pending() const { return buffer_.size() - begin_; }

  /// Forgets all bytes: for a new connection.
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
  std::size_t begin_ = 0;         ///< of the bytes in the buffer that are still wanted
  std::size_t frame_size_ = 0;    ///< of the frame in front of them that was given last
  std::size_t needed_ = 0;        ///< pending bytes below which the frame at begin_ cannot go on
  std::size_t start_sought_ = 0;  ///< no frame starts in so many pending bytes
  std::size_t end_sought_ = 0;    ///< no frame of empty LENGTH ends in so many pending bytes
  bool in_step_ = true;           ///< a frame starts at begin_, or it is garbage
  bool reported_ = false;         ///< out of step, and the fault that says so was given
  bool finished_ = false;
};

}  // namespace cobot_command::protocol
