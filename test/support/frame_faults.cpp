#include "frame_faults.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace cobot_command::testing {
namespace {

using Kind = FaultKind;

bool isOnConnections(Kind kind) {
  return kind == Kind::Refuse || kind == Kind::Silence || kind == Kind::CloseAtOnce ||
         kind == Kind::NeverRead;
}

bool beginsWith(const std::string& text, std::string_view start) {
  return std::string_view(text).substr(0, start.size()) == start;
}

bool isMeant(Which which, const protocol::Frame& frame) {
  switch (which) {
    case Which::Any:
      return true;
    case Which::Script:
      return frame.header == protocol::header::kScript && !beginsWith(frame.data, "0,");
    case Which::Tag:
      return frame.header == protocol::header::kStatus && beginsWith(frame.data, "01,");
    case Which::NodeState:
      return frame.header == protocol::header::kStatus && beginsWith(frame.data, "00");
  }
  return false;
}

std::string encoded(const protocol::Frame& frame) {
  return protocol::encodeFrame(frame.header, frame.data);
}

/// The frame with this text for its LENGTH; all else of it is right.
std::string withLength(const protocol::Frame& frame, const std::string& length) {
  const std::string inside = fmt::format("{},{},{},", frame.header, length, frame.data);
  return fmt::format("${}*{:02X}\r\n", inside, protocol::checksum(inside));
}

std::string withWrongChecksum(const protocol::Frame& frame) {
  std::string bytes = encoded(frame);
  char& digit = bytes[bytes.size() - 3];
  digit = digit == '0' ? '1' : '0';
  return bytes;
}

/// The id of the script, and all that stands behind its comma.
std::pair<std::string, std::string> splitId(const protocol::Frame& frame) {
  const std::size_t comma = std::min(frame.data.find(','), frame.data.size());
  return {frame.data.substr(0, comma), frame.data.substr(comma)};
}

/// An `OK` that no controller has given.
Step ownAnswer(const protocol::Frame& script, int ids_ahead) {
  const std::string id = splitId(script).first;
  const bool is_number = !id.empty() && id.find_first_not_of("0123456789") == std::string::npos;
  const std::string other = is_number ? std::to_string(std::stoll(id) + ids_ahead) : id;
  return {Step::Kind::Send, Direction::ToClient,
          protocol::encodeFrame(protocol::header::kScript, other + ",OK"), Duration{}};
}

}  // namespace

bool FrameFaults::has(FaultKind kind) const {
  return std::any_of(armed_.begin(), armed_.end(), [&](const Armed& a) { return a.fault.kind == kind; });
}

bool FrameFaults::neverReads(Direction direction) const {
  return std::any_of(armed_.begin(), armed_.end(), [&](const Armed& a) {
    return a.fault.kind == Kind::NeverRead && a.fault.direction == direction;
  });
}

FrameFaults::Armed* FrameFaults::striking(Direction direction, const protocol::Frame& frame) {
  Armed* found = nullptr;
  for (Armed& armed : armed_) {
    const Fault& fault = armed.fault;
    if (isOnConnections(fault.kind) || fault.direction != direction || !isMeant(fault.which, frame)) continue;
    const std::size_t index = armed.seen++;
    if (found == nullptr && index >= fault.first && armed.struck < fault.count) found = &armed;
  }
  return found;
}

std::vector<Step> FrameFaults::pass(Direction direction, const protocol::Frame& frame) {
  Armed* const armed = striking(direction, frame);
  std::vector<Step> steps;
  if (armed == nullptr) {
    steps.push_back({Step::Kind::Send, direction, encoded(frame), Duration{}});
    return steps;
  }
  ++armed->struck;
  ++strikes_;
  return strike(*armed, frame);
}

