// What the controller says on the script port, and what it means for the link.

#include "script_outputs.h"
#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/overloaded.h"
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
  heard_at_ = now;
  if (state_ == State::Probing) {
    heard_ = fmt::format("{} ({})", frame.header, protocol::describe(*message));
  }
  const std::uint64_t late_before = requests().late();
  take(*message, now);
  if (!traced) return;
  wire_.trace(
      now, Channel::Script, false, bytes,
      protocol::describe(*message) + (requests().late() > late_before ? " (no request waits for it)" : ""));
}

void ScriptLink::fault(std::string_view bytes, const std::string& meaning, Instant now) {
  ++decode_faults_;
  foreign_bytes_ = true;
  if (!wire_.isTraced(Channel::Script)) return;
  wire_.trace(now, Channel::Script, false, bytes, "not understood: " + meaning);
}

void ScriptLink::take(const protocol::ControllerMessage& message, Instant now) {
  std::visit(Overloaded{[&](const protocol::ListenNodeEntered& entered) {
                          listen_node_ = foreignText(entered.message);
                          fire(Event::NodeEntered, now);
                        },
                        [&](const protocol::ListenNodeState& state) { take(state, now); },
                        [&](const protocol::ListenData& data) { outputs_.emplace_back(data); },
                        [&](const protocol::CommunicationError& error) {
                          auto answer = requests_.take(error);
                          const bool left = error.code == protocol::CommunicationErrorCode::NotListening;
                          if (left) fire(Event::NodeLeft, now);
                          tell(std::move(answer), outputs_);
                        },
                        [&](const auto& answer) { tell(requests_.take(answer), outputs_); }},
             message);
}

void ScriptLink::take(const protocol::ListenNodeState& message, Instant now) {
  if (!requests_.takeNodeState()) return;
  unanswered_lifesigns_ = 0;
  lifesign_at_ = now + settings_.supervision_period;
  if (message.listening) listen_node_ = foreignText(message.message);
  if (!message.listening) {
    fire(Event::AnsweredFalse, now);
  } else {
    const bool is_back = state_ == State::Leaving && ++listening_since_exit_ >= kStillListening;
    fire(is_back ? Event::StillListening : Event::AnsweredTrue, now);
  }
}

}  // namespace cobot_command::link
