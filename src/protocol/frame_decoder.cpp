#include "cobot_command/protocol/frame_decoder.h"

#include <algorithm>
#include <utility>

#include "characters.h"
#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::protocol {

namespace {

constexpr std::string_view kFrameEnd = ",*..\r\n";  // '.': a digit of CS
constexpr std::size_t kMaxLengthField = 2 + 32;     // 0b and 32 digits

std::string quoted(std::string_view bytes) {
  return '"' + foreignText(bytes, 32) + '"';
}

/// Whether the bytes are, as far as they go, ",*CS\r\n"; CS itself is not looked at. Gives how many are.
std::size_t matchFrameEnd(std::string_view bytes) {
  const std::size_t size = std::min(bytes.size(), kFrameEnd.size());
  for (std::size_t i = 0; i < size; ++i) {
    if (kFrameEnd[i] != '.' && kFrameEnd[i] != bytes[i]) return i;
  }
  return size;
}

bool isHexPair(std::string_view digits) {
  return hexValue(digits[0]) < 16 && hexValue(digits[1]) < 16;
}

bool endsLikeAFrame(std::string_view bytes) {
  if (bytes.size() < kFrameEnd.size()) return false;
  bytes.remove_prefix(bytes.size() - kFrameEnd.size());
  return matchFrameEnd(bytes) == kFrameEnd.size() && isHexPair(bytes.substr(2));
}

}  // namespace

const char* toString(DecodeFault::Kind kind) {
  switch (kind) {
    case DecodeFault::Kind::Garbage:
      return "garbage";
    case DecodeFault::Kind::Length:
      return "length";
    case DecodeFault::Kind::Checksum:
      return "checksum";
    case DecodeFault::Kind::Header:
      return "header";
    case DecodeFault::Kind::Incomplete:
      return "incomplete";
  }
  return "";
}

/// The frame that seems to start at begin_: what is known of it, and what is wrong with it.
struct FrameDecoder::Candidate {
  std::string_view bytes;  ///< from '$' to the last byte that is there
  std::size_t header_end = 0;
  std::size_t data_begin = 0;
  std::size_t data_end = 0;
  std::size_t frame_end = 0;  ///< 0 while it is not known for sure
  std::size_t needed = 0;     ///< bytes without which nothing more can be said

  DecodeFault::Kind kind = DecodeFault::Kind::Length;
  std::size_t examined = 0;  ///< bytes up to the one that is wrong; 0: nothing is wrong
  std::string message;

  [[nodiscard]] std::string_view header() const { return bytes.substr(1, header_end - 1); }
  [[nodiscard]] std::string_view data() const { return bytes.substr(data_begin, data_end - data_begin); }
  [[nodiscard]] std::string_view check() const { return bytes.substr(data_end + 2, 2); }

  bool needs(std::size_t count) {
    needed = count;
    return false;
  }
  bool fails(DecodeFault::Kind fault, std::size_t up_to, std::string why) {
    kind = fault;
    examined = up_to;
    message = std::move(why);
    return false;
  }
};

void FrameDecoder::feed(std::string_view bytes) {
  // Moving the rest to the front only when it is the smaller part keeps the time linear.
  if (begin_ > 0 && begin_ >= buffer_.size() - begin_) {
    buffer_.erase(0, begin_);
    begin_ = 0;
  }
  frame_size_ = 0;
  buffer_.append(bytes);
  finished_ = false;
}

std::optional<DecodeEvent> FrameDecoder::next() {
  while (pending() > 0) {
    if (in_step_ && buffer_[begin_] == '$') return readFrame();
    if (std::optional<DecodeFault> fault = skipToStart()) return DecodeEvent(std::move(*fault));
    if (!in_step_) break;
  }
  return std::nullopt;
}

std::optional<DecodeFault> FrameDecoder::skipToStart() {
  if (in_step_) {
    in_step_ = false;
    reported_ = false;
    start_sought_ = 0;
  }
  const std::string_view bytes = rest();
  std::size_t start = bytes.find('$', start_sought_);
  while (start < bytes.size() - 1 && !isLetter(bytes[start + 1])) start = bytes.find('$', start + 1);
  const bool found = start < bytes.size() - 1;
  if (!found && (finished_ || start > bytes.size())) start = bytes.size();

  std::optional<DecodeFault> fault;
  if (!reported_ && start > 0 && (found || finished_ || start >= kMaxReportedBytes)) {
    fault = DecodeFault{DecodeFault::Kind::Garbage, "expected '$', found " + quoted(bytes.substr(0, start)),
                        std::string(bytes.substr(0, std::min(start, kMaxReportedBytes)))};
    reported_ = true;
  }
  start_sought_ = start;
  if (reported_ || found) consume(start);
  in_step_ = found;
  return fault;
}

std::optional<DecodeEvent> FrameDecoder::readFrame() {
  if (pending() < needed_ && !finished_) return std::nullopt;
  Candidate candidate;
  candidate.bytes = rest();
  if (scan(candidate)) {
    Frame frame{std::string(candidate.header()), std::string(candidate.data())};
    consume(candidate.frame_end);
    frame_size_ = candidate.frame_end;
    return DecodeEvent(std::move(frame));
  }
  if (candidate.examined == 0) {
    needed_ = candidate.needed;
    if (!finished_) return std::nullopt;
    if (candidate.data_end > 0 && endsLikeAFrame(candidate.bytes)) {
      candidate.fails(DecodeFault::Kind::Length, candidate.bytes.size(),
                      fmt::format("LENGTH says that DATA has {} bytes, the stream ends before that",
                                  candidate.data_end - candidate.data_begin));
    } else {
      candidate.fails(DecodeFault::Kind::Incomplete, candidate.bytes.size(),
                      "the stream ends inside the frame " + quoted(candidate.bytes));
    }
  }
  return DecodeEvent(drop(candidate));
}

