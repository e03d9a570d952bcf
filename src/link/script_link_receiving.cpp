// What the controller says on the script port, and what it means for the link.

#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/link/script_link.h"

namespace cobot_command::link {

using Event = ScriptLinkEvent;
using State = ScriptLinkState;

namespace {

/// After a ScriptExit(), until an answer "in the Listen node" is believed: a controller that is still leaving
/// may give a few.
constexpr int kStillListening = 3;

}  // namespace

std::optional<ScriptLinkOutput> ScriptLink::next(Instant now) {
  while (outputs_.empty()) {
    const auto event = decoder_.next();
    if (!event) return std::nullopt;
    read(*event, now);
  }
  ScriptLinkOutput output = std::move(outputs_.front());
  outputs_.pop_front();
  return output;
}

void ScriptLink::read(const protocol::DecodeEvent& event, Instant now) {
  if (const auto* decode_fault = std::get_if<protocol::DecodeFault>(&event)) {
    fault(decode_fault->bytes, decode_fault->message, now);
    return;
  }
  const auto& frame = std::get<protocol::Frame>(event);
  const bool traced = wire_.isTraced(Channel::Script);
  // What the message says may close the connection, and the decoder forgets it then.
  const std::string bytes(traced ? decoder_.lastFrame() : "");
  if (frame.header == protocol::header::kItems && state_ == State::Probing) {
    fault(bytes, "frame of the status stream on the script port", now);
    diagnose(Trouble::StatusPort,
             fmt::format("{}:{} is the status port of a TM robot, not its script port", host_, port_));
    fire(Event::ForeignPeer, now);
    return;
  }
  const auto message = protocol::parseControllerMessage(frame);
  if (!message) {
    fault(bytes, message.error().message, now);
    return;
  }
  foreign_bytes_ = false;
  if (state_ == State::Probing) {
    heard_ = fmt::format("{} ({})", frame.header, protocol::describe(*message));
  }
  const std::uint64_t late_before = late_replies_;
  std::visit([&](const auto& value) { take(value, now); }, *message);
  if (!traced) return;
  wire_.trace(now, Channel::Script, false, bytes,
              protocol::describe(*message) + (late_replies_ > late_before ? " (nobody waits for it)" : ""));
}

void ScriptLink::fault(std::string_view bytes, const std::string& meaning, Instant now) {
  ++decode_faults_;
  foreign_bytes_ = true;
  if (!wire_.isTraced(Channel::Script)) return;
  wire_.trace(now, Channel::Script, false, bytes, "not understood: " + meaning);
}

void ScriptLink::take(const protocol::ListenNodeEntered& message, Instant now) {
  listen_node_ = foreignText(message.message);
  fire(Event::NodeEntered, now);
}

void ScriptLink::take(const protocol::ListenNodeState& message, Instant now) {
  if (!ledger_.takeNodeQuery()) {
    ++late_replies_;
    return;
  }
  unanswered_lifesigns_ = 0;
  lifesign_at_ = now + settings_.supervision_period;
  if (message.listening) listen_node_ = foreignText(message.message);
  fire(eventOf(message), now);
}

ScriptLinkEvent ScriptLink::eventOf(const protocol::ListenNodeState& message) {
  if (!message.listening) return Event::AnsweredFalse;
  if (state_ != State::Leaving) return Event::AnsweredTrue;
  return ++listening_since_exit_ < kStillListening ? Event::AnsweredTrue : Event::StillListening;
}

void ScriptLink::take(const protocol::ScriptReply& message, Instant /*now*/) {
  if (!ledger_.takeScript(message.id)) {
    ++late_replies_;
    return;
  }
  outputs_.push_back(ScriptAnswered{message.id, message});
}

void ScriptLink::take(const protocol::TagReport& message, Instant /*now*/) {
  const auto question = ledger_.takeTagQuery(message.tag);
  if (question && question->given_up && message.state != protocol::TagState::Complete) {
    ++late_replies_;  // what is complete stays so, anything else may have changed since
    return;
  }
  outputs_.push_back(TagReported{message.tag, question.has_value(), message.state});
}

void ScriptLink::take(const protocol::ListenData& /*message*/, Instant /*now*/) {
  // What the project sends with ListenSend() is recorded; no block asks for it.
}

void ScriptLink::take(const protocol::CommunicationError& message, Instant now) {
  const bool not_listening = message.code == protocol::CommunicationErrorCode::NotListening;
  // F1 can only be meant for a script; any other code may be meant for whatever was sent.
  const auto request = not_listening ? ledger_.takeOldestScript() : ledger_.takeOldest();
  if (not_listening) fire(Event::NodeLeft, now);
  if (!request) {
    ++late_replies_;
  } else if (request->kind == Request::Kind::Script) {
    outputs_.push_back(ScriptAnswered{request->script_id, message});
  } else if (request->kind == Request::Kind::TagQuery) {
    outputs_.push_back(TagQueryFailed{request->tag, protocol::describe(message)});
  }
}

}  // namespace cobot_command::link
