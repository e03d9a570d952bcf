// Events: handed to the links, and what the links make of them handed to the runs.

#include "core_impl.h"
#include <fmt/format.h>

namespace cobot_command::blocks {

CommandCore::Impl::Impl(std::optional<arm::ArmModel> arm, const link::LinkSettings& settings)
    : settings_(settings),
      script_(settings_, *this),
      status_(settings_, *this),
      preflight_(std::move(arm)),
      board_(actions_),
      connect_(settings_, script_, status_, board_) {}

void CommandCore::Impl::opened(link::ConnectionId id, Instant now) {
  if (script_.owns(id)) {
    script_.opened(now);
  } else if (status_.owns(id)) {
    status_.opened(now);
  } else {
    ++late_events_;
  }
  settle(now);
}

void CommandCore::Impl::openFailed(link::ConnectionId id, const link::OpenFailure& failure, Instant now) {
  if (script_.owns(id)) {
    script_.openFailed(failure, now);
  } else if (status_.owns(id)) {
    status_.openFailed(failure, now);
  } else {
    ++late_events_;
  }
  settle(now);
}

void CommandCore::Impl::received(link::ConnectionId id, std::string_view bytes, Instant now) {
  if (script_.owns(id)) {
    script_.received(bytes);
  } else if (status_.owns(id)) {
    status_.received(bytes);
  } else {
    ++late_events_;
  }
  settle(now);
}

void CommandCore::Impl::closed(link::ConnectionId id, const std::string& reason, Instant now) {
  if (script_.owns(id)) {
    script_.closed(reason, now);
  } else if (status_.owns(id)) {
    status_.closed(reason, now);
  } else {
    ++late_events_;
  }
  settle(now);
}

void CommandCore::Impl::advance(Instant now) {
  script_.advance(now);
  status_.advance(now);
  settle(now);
  if (run_) run_->advance(now);
  connect_.advance(now);
  settle(now);
}

std::optional<Instant> CommandCore::Impl::nextDeadline() const {
  std::optional<Instant> next;
  const auto run_deadline = run_ ? run_->nextDeadline() : std::nullopt;
  for (const auto& candidate :
       {script_.nextDeadline(), status_.nextDeadline(), connect_.nextDeadline(), run_deadline}) {
    if (candidate && (!next || *candidate < *next)) next = candidate;
  }
  return next;
}

std::vector<Action> CommandCore::Impl::takeActions() {
  std::vector<Action> actions;
  actions.swap(actions_);
  return actions;
}

/// Handles everything that follows from an event, until nothing more does.
void CommandCore::Impl::settle(Instant now) {
  bool more = true;
  while (more) {
    more = false;
    while (const auto output = script_.next(now)) {
      std::visit([&](const auto& event) { handle(event, now); }, *output);
      if (run_ && run_->ended()) run_.reset();
    }
    while (const auto status = status_.next(now)) handle(*status, now);
    if (robot_.status() && !status_.streaming()) {
      robot_.forget();
      if (run_) run_->robotChanged(now);
    }
    if (run_ && run_->ended()) {
      run_.reset();
      more = true;
    }
    if (connect_.disconnecting() && !run_) {
      connect_.motionsEnded(now);
      more = true;
    }
  }
  publishStatus();
}

void CommandCore::Impl::handle(const link::LinkChanged& /*event*/, Instant now) {
  connect_.linkChanged(now);
}

void CommandCore::Impl::handle(const link::LinkLost& event, Instant now) {
  log(Severity::Warning, "link lost: " + event.reason);
  preflight_.forget();
  if (run_) run_->linkLost(event.reason, now);
  tags_.renewEpoch();
  connect_.linkLost(event.reason, now);
}

void CommandCore::Impl::handle(const link::ScriptAnswered& event, Instant now) {
  if (run_) run_->answered(event, now);
}

void CommandCore::Impl::handle(const link::TagReported& event, Instant now) {
  const bool awaited = run_ && run_->order().tag == event.tag && tags_.isOpen(event.tag);
  if (!awaited) {
    if (event.asked) return;  // asked before the command ended
    const bool stale = !tags_.complete(event.tag);
    if (stale) log(Severity::Warning, fmt::format("report of tag {}, for which nothing waits", event.tag));
    return;
  }
  if (event.state == protocol::TagState::Complete) {
    const bool open = tags_.complete(event.tag);
    if (!open) return;
    preflight_.arrive(run_->order().plan, now);
    run_->tagCompleted(now);
  } else if (event.asked) {
    run_->tagIncomplete(event.state, now);
  } else if (event.state == protocol::TagState::Incomplete) {
    run_->tagFailed(now);
  }
}

void CommandCore::Impl::handle(const link::TagQueryFailed& event, Instant now) {
  if (run_ && run_->order().tag == event.tag) run_->tagQueryFailed(event.reason, now);
}

void CommandCore::Impl::handle(const link::RobotStatus& status, Instant now) {
  robot_.update(status);
  actions_.emplace_back(RobotStatusReceived{status});
  if (run_) run_->robotChanged(now);
}

void CommandCore::Impl::log(Severity severity, std::string text) {
  actions_.emplace_back(LogMessage{severity, std::move(text)});
}

namespace {

CommandStatus::LinkState toLinkState(link::ScriptLinkState state) {
  switch (state) {
    case link::ScriptLinkState::Disconnected:
      break;
    case link::ScriptLinkState::BackingOff:
    case link::ScriptLinkState::Connecting:
      return CommandStatus::LinkState::Connecting;
    case link::ScriptLinkState::Probing:
      return CommandStatus::LinkState::Probing;
    case link::ScriptLinkState::NotListening:
    case link::ScriptLinkState::Leaving:
      return CommandStatus::LinkState::NotListening;
    case link::ScriptLinkState::Ready:
      return CommandStatus::LinkState::Ready;
  }
  return CommandStatus::LinkState::Disconnected;
}

}  // namespace

void CommandCore::Impl::publishStatus() {
  CommandStatus status;
  status.link = toLinkState(script_.state());
  status.diagnosis = script_.diagnosis();
  status.host = connect_.target().host;
  status.port = connect_.target().port;
  status.listen_node = script_.listenNode();
  status.status_stream = status_.streaming();
  status.status_diagnosis = status_.diagnosis();
  status.last_connected = connect_.lastConnected();
  status.last_lost = connect_.lastLost();
  status.queue_depth = run_ ? 1 : 0;
  status.open_tags = tags_.openTags();
  status.late_replies = script_.lateReplies() + tags_.staleReports() + late_events_;
  status.decode_faults = script_.decodeFaults() + status_.decodeFaults();
  status.blocks = board_.outputs();
  if (status == published_) return;
  published_ = status;
  actions_.emplace_back(StatusChanged{std::move(status)});
}

// --- Wire.

link::ConnectionId CommandCore::Impl::open(link::Channel channel, const std::string& host, int port,
                                           Duration timeout) {
  const link::ConnectionId id = ++last_connection_;
  actions_.emplace_back(OpenConnection{id, channel, host, port, timeout});
  return id;
}

void CommandCore::Impl::close(link::ConnectionId id) {
  actions_.emplace_back(CloseConnection{id});
}

void CommandCore::Impl::send(link::ConnectionId id, std::string bytes) {
  actions_.emplace_back(SendBytes{id, std::move(bytes)});
}

void CommandCore::Impl::trace(Instant now, link::Channel channel, bool sent, std::string_view bytes,
                              std::string meaning) {
  actions_.emplace_back(FrameTraced{now, channel, sent, std::string(bytes), std::move(meaning)});
}

}  // namespace cobot_command::blocks
