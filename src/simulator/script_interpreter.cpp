#include "script_interpreter.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/overloaded.h"

namespace cobot_command::simulator {

namespace {

std::optional<arm::Pose> named(const std::map<std::string, arm::Pose>& poses, const std::string& fixed,
                               const std::string& name) {
  if (name == fixed) return arm::Pose::Identity();
  const auto found = poses.find(name);
  return found == poses.end() ? std::nullopt : std::optional(found->second);
}

/// Goes into the queue of motions.
bool isQueued(const protocol::ScriptCommand& command) {
  return std::visit(
      Overloaded{[](const protocol::WriteOutput& write) { return !write.instant; },
                 [](const protocol::WaitQueueTag&) { return false; },
                 [](const protocol::StopAndClearBuffer&) { return false; },
                 [](const protocol::Pause&) { return false; }, [](const protocol::Resume&) { return false; },
                 [](const protocol::ScriptExit&) { return false; }, [](const auto&) { return true; }},
      command);
}

}  // namespace

std::optional<arm::Pose> ScriptInterpreter::baseNamed(const std::string& name) const {
  return named(settings_.bases, "RobotBase", name);
}

std::optional<arm::Pose> ScriptInterpreter::tcpNamed(const std::string& name) const {
  return named(settings_.tcps, "NOTOOL", name);
}

bool ScriptInterpreter::isExecutable(const protocol::ScriptCommand& command) const {
  if (const auto* change = std::get_if<protocol::ChangeBase>(&command)) {
    const auto* name = std::get_if<std::string>(&change->base);
    return name == nullptr || baseNamed(*name).has_value();
  }
  if (const auto* change = std::get_if<protocol::ChangeTcp>(&command)) {
    const auto* name = std::get_if<std::string>(&change->tcp);
    return name == nullptr || tcpNamed(*name).has_value();
  }
  return true;
}

void ScriptInterpreter::add(PendingScript script) {
  if (pending_.size() < kMostWaiting) return pending_.push_back(std::move(script));
  clients_.reply(script.client, protocol::ScriptReply{script.id, false, {1}});
}

std::vector<int> ScriptInterpreter::faultyLines(const PendingScript& script) const {
  std::vector<int> lines;
  if (!script.parsed) {
    for (const protocol::ScriptFault& fault : script.parsed.error()) lines.push_back(fault.line);
    return lines;
  }
  std::size_t queued = queue_.size();
  for (const auto& line : script.parsed->lines) {
    if (!isExecutable(line.command) || (isQueued(line.command) && ++queued > kMostWaiting)) {
      lines.push_back(line.number);
    }
  }
  return lines;
}

// Checks the next script as a whole; one with an error is answered and nothing of it is executed.
bool ScriptInterpreter::begin() {
  PendingScript script = std::move(pending_.front());
  pending_.pop_front();
  std::vector<int> errors = faultyLines(script);
  if (!errors.empty()) {
    clients_.reply(script.client, protocol::ScriptReply{script.id, false, std::move(errors)});
    return false;
  }
  running_ = Running{script.client, std::move(script.id), std::move(script.parsed->lines), 0};
  return true;
}

bool ScriptInterpreter::waits(Instant now) const {
  return wait_ && now < wait_->until && tags_.isOpen(wait_->tag);
}

ScriptInterpreter::Step ScriptInterpreter::run(Instant now) {
  if (!running_) {
    if (pending_.empty()) return Step::Waits;
    if (!begin()) return Step::Ran;
  }
  for (;;) {
    if (waits(now)) return Step::Waits;
    wait_.reset();
    if (exited_ || running_->next == running_->lines.size()) break;
    const protocol::ScriptCommand& command = running_->lines[running_->next++].command;
    std::visit([&](const auto& what) { execute(what, now); }, command);
  }
  endCurrent();
  return std::exchange(exited_, false) ? Step::Exited : Step::Ran;
}

Instant ScriptInterpreter::nextEvent() const {
  return wait_ ? wait_->until : Instant::max();
}

void ScriptInterpreter::releaseWait() {
  wait_.reset();
}

void ScriptInterpreter::endCurrent() {
  wait_.reset();
  if (!running_) return;
  clients_.reply(running_->client, protocol::ScriptReply{running_->id, true, {}});
  running_.reset();
}

std::deque<PendingScript> ScriptInterpreter::takePending() {
  return std::exchange(pending_, {});
}

void ScriptInterpreter::clear() {
  pending_.clear();
  running_.reset();
  wait_.reset();
}

void ScriptInterpreter::execute(const protocol::ChangeBase& change, Instant) {
  if (const auto* name = std::get_if<std::string>(&change.base)) {
    queue_.push(BaseChange{*baseNamed(*name), *name});
  } else {
    queue_.push(BaseChange{arm::toPose(std::get<protocol::SixNumbers>(change.base)), ""});
  }
}

void ScriptInterpreter::execute(const protocol::ChangeTcp& change, Instant) {
  if (const auto* name = std::get_if<std::string>(&change.tcp)) {
    queue_.push(TcpChange{*tcpNamed(*name), *name, 0.0});
  } else {
    queue_.push(TcpChange{arm::toPose(std::get<protocol::SixNumbers>(change.tcp)), "", change.weight});
  }
}

void ScriptInterpreter::execute(const protocol::ChangeLoad& change, Instant) {
  queue_.push(LoadChange{change.weight});
}

void ScriptInterpreter::execute(const protocol::QueueTag& tag, Instant) {
  QueuedTag queued = tags_.add(tag.tag);
  queued.reported = faults_.early_tag.take();
  if (queued.reported) clients_.broadcast(protocol::TagReport{tag.tag, protocol::TagState::Complete});
  queue_.push(queued);
  if (tag.wait) wait_ = Wait{queued, Instant::max()};
}

void ScriptInterpreter::execute(const protocol::WaitQueueTag& wait, Instant now) {
  const std::optional<QueuedTag> tag = tags_.latest(wait.tag);
  if (!tag) return;  // the function answers -1 at once
  const int timeout = wait.timeout.value_or(0);
  wait_ = Wait{*tag, timeout > 0 ? now + std::chrono::milliseconds(timeout) : Instant::max()};
}

void ScriptInterpreter::execute(const protocol::StopAndClearBuffer&, Instant now) {
  if (!faults_.ignore_stop.take()) queue_.stop(now);
}

void ScriptInterpreter::execute(const protocol::Pause&, Instant now) {
  queue_.pause(now);
}

void ScriptInterpreter::execute(const protocol::Resume&, Instant now) {
  queue_.resume(now);
}

void ScriptInterpreter::execute(const protocol::ScriptExit&, Instant) {
  exited_ = true;
}

void ScriptInterpreter::execute(const protocol::WriteOutput& write, Instant) {
  if (write.instant) return io_.write(write);
  queue_.push(write);
}

}  // namespace cobot_command::simulator
