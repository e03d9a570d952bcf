#include "cobot_command/link/status_link.h"

#include "status_decoding.h"
#include <fmt/format.h>

#include "cobot_command/link/stream_items.h"
#include "cobot_command/protocol/message.h"
#include "cobot_command/protocol/status_items.h"

namespace cobot_command::link {

using Event = StatusLinkEvent;

namespace {

bool isOfScriptPort(const protocol::Frame& frame) {
  return frame.header == protocol::header::kScript || frame.header == protocol::header::kStatus ||
         frame.header == protocol::header::kCommunicationError;
}

/// Of a stream that comes; empty: it has all that every data table should have.
std::string textOfWhatItLacks(const RobotStatus& status) {
  std::string text;
  if (!status.unreadable.empty()) {
    text = fmt::format(
        "the status stream arrives, but the value of {} is invalid: wrong type or size, or a number that is "
        "not finite",
        fmt::join(status.unreadable, ", "));
  }
  const std::string missing = describe(missingItems(status));
  if (missing.empty()) return text;
  return fmt::format("{}{}the status stream does not have {}: {}", text, text.empty() ? "" : "; ", missing,
                     remedyForMissingItems());
}

}  // namespace

StatusLink::StatusLink(const LinkSettings& settings, Wire& wire) : settings_(settings), wire_(wire) {}

void StatusLink::start(const std::string& host, int port, Instant now) {
  host_ = host;
  port_ = port;
  back_off_.reset();
  diagnosis_ = "no status stream yet";
  fire(Event::Start, now);
}

void StatusLink::stop(Instant now) {
  fire(Event::Stop, now);
  diagnosis_.clear();
}

void StatusLink::opened(Instant now) {
  heard_ = Heard::Nothing;
  content_.reset();  // another controller may say the same, and is another one all the same
  questions_ = {};
  fire(Event::Opened, now);
}

void StatusLink::openFailed(const OpenFailure& failure, Instant now) {
  connection_.reset();
  diagnosis_ = fmt::format("no status stream from {}:{}: {}. Is Ethernet Slave enabled in TMflow?", host_,
                           port_, failure.message);
  fire(Event::OpenFailed, now);
}

void StatusLink::received(std::string_view bytes) {
  if (heard_ == Heard::Nothing && !bytes.empty()) heard_ = Heard::Garbage;  // until a frame is found in it
  decoder_.feed(bytes);
}

void StatusLink::closed(const std::string& reason, Instant now) {
  connection_.reset();
  diagnosis_ = fmt::format("the status stream was closed: {}", reason);
  fire(Event::Closed, now);
}

void StatusLink::advance(Instant now) {
  if (!deadline_ || now < *deadline_) return;
  if (state_ == StatusLinkState::BackingOff) {
    fire(Event::RetryDue, now);
    return;
  }
  diagnosis_ = silence();
  fire(Event::Silence, now);
}

std::string StatusLink::silence() const {
  if (heard_ == Heard::OtherFrames) return diagnosis_;
  if (heard_ == Heard::ScriptPort) {
    return fmt::format("{}:{} is the script port of a TM robot, not its status port (usually 5891)", host_,
                       port_);
  }
  if (state_ == StatusLinkState::Streaming) {
    return heard_ == Heard::Nothing ? "the status stream has stopped"
                                    : "the status stream has stopped: the data received are not its frames";
  }
  if (heard_ == Heard::Garbage) {
    return fmt::format("{}:{} sends data that are not the status stream of a TM robot: check the port", host_,
                       port_);
  }
  return fmt::format(
      "{}:{} is connected, but sends nothing: it is not the status port of a TM robot (usually 5891; the "
      "script port is silent too), or its data table in TMflow is empty",
      host_, port_);
}

std::optional<RobotStatus> StatusLink::next(Instant now) {
  while (const auto event = decoder_.next()) {
    if (const auto* decode_fault = std::get_if<protocol::DecodeFault>(&*event)) {
      fault(decode_fault->bytes, decode_fault->message, now);
    } else if (auto status = read(std::get<protocol::Frame>(*event), now)) {
      return status;
    }
  }
  return std::nullopt;
}

std::optional<RobotStatus> StatusLink::read(const protocol::Frame& frame, Instant now) {
  auto status_frame = protocol::parseStatusFrame(frame);
  if (!status_frame) {
    fault(decoder_.lastFrame(), status_frame.error().message, now);
    if (isOfScriptPort(frame)) heard_ = Heard::ScriptPort;
    return std::nullopt;
  }
  if (wire_.isTraced(Channel::Status)) {
    wire_.trace(now, Channel::Status, false, decoder_.lastFrame(), protocol::describe(frame));
  }
  if (questions_.take(*status_frame)) {
    questions_.complete(decoded_.identity);
    return std::nullopt;
  }
  if (status_frame->mode != static_cast<int>(protocol::StatusMode::WriteBinary)) {
    diagnosis_ = fmt::format(
        "the status stream is sent in mode {} ({}), only BINARY can be read: set it in TMflow, Setting > "
        "Connection > Ethernet Slave",
        status_frame->mode,
        status_frame->mode == 2   ? "STRING"
        : status_frame->mode == 3 ? "JSON"
                                  : "unknown");
    heard_ = Heard::OtherFrames;
    deadline_ = now + settings_.status_timeout;  // it is alive; to reconnect would change nothing
    return std::nullopt;
  }
  if (const auto unread = decode(std::move(status_frame->content))) {
    ++decode_faults_;
    heard_ = Heard::OtherFrames;
    diagnosis_ = fmt::format("the status stream cannot be read: {}", *unread);
    return std::nullopt;
  }
  heard_ = Heard::Nothing;
  back_off_.reset();
  // Behind the first frame: now it is known to be a status port.
  const bool is_first = state_ == StatusLinkState::Waiting;
  fire(Event::Frame, now);
  if (is_first) ask(now);
  diagnosis_ = lacking_;
  decoded_.received = now;
  return decoded_;
}

/// The fault, if it cannot be. A robot that stands says the same sixty times a second.
std::optional<std::string> StatusLink::decode(std::string content) {
  if (content == content_) return std::nullopt;
  const auto items = protocol::parseBinaryItems(content);
  if (!items) return items.error().message;
  decoded_ = toRobotStatus(*items, Instant{});
  questions_.complete(decoded_.identity);
  lacking_ = textOfWhatItLacks(decoded_);
  content_ = std::move(content);
  return std::nullopt;
}

void StatusLink::ask(Instant now) {
  for (const protocol::StatusFrame& request : IdentityQuestions::missingIn(decoded_.identity)) {
    std::string bytes = protocol::encode(request);
    if (wire_.isTraced(Channel::Status)) {
      wire_.trace(now, Channel::Status, true, bytes, fmt::format("asks for items, as \"{}\"", request.id));
    }
    wire_.send(*connection_, std::move(bytes));
  }
}

void StatusLink::fault(std::string_view bytes, std::string meaning, Instant now) {
  ++decode_faults_;
  if (!wire_.isTraced(Channel::Status)) return;
  wire_.trace(now, Channel::Status, false, bytes, "not a frame: " + std::move(meaning));
}

void StatusLink::fire(Event event, Instant now) {
  const auto row = findTransition<StatusLinkTable>(state_, event);
  if (!row) return;
  state_ = row->to;
  act(row->action, now);
}

void StatusLink::act(StatusLinkAction action, Instant now) {
  switch (action) {
    case StatusLinkAction::None:
      return;
    case StatusLinkAction::Open:
      deadline_.reset();
      connection_ = wire_.open(Channel::Status, host_, port_, settings_.open_timeout);
      return;
    case StatusLinkAction::Watch:
      deadline_ = now + settings_.status_timeout;
      return;
    case StatusLinkAction::Retry:
      drop();
      deadline_ = now + back_off_.next(settings_.retry_min, settings_.retry_max);
      return;
    case StatusLinkAction::Release:
      drop();
      deadline_.reset();
      return;
  }
}

void StatusLink::drop() {
  if (connection_) wire_.close(*connection_);
  connection_.reset();
  decoder_.reset();
}

}  // namespace cobot_command::link
