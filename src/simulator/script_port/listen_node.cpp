#include "script_port/listen_node.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>

#include "wire/communication_error.h"
#include <fmt/format.h>

namespace cobot_command::simulator {

namespace {

using Code = protocol::CommunicationErrorCode;

const tm_script::Call* callIn(const tm_script::Statement& statement) {
  const auto* expression = std::get_if<tm_script::Expression>(&statement.content);
  return expression == nullptr ? nullptr : std::get_if<tm_script::Call>(&expression->node);
}

/// The call whose result a variable begins with.
const tm_script::Call* initialCallIn(const tm_script::Statement& statement) {
  const auto* declaration = std::get_if<tm_script::Declaration>(&statement.content);
  if (declaration == nullptr || !declaration->initial) return nullptr;
  return std::get_if<tm_script::Call>(&declaration->initial->node);
}

/// The argument of the first such call that has a literal one: it does not wait for its turn (TMflow 1.82;
/// TM 1.4).
std::optional<int> priorityMode(const tm_script::Script& script, std::string_view function) {
  for (const tm_script::Statement& statement : script) {
    const tm_script::Call* call = callIn(statement);
    if (call == nullptr || call->function != function || call->arguments.size() != 1) continue;
    const auto* literal = std::get_if<tm_script::Literal>(&call->arguments.front().node);
    const auto* mode = literal == nullptr ? nullptr : std::get_if<std::uint8_t>(&literal->value);
    if (mode != nullptr) return *mode;
  }
  return std::nullopt;
}

constexpr const char* kStop = "StopAndClearBuffer";

/// Those that call it, or begin a variable with what it returns.
std::vector<int> linesWith(std::string_view function, const tm_script::Script& script) {
  std::vector<int> lines;
  for (const tm_script::Statement& statement : script) {
    for (const tm_script::Call* call : {callIn(statement), initialCallIn(statement)}) {
      if (call != nullptr && call->function == function) lines.push_back(statement.line);
    }
  }
  return lines;
}

}  // namespace

ListenNode::ListenNode(const Settings& settings, const ScriptedRobot& robot, FaultSwitches& faults,
                       Outgoing& outgoing, Outbox& outbox)
    : settings_(settings),
      queue_(robot.queue),
      faults_(faults),
      outbox_(outbox),
      clients_({settings.accept_empty_length}, faults, outgoing, outbox),
      scheduler_(settings, robot, tags_, faults, clients_, outbox) {}

void ListenNode::connected(ClientId client, Instant now) {
  if (port_open_) {
    clients_.connect(client);
    if (!heard_at_) heard_at_ = now;
  } else {
    outbox_.closeClient(Port::Script, client);
  }
}

// --- The project ---------------------------------------------------------------------------------------

void ListenNode::on(FlowEvent event, Instant now) {
  const auto row = findTransition<FlowTable>(flow_, event);
  if (!row) return;
  flow_ = row->to;
  switch (row->action) {
    case FlowAction::Open:
      tags_ = TagTable();
      updatePort();
      return enter(now);
    case FlowAction::Leave:
      return leave(now);
    case FlowAction::ComeOut:
      outbox_.log("Listen node left");
      if (reentry_delay_) reenter_at_ = now + std::max(*reentry_delay_, Duration::zero());
      return;
    case FlowAction::Enter:
      return enter(now);
    case FlowAction::Close:
      reenter_at_.reset();
      scheduler_.clear();
      updatePort();
      return outbox_.log("project stopped");
  }
}

void ListenNode::updatePort() {
  const bool wanted = projectRuns() && !faults_.refuse_connections.on;
  if (std::exchange(port_open_, wanted) == wanted) return;
  if (wanted) return outbox_.openPort(Port::Script);
  clients_.closeAll();
  outbox_.closePort(Port::Script);
}

void ListenNode::enter(Instant now) {
  entered_at_ = now;
  heard_at_ = clients_.empty() ? std::nullopt : std::optional(now);
  reenter_at_.reset();
  reentry_delay_ = settings_.reentry_delay;
  scheduler_.forgetVariables();
  outbox_.log(fmt::format("Listen node entered: {}", settings_.listen_node_message));
  clients_.broadcast(protocol::ListenNodeEntered{settings_.listen_node_message});
}

// What still waits can no longer run.
void ListenNode::leave(Instant now) {
  queue_.leaveModes(now);
  for (const PendingScript& script : scheduler_.takePending()) {
    refuseFrame(script.client, Code::NotListening);
  }
}

void ListenNode::leaveForGood(Instant now) {
  reentry_delay_.reset();
  reenter_at_.reset();
  if (!listening()) return;
  scheduler_.endCurrent();
  on(FlowEvent::Exit, now);
}

void ListenNode::comeBack(Instant now) {
  if (listening()) return;
  reentry_delay_ = Duration::zero();
  if (flow_ == FlowState::Elsewhere) reenter_at_ = now;
}

Instant ListenNode::timeout() const {
  if (!listening()) return Instant::max();
  const Duration limit = heard_at_ ? settings_.data_timeout : settings_.connection_timeout;
  return limit > Duration::zero() ? heard_at_.value_or(entered_at_) + limit : Instant::max();
}

bool ListenNode::step(Instant now) {
  if (timeout() <= now) {
    outbox_.log(fmt::format("{} timeout of the Listen node", heard_at_ ? "data" : "connection"));
    scheduler_.endCurrent();
    on(FlowEvent::Exit, now);
    return true;
  }
  if (flow_ == FlowState::Listening) {
    const auto step = scheduler_.run(now);
    if (step == ScriptScheduler::Step::Exited) on(FlowEvent::Exit, now);
    return step != ScriptScheduler::Step::Waits;
  }
  if (flow_ == FlowState::Leaving && queue_.idle()) {
    on(FlowEvent::Done, now);
    return true;
  }
  if (flow_ == FlowState::Elsewhere && reenter_at_ && *reenter_at_ <= now) {
    on(FlowEvent::Reenter, now);
    return true;
  }
  return false;
}

Instant ListenNode::nextEvent() const {
  return std::min({scheduler_.nextEvent(), reenter_at_.value_or(Instant::max()), timeout()});
}

void ListenNode::on(const TagSettled& settled) {
  using protocol::TagState;
  const bool complete = settled.complete && !faults_.false_tag.take();
  tags_.settle(settled.tag, complete ? TagTable::Fate::Complete : TagTable::Fate::Failed);
  if (settled.tag.reported) return;
  const TagState state = complete ? TagState::Complete : TagState::Incomplete;
  clients_.broadcast(protocol::TagReport{settled.tag.tag, state});
}

void ListenNode::abandonScripts() {
  scheduler_.endCurrent();
  const auto dropped = scheduler_.takePending().size();
  if (dropped > 0) outbox_.log(fmt::format("{} buffered scripts dropped", dropped));
}

// --- The wire ------------------------------------------------------------------------------------------

bool ListenNode::handleNext(ClientId client, Instant now) {
  const std::optional<protocol::DecodeEvent> event = clients_.next(client);
  if (!event) return false;
  heard_at_ = now;
  if (const auto* fault = std::get_if<protocol::DecodeFault>(&*event)) {
    handle(client, *fault);
  } else {
    handle(client, std::get<protocol::Frame>(*event), now);
  }
  return true;
}

void ListenNode::handle(ClientId client, const protocol::DecodeFault& fault) {
  outbox_.log(fmt::format("from {}: {}: {}", client, protocol::toString(fault.kind), fault.message));
  if (const auto code = codeFor(fault.kind)) refuseFrame(client, *code);
}

void ListenNode::handle(ClientId client, const protocol::Frame& frame, Instant now) {
  const auto message = protocol::parseClientMessage(frame);
  if (message) {
    outbox_.log(fmt::format("from {}: {}", client, protocol::describe(*message)));
    return std::visit([&](const auto& what) { answer(client, what, now); }, *message);
  }
  const protocol::MessageFault& fault = message.error();
  outbox_.log(fmt::format("from {}: {}", client, fault.message));
  const bool unknown = fault.kind == protocol::MessageFault::Kind::UnknownHeader;
  refuseFrame(client, unknown ? Code::Header : Code::Data);
}

void ListenNode::refuseFrame(ClientId client, Code code) {
  clients_.reply(client, protocol::CommunicationError{code});
}

void ListenNode::answer(ClientId client, const protocol::ListenNodeQuery&, Instant) {
  protocol::ListenNodeState state;
  state.listening = listening();
  if (state.listening) state.message = settings_.listen_node_message;
  clients_.reply(client, state);
}

void ListenNode::answer(ClientId client, const protocol::TagQuery& query, Instant) {
  protocol::TagState state = tags_.query(query.tag);
  if (faults_.query_none.take()) state = protocol::TagState::Unknown;
  if (faults_.query_false.take()) state = protocol::TagState::Incomplete;
  clients_.reply(client, protocol::TagReport{query.tag, state});
}

void ListenNode::answer(ClientId client, const protocol::ScriptRequest& request, Instant now) {
  if (!listening()) return refuseFrame(client, Code::NotListening);
  if (faults_.ignore_script.take()) return outbox_.log("fault: the script is ignored");
  const std::string code = faults_.cperr_script.text;
  if (faults_.cperr_script.take()) {
    return refuseFrame(client, static_cast<Code>(std::stoi(code, nullptr, 16)));
  }
  PendingScript script{client, request.id, tm_script::parse(request.script), {}};
  spoil(script);
  if (!runPriorityCommand(script, now)) scheduler_.add(std::move(script));
}

/// A fault refuses what is right: the script becomes one with faulty lines.
void ListenNode::spoil(PendingScript& script) {
  const auto refuse = [&](std::string_view function, FaultSwitch& fault) {
    const std::vector<int> lines = linesWith(function, script.script.statements);
    if (!lines.empty() && fault.take()) script.spoiled = lines;
  };
  refuse(kStop, faults_.refuse_stop);
  refuse("ListenSend", faults_.refuse_listen_send);
  const std::string chosen = faults_.refuse_script.text;
  if (!faults_.refuse_script.take()) return;
  script.spoiled.clear();
  std::istringstream numbers(chosen);
  for (std::string number; std::getline(numbers, number, ';');) script.spoiled.push_back(std::stoi(number));
}

// --- Priority commands ---------------------------------------------------------------------------------

bool ListenNode::runPriorityCommand(const PendingScript& script, Instant now) {
  const auto exit_mode = priorityMode(script.script.statements, "ScriptExit");
  const auto stop_mode = priorityMode(script.script.statements, kStop);
  if (!exit_mode && !stop_mode) return false;
  if (!script.spoiled.empty() || !scheduler_.check(script.script).errors.empty()) return false;
  if (exit_mode) {
    exit(now);
  } else {
    stopAndClear(*stop_mode, now);
  }
  clients_.reply(script.client, protocol::ScriptReply{script.id, true, {}});
  return true;
}

void ListenNode::exit(Instant now) {
  queue_.stop(now);
  abandonScripts();
  on(FlowEvent::Exit, now);
}

void ListenNode::stopAndClear(int mode, Instant now) {
  if (faults_.ignore_stop.take()) return;
  queue_.stop(now);
  switch (mode) {
    case 0:
      return scheduler_.releaseWait();
    case 1:
      return scheduler_.endCurrent();
    default:
      return abandonScripts();
  }
}

}  // namespace cobot_command::simulator
