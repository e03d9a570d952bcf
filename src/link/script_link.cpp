#include "cobot_command/link/script_link.h"

#include <algorithm>

#include "script_outputs.h"
#include <fmt/format.h>

#include "cobot_command/common/deadline.h"

namespace cobot_command::link {

using Event = ScriptLinkEvent;
using State = ScriptLinkState;

namespace {

bool isBeforeConnection(Trouble trouble) {
  switch (trouble) {
    case Trouble::NotTriedYet:
    case Trouble::Refused:
    case Trouble::Unreachable:
    case Trouble::UnknownHost:
    case Trouble::OpenTimedOut:
    case Trouble::OpenFailed:
      return true;
    default:
      return false;
  }
}

struct Diagnosis {
  Trouble trouble;
  std::string text;
};

/// Why there was no connection before counts until the question has been asked for long enough.
Diagnosis asking(const std::string& peer, Trouble before, const std::string& diagnosis) {
  std::string text = fmt::format("connected to {}, asking for the Listen node", peer);
  if (before == Trouble::NotTriedYet) return {Trouble::Silent, std::move(text)};
  return {before, text + "; before that: " + diagnosis};
}

}  // namespace

ScriptLink::ScriptLink(const LinkSettings& settings, Wire& wire) : settings_(settings), wire_(wire) {}

void ScriptLink::start(const std::string& host, int port, Instant now) {
  host_ = host;
  port_ = port;
  back_off_.reset();
  diagnose(Trouble::NotTriedYet, fmt::format("connecting to {}:{}", host, port));
  fire(Event::Start, now);
}

void ScriptLink::stop(Instant now) {
  outputs_.clear();
  fire(Event::Stop, now);
  diagnose(Trouble::None, "not connected");
}

void ScriptLink::giveUp(std::string reason, Instant now) {
  if (!established()) return;
  diagnose(Trouble::Silent, std::move(reason));
  fire(Event::NoAnswer, now);
}

void ScriptLink::opened(Instant now) {
  fire(Event::Opened, now);
}

void ScriptLink::openFailed(const OpenFailure& failure, Instant now) {
  connection_.reset();
  switch (failure.kind) {
    case OpenFailure::Kind::Refused:
      diagnose(Trouble::Refused, fmt::format("connection refused by {}:{}: no project with a Listen node is "
                                             "running on the controller, or the port is wrong",
                                             host_, port_));
      break;
    case OpenFailure::Kind::Unreachable:
      diagnose(Trouble::Unreachable, fmt::format("{} is unreachable: {}", host_, failure.message));
      break;
    case OpenFailure::Kind::UnknownHost:
      diagnose(Trouble::UnknownHost, fmt::format("unknown host {}: {}", host_, failure.message));
      break;
    case OpenFailure::Kind::TimedOut:
      diagnose(Trouble::OpenTimedOut,
               fmt::format("{}:{} does not answer: controller off, or wrong address", host_, port_));
      break;
    case OpenFailure::Kind::Other:
      diagnose(Trouble::OpenFailed, fmt::format("no connection to {}:{}: {}", host_, port_, failure.message));
      break;
  }
  fire(Event::OpenFailed, now);
}

void ScriptLink::received(std::string_view bytes) {
  if (state_ == State::Probing) foreign_bytes_ = true;  // until it is understood
  decoder_.feed(bytes);
}

void ScriptLink::closed(const std::string& reason, Instant now) {
  connection_.reset();
  diagnose(Trouble::Closed,
           established() ? fmt::format("the connection was closed: {}", reason)
                         : fmt::format("{}:{} closed the connection at once: {}", host_, port_, reason));
  fire(Event::Closed, now);
}

void ScriptLink::advance(Instant now) {
  while (auto answer = requests_.takeExpired(now)) tell(std::move(answer), outputs_);
  if (retry_at_ && now >= *retry_at_) fire(Event::RetryDue, now);
  if (lifesign_at_ && now >= *lifesign_at_) lifesignDue(now);
}

std::optional<Instant> ScriptLink::nextDeadline() const {
  return earlier(requests_.nextDeadline(), earlier(retry_at_, lifesign_at_));
}

std::string ScriptLink::sendScript(const std::string& script, Instant now,
                                   std::optional<Duration> reply_timeout) {
  Request request;
  request.kind = Request::Kind::Script;
  request.script_id = requests_.newScriptId();
  request.patience = reply_timeout.value_or(settings_.reply_timeout);
  std::string id = request.script_id;
  transmit(protocol::ScriptRequest{id, script}, std::move(request), now);
  return id;
}

void ScriptLink::exitAccepted(Instant now) {
  listening_since_exit_ = 0;
  fire(Event::ExitAccepted, now);
}

void ScriptLink::queryTag(int tag, Instant now) {
  Request request;
  request.kind = Request::Kind::TagQuery;
  request.tag = tag;
  request.patience = settings_.reply_timeout;
  transmit(protocol::TagQuery{tag}, std::move(request), now);
}

void ScriptLink::transmit(const protocol::ClientMessage& message, Request request, Instant now) {
  request.handed_over = now;
  requests_.add(std::move(request));
  std::string bytes = protocol::encode(message);
  if (wire_.isTraced(Channel::Script)) {
    wire_.trace(now, Channel::Script, true, bytes, protocol::describe(message));
  }
  wire_.send(*connection_, std::move(bytes));
}

void ScriptLink::settingsChanged(Instant now) {
  if (!lifesign_at_ || state_ == State::Probing) return;
  lifesign_at_ = std::min(*lifesign_at_, now + settings_.supervision_period);
}

void ScriptLink::askForNode(Instant now) {
  if (unanswered_lifesigns_ == 0) requests_.dropNodeQueries();  // lost on an otherwise living link
  ++unanswered_lifesigns_;
  lifesign_at_ = now + (state_ == State::Probing ? settings_.reply_timeout : settings_.supervision_period);
  transmit(protocol::ListenNodeQuery{}, Request{}, now);
}

void ScriptLink::lifesignDue(Instant now) {
  if (unanswered_lifesigns_ == 0) {
    askForNode(now);
    return;
  }
  if (state_ == State::Probing) {
    if (foreign_bytes_) {
      diagnose(Trouble::NotTmRobot,
               fmt::format("{}:{} does not speak the protocol of a TM robot", host_, port_));
    } else if (!heard_.empty()) {
      diagnose(
          Trouble::OtherAnswers,
          fmt::format("connected to {}:{}, but the query for the Listen node gets no answer; received: {}",
                      host_, port_, heard_));
    } else {
      diagnose(
          Trouble::Silent,
          fmt::format("connected to {}:{}, but nothing answers: not a TM robot, or it hangs", host_, port_));
    }
  }
  if (unanswered_lifesigns_ < settings_.supervision_misses) {
    askForNode(now);
    return;
  }
  if (established()) {
    diagnose(Trouble::Silent,
             fmt::format("no answer to {} heartbeats: the controller or the cable has failed",
                         unanswered_lifesigns_));
  }
  fire(Event::NoAnswer, now);
}

void ScriptLink::diagnose(Trouble trouble, std::string diagnosis) {
  if (trouble_ == trouble && diagnosis_ == diagnosis) return;
  trouble_ = trouble;
  diagnosis_ = std::move(diagnosis);
  outputs_.push_back(LinkChanged{});
}

void ScriptLink::fire(Event event, Instant now) {
  const auto row = findTransition<ScriptLinkTable>(state_, event);
  if (!row) return;
  const bool changed = state_ != row->to;
  state_ = row->to;
  if (state_ != State::Ready) listen_node_.clear();
  if (established()) back_off_.reset();
  act(row->action, now);
  if (state_ == State::Ready) {
    diagnose(Trouble::None, fmt::format("in the Listen node '{}'", listen_node_));
  } else if (state_ == State::Leaving) {
    diagnose(Trouble::NotListening, "connected, the flow is leaving the Listen node after ScriptExit()");
  } else if (state_ == State::NotListening) {
    diagnose(Trouble::NotListening, "connected, but the flow is not in a Listen node: let it enter one");
  }
  if (changed) outputs_.push_back(LinkChanged{});
}

void ScriptLink::act(ScriptLinkAction action, Instant now) {
  switch (action) {
    case ScriptLinkAction::None:
      return;
    case ScriptLinkAction::Open:
      retry_at_.reset();
      connection_ = wire_.open(Channel::Script, host_, port_, settings_.open_timeout);
      return;
    case ScriptLinkAction::Probe:
      // What an earlier connection of this start taught says more than that there is a new one.
      if (isBeforeConnection(trouble_)) {
        auto [trouble, text] = asking(fmt::format("{}:{}", host_, port_), trouble_, diagnosis_);
        diagnose(trouble, std::move(text));
      }
      askForNode(now);
      return;
    case ScriptLinkAction::Lose:
      outputs_.push_back(LinkLost{diagnosis_});
      drop();
      retry_at_ = now + back_off_.next(settings_.retry_min, settings_.retry_max);
      return;
    case ScriptLinkAction::Retry:
      drop();
      retry_at_ = now + back_off_.next(settings_.retry_min, settings_.retry_max);
      return;
    case ScriptLinkAction::Release:
      drop();
      return;
  }
}

void ScriptLink::drop() {
  if (connection_) wire_.close(*connection_);
  connection_.reset();
  retry_at_.reset();
  lifesign_at_.reset();
  unanswered_lifesigns_ = 0;
  foreign_bytes_ = false;
  heard_.clear();
  heard_at_.reset();
  decoder_.reset();
  requests_.clear();
}

}  // namespace cobot_command::link