// The order is the controller's: length, checksum, header.
bool FrameDecoder::scan(Candidate& candidate) {
  if (!scanHeader(candidate) || !scanLength(candidate) || !scanEnd(candidate)) return false;
  const std::string_view check = candidate.check();
  const std::uint8_t sum = checksum(candidate.bytes.substr(1, candidate.data_end));
  if (!isHexPair(check) || (hexValue(check[0]) << 4u | hexValue(check[1])) != sum) {
    return candidate.fails(DecodeFault::Kind::Checksum, candidate.frame_end,
                           fmt::format("checksum is {}, expected {:02X}", quoted(check), sum));
  }
  const std::string_view name = candidate.header();
  if (name.empty() || !std::all_of(name.begin(), name.end(), isLetter)) {
    return candidate.fails(DecodeFault::Kind::Header, candidate.frame_end,
                           "header is " + quoted(name) + ", expected letters");
  }
  return true;
}

bool FrameDecoder::scanHeader(Candidate& candidate) const {
  const std::string_view bytes = candidate.bytes;
  const std::size_t limit = 1 + kMaxHeaderLength;
  for (std::size_t i = 1; i < bytes.size(); ++i) {
    if (bytes[i] == ',') {
      candidate.header_end = i;
      return true;
    }
    if (i == limit || bytes[i] == '$' || bytes[i] == '\r' || bytes[i] == '\n') {
      return candidate.fails(DecodeFault::Kind::Header, i + 1,
                             fmt::format("header {} is not followed by ',' within {} bytes",
                                         quoted(bytes.substr(1, i - 1)), kMaxHeaderLength));
    }
  }
  return candidate.needs(bytes.size() + 1);
}

bool FrameDecoder::scanLength(Candidate& candidate) {
  const std::string_view bytes = candidate.bytes;
  const std::size_t field = candidate.header_end + 1;
  const std::string_view prefix = bytes.substr(field, 2);
  const unsigned base = prefix == "0x" ? 16 : prefix == "0b" ? 2 : 10;
  const std::size_t digits = field + (base == 10 ? 0 : 2);
  std::size_t length = 0;
  for (std::size_t i = digits; i < bytes.size(); ++i) {
    if (bytes[i] == ',' && i > digits) {
      candidate.data_begin = i + 1;
      candidate.data_end = candidate.data_begin + length;
      return true;
    }
    if (bytes[i] == ',' && i == field && options_.accept_empty_length) {
      candidate.data_begin = i + 1;
      return searchEnd(candidate);
    }
    const unsigned digit = hexValue(bytes[i]);
    length = length * base + digit;
    if (digit >= base || length > kMaxDataLength || i - field >= kMaxLengthField) {
      return candidate.fails(
          DecodeFault::Kind::Length, i + 1,
          fmt::format("LENGTH is {}, expected a number from 0 to {} and ','",
                      quoted(bytes.substr(field, i - field + (bytes[i] == ',' ? 0 : 1))), kMaxDataLength));
    }
  }
  return candidate.needs(bytes.size() + 1);
}

// Where LENGTH is empty: the first bytes that are, or may yet become, the end of a frame are it.
bool FrameDecoder::searchEnd(Candidate& candidate) {
  const std::string_view bytes = candidate.bytes;
  std::size_t at = std::max(candidate.data_begin, end_sought_);
  for (;; ++at) {
    at = std::min(bytes.find(kFrameEnd.front(), at), bytes.size());
    const std::string_view end = bytes.substr(at, kFrameEnd.size());
    if (matchFrameEnd(end) == end.size() && (end.size() < kFrameEnd.size() || isHexPair(end.substr(2)))) {
      break;
    }
  }
  end_sought_ = at;
  candidate.data_end = at;
  if (at - candidate.data_begin > kMaxDataLength) {
    return candidate.fails(DecodeFault::Kind::Length, kMaxReportedBytes,
                           fmt::format("no end of the frame within {} bytes of DATA", kMaxDataLength));
  }
  return true;
}

bool FrameDecoder::scanEnd(Candidate& candidate) const {
  const std::string_view bytes = candidate.bytes;
  if (bytes.size() <= candidate.data_end) return candidate.needs(candidate.data_end + 1);
  const std::string_view end = bytes.substr(candidate.data_end, kFrameEnd.size());
  const std::size_t matched = matchFrameEnd(end);
  if (matched < end.size()) {
    return candidate.fails(DecodeFault::Kind::Length, candidate.data_end + matched + 1,
                           fmt::format("after DATA of {} bytes comes {}, expected \",*CS\\r\\n\"",
                                       candidate.data_end - candidate.data_begin, quoted(end)));
  }
  if (end.size() < kFrameEnd.size()) return candidate.needs(bytes.size() + 1);
  candidate.frame_end = candidate.data_end + kFrameEnd.size();
  return true;
}

DecodeFault FrameDecoder::drop(Candidate& candidate) {
  DecodeFault fault{candidate.kind, std::move(candidate.message),
                    std::string(candidate.bytes.substr(0, std::min(candidate.examined, kMaxReportedBytes)))};
  in_step_ = candidate.frame_end > 0;
  reported_ = true;
  start_sought_ = 0;
  consume(in_step_ ? candidate.frame_end : 1);
  return fault;
}

void FrameDecoder::consume(std::size_t count) {
  begin_ += count;
  frame_size_ = 0;
  needed_ = 0;
  start_sought_ -= std::min(start_sought_, count);
  end_sought_ -= std::min(end_sought_, count);
}

}  // namespace cobot_command::protocol