std::vector<Step> FrameFaults::strike(Armed& armed, const protocol::Frame& frame) {
  const Fault& fault = armed.fault;
  const auto step = [&](Step::Kind kind, std::string bytes, Duration wait = Duration{}) {
    return std::vector<Step>{{kind, fault.direction, std::move(bytes), wait}};
  };
  switch (fault.kind) {
    case Kind::Delay:
      return step(Step::Kind::SendDelayed, encoded(frame), waitOf(fault));
    case Kind::Overtaken:
      return step(Step::Kind::SendOvertaken, encoded(frame), waitOf(fault));
    case Kind::Merge:
      return step(Step::Kind::SendMerged, encoded(frame), waitOf(fault));
    case Kind::ByteByByte:
    case Kind::Cut:
      return inPieces(fault, encoded(frame));
    case Kind::WrongChecksum:
    case Kind::Garbage:
    case Kind::BadLength:
    case Kind::OtherId:
    case Kind::Cperr:
      return step(Step::Kind::Send, spoilt(fault, frame));
    case Kind::Reset:
      return step(Step::Kind::Reset, "");
    case Kind::Close:
      return step(Step::Kind::Close, "");
    default:
      return several(armed, frame);
  }
}

std::vector<Step> FrameFaults::several(Armed& armed, const protocol::Frame& frame) {
  const Fault& fault = armed.fault;
  const std::string bytes = encoded(frame);
  const auto send = [&](std::string some) {
    return Step{Step::Kind::Send, fault.direction, std::move(some), Duration{}};
  };
  switch (fault.kind) {
    case Kind::Duplicate:
      return {send(bytes), send(bytes)};
    case Kind::Echo:
      return {send(bytes), {Step::Kind::SendOvertaken, fault.direction, bytes, waitOf(fault)}};
    case Kind::Swap:
      if (armed.held.empty()) {
        armed.held = bytes;
        return {};
      }
      return {send(bytes), send(std::exchange(armed.held, {}))};
    case Kind::WrongChecksumThenGood:
      return {send(withWrongChecksum(frame)), send(bytes)};
    case Kind::AnswerFirst:
      return {ownAnswer(frame, 0), send(bytes)};
    case Kind::AnswerAhead:
      return {ownAnswer(frame, 1), send(bytes)};
    default:
      return {};  // Drop; what happens to connections strikes no frame
  }
}

std::vector<Step> FrameFaults::inPieces(const Fault& fault, const std::string& bytes) {
  std::vector<Step> steps;
  const auto add = [&](std::string piece, Duration wait) {
    steps.push_back({Step::Kind::Send, fault.direction, std::move(piece), wait});
  };
  if (fault.kind == Kind::Cut) {
    const std::size_t cut = 1 + upTo(bytes.size() - 2);
    add(bytes.substr(0, cut), Duration{});
    add(bytes.substr(cut), waitOf(fault));
    return steps;
  }
  const Duration pause = fault.rate > 0 ? fromSeconds(1 / fault.rate) : Duration{};
  for (const char byte : bytes) add(std::string(1, byte), pause);
  return steps;
}

std::string FrameFaults::spoilt(const Fault& fault, const protocol::Frame& frame) {
  switch (fault.kind) {
    case Kind::WrongChecksum:
      return withWrongChecksum(frame);
    case Kind::BadLength:
      return withLength(frame, fault.text);
    case Kind::OtherId: {
      const auto [id, rest] = splitId(frame);
      return protocol::encodeFrame(frame.header, id + "000" + rest);
    }
    case Kind::Cperr:
      return protocol::encodeFrame(protocol::header::kCommunicationError, fault.text);
    default:
      break;
  }
  std::string garbage = fault.text;
  if (garbage.empty()) {
    for (std::size_t left = 1 + upTo(40); left > 0; --left) garbage += static_cast<char>('0' + upTo(70));
  }
  return garbage + encoded(frame);
}

Duration FrameFaults::waitOf(const Fault& fault) {
  if (fault.jitter <= Duration::zero()) return fault.time;
  const double seconds = toSeconds(fault.jitter);
  const double more = std::uniform_real_distribution<double>(-seconds, seconds)(random_);
  return std::max(Duration::zero(), fault.time + fromSeconds(more));
}

}  // namespace cobot_command::testing
