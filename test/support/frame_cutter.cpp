#include "frame_cutter.h"

#include <algorithm>
#include <charconv>
#include <utility>

namespace cobot_command::testing {
namespace {

constexpr std::size_t kLongestField = 16;
constexpr std::size_t kTail = 6;  // ",*CS\r\n"

bool isLetter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

/// As far as it is there, the end of a frame.
bool mayEnd(std::string_view tail) {
  const std::string_view expected = ",*..\r\n";
  for (std::size_t i = 0; i < tail.size(); ++i) {
    if (expected[i] != '.' && expected[i] != tail[i]) return false;
  }
  return true;
}

}  // namespace

std::optional<FrameCutter::Piece> FrameCutter::next() {
  if (buffer_.empty()) return std::nullopt;
  protocol::Frame frame;
  std::size_t size = 0;
  if (buffer_.front() == '$') {
    switch (look(frame, size)) {
      case Found::TooShort:
        return std::nullopt;
      case Found::Frame:
        // Another LENGTH of the same number, or a wrong checksum, has to arrive as it was sent.
        if (buffer_.compare(0, size, protocol::encodeFrame(frame.header, frame.data)) != 0) {
          return Piece(take(size));
        }
        buffer_.erase(0, size);
        return Piece(std::move(frame));
      case Found::NoFrame:
        return Piece(take(std::min(buffer_.find('$', 1), buffer_.size())));
    }
  }
  return Piece(take(std::min(buffer_.find('$'), buffer_.size())));
}

FrameCutter::Found FrameCutter::look(protocol::Frame& frame, std::size_t& size) const {
  const auto field = [&](std::size_t begin) { return buffer_.find(',', begin); };
  const auto unfinished = [&](std::size_t begin) {
    return buffer_.size() - begin > kLongestField ? Found::NoFrame : Found::TooShort;
  };
  const std::size_t header_end = field(1);
  const std::string header = buffer_.substr(1, header_end - 1);  // as far as it is there
  if (!std::all_of(header.begin(), header.end(), isLetter)) return Found::NoFrame;
  if (header_end == std::string::npos) return unfinished(1);
  const std::size_t length_end = field(header_end + 1);
  const char* const digits = buffer_.data() + header_end + 1;
  std::size_t length = 0;
  const char* const digits_end = buffer_.data() + std::min(length_end, buffer_.size());
  const auto read = std::from_chars(digits, digits_end, length);
  const bool is_number = digits == digits_end || (read.ec == std::errc() && read.ptr == digits_end);
  if (!is_number || length > protocol::kMaxDataLength || header_end == 1) return Found::NoFrame;
  if (length_end == std::string::npos) return unfinished(header_end + 1);
  if (digits == digits_end) return Found::NoFrame;
  size = length_end + 1 + length + kTail;
  // What stands where the end has to be says soon whether this is one.
  if (!mayEnd(std::string_view(buffer_).substr(std::min(size - kTail, buffer_.size()), kTail))) {
    return Found::NoFrame;
  }
  if (buffer_.size() < size) return Found::TooShort;
  frame = {header, buffer_.substr(length_end + 1, length)};
  return Found::Frame;
}

std::string FrameCutter::take(std::size_t size) {
  std::string bytes = buffer_.substr(0, size);
  buffer_.erase(0, size);
  return bytes;
}

}  // namespace cobot_command::testing
