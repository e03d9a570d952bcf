#include "cobot_command/link/status_link.h"

#include <fmt/format.h>

#include "cobot_command/link/status_decoding.h"
#include "cobot_command/protocol/message.h"
#include "cobot_command/protocol/status_items.h"

namespace cobot_command::link {

using Event = StatusLinkEvent;

StatusLink::StatusLink(const LinkSettings& settings, Wire& wire)
    : settings_(settings), wire_(wire), back_off_(settings.retry_min, settings.retry_max) {}

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
  fire(Event::Opened, now);
}

void StatusLink::openFailed(const OpenFailure& failure, Instant now) {
  connection_.reset();
  diagnosis_ = fmt::format("no status stream from {}:{}: {}. Is Ethernet Slave enabled in TMflow?", host_,
                           port_, failure.message);
  fire(Event::OpenFailed, now);
}

void StatusLink::received(std::string_view bytes) {
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
  if (state_ == StatusLinkState::Streaming) diagnosis_ = "the status stream fell silent";
  fire(Event::Silence, now);
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
  const std::string bytes = protocol::encodeFrame(frame.header, frame.data);
  const auto status_frame = protocol::parseStatusFrame(frame);
  if (!status_frame) {
    fault(bytes, status_frame.error().message, now);
    return std::nullopt;
  }
  wire_.trace(now, Channel::Status, false, bytes, protocol::describe(frame));
  if (status_frame->mode != static_cast<int>(protocol::StatusMode::WriteBinary)) {
    diagnosis_ = fmt::format(
        "the status stream is sent in mode {} ({}), only BINARY can be read: set it in TMflow, Setting > "
        "Connection > Ethernet Slave",
        status_frame->mode,
        status_frame->mode == 2   ? "STRING"
        : status_frame->mode == 3 ? "JSON"
                                  : "unknown");
    deadline_ = now + settings_.status_timeout;  // it is alive; to reconnect would change nothing
    return std::nullopt;
  }
  const auto items = protocol::parseBinaryItems(status_frame->content);
  if (!items) {
    ++decode_faults_;
    diagnosis_ = fmt::format("the status stream cannot be read: {}", items.error().message);
    return std::nullopt;
  }
  diagnosis_.clear();
  back_off_.reset();
  fire(Event::Frame, now);
  return toRobotStatus(*items, now);
}

void StatusLink::fault(std::string_view bytes, std::string meaning, Instant now) {
  ++decode_faults_;
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
      deadline_ = now + back_off_.next();
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
