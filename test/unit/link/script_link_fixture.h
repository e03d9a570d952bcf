// A script link on a wire that records, and the events that fire the rows of its table.
#pragma once

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "recording_wire.h"
#include <gtest/gtest.h>

#include "cobot_command/link/script_link.h"
#include "cobot_command/protocol/status_items.h"

namespace cobot_command::link {

using namespace std::chrono_literals;
using protocol::CommunicationError;
using protocol::CommunicationErrorCode;
using protocol::ListenNodeEntered;
using protocol::ListenNodeState;

class ScriptLinkTest : public ::testing::Test {
 protected:
  using State = ScriptLinkState;
  using Event = ScriptLinkEvent;

  void say(const protocol::ControllerMessage& message) { receive(protocol::encode(message)); }
  void receive(const std::string& bytes) {
    link.received(bytes);
    drain();
  }
  void drain() {
    while (auto output = link.next(now)) outputs.push_back(*output);
  }
  template <class Output>
  std::vector<Output> all() const {
    std::vector<Output> found;
    for (const auto& output : outputs) {
      if (const auto* wanted = std::get_if<Output>(&output)) found.push_back(*wanted);
    }
    return found;
  }
  void advanceToDeadline() {
    now = std::max(now, *link.nextDeadline());
    link.advance(now);
    drain();
  }

  /// Brings a fresh link to a state, as a controller would.
  void bringTo(State state) {
    if (state == State::Disconnected) return;
    link.start("robot", 5890, now);
    if (state == State::BackingOff) link.openFailed({OpenFailure::Kind::Refused, "refused"}, now);
    if (state == State::BackingOff || state == State::Connecting) return drain();
    link.opened(now);
    if (state == State::Probing) return drain();
    say(ListenNodeState{state != State::NotListening, "Listen1"});
    if (state == State::Leaving) link.exitAccepted(now);
    drain();
    outputs.clear();
  }

  /// Makes an event happen from the outside.
  void make(Event event) {
    switch (event) {
      case Event::Start:
        link.start("robot", 5890, now);
        break;
      case Event::RetryDue:
      case Event::NoAnswer:
        for (int i = 0; i < 5 && link.nextDeadline() && link.state() == before; ++i) advanceToDeadline();
        break;
      case Event::Opened:
        link.opened(now);
        break;
      case Event::OpenFailed:
        link.openFailed({OpenFailure::Kind::TimedOut, "timed out"}, now);
        break;
      case Event::AnsweredTrue:
      case Event::AnsweredFalse:
        askedAgain();
        say(ListenNodeState{event == Event::AnsweredTrue, "Listen2"});
        break;
      case Event::NodeEntered:
        say(ListenNodeEntered{"Listen3"});
        break;
      case Event::NodeLeft:
        say(CommunicationError{CommunicationErrorCode::NotListening});
        break;
      case Event::ExitAccepted:
        link.exitAccepted(now);
        break;
      case Event::StillListening:
        for (int i = 0; i < 3; ++i) {
          askedAgain();
          say(ListenNodeState{true, "Listen2"});
        }
        break;
      case Event::ForeignPeer:
        receive(protocol::encode(protocol::StatusFrame{"0", 1, ""}));
        break;
      case Event::Closed:
        link.closed("gone", now);
        break;
      case Event::Stop:
        link.stop(now);
        break;
    }
    drain();
  }
  void askedAgain() {
    const std::size_t sent = wire.sent.size();
    if (before == State::Probing) return;
    for (int i = 0; i < 3 && link.nextDeadline() && wire.sent.size() == sent; ++i) advanceToDeadline();
  }

  testing::RecordingWire wire;
  LinkSettings settings;
  ScriptLink link{settings, wire};
  Instant now{100s};
  State before = State::Disconnected;
  std::vector<ScriptLinkOutput> outputs;
};

}  // namespace cobot_command::link
