#include "script_port/script_scheduler.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "robot/tmflow_version.h"
#include "script_port/controller_functions.h"
#include <fmt/format.h>

#include "cobot_command/script/robot_functions.h"

namespace cobot_command::simulator {

namespace {

/// As one number for each line.
std::vector<int> linesOf(const std::vector<tm_script::Fault>& faults) {
  std::vector<int> lines;
  for (const tm_script::Fault& fault : faults) {
    if (lines.empty() || lines.back() != fault.line) lines.push_back(fault.line);
  }
  return lines;
}

const tm_script::Attribute* attributeIn(const tm_script::Expression& target) {
  const auto* element = std::get_if<tm_script::Element>(&target.node);
  return std::get_if<tm_script::Attribute>(element == nullptr ? &target.node : &element->array->node);
}

/// What a call or an output takes of the room in the queue of motions; nothing: it does not go there. Calls
/// within others are seen when they are made.
std::size_t* roomFor(const tm_script::Statement& statement, ScriptCommands::Room& room) {
  const auto* expression = std::get_if<tm_script::Expression>(&statement.content);
  if (expression == nullptr) return nullptr;
  if (const auto* call = std::get_if<tm_script::Call>(&expression->node)) {
    if (call->function == "PVTPoint") return &room.points;
    return script::isQueued(call->function) ? &room.entries : nullptr;
  }
  const auto* assignment = std::get_if<tm_script::Assignment>(&expression->node);
  const auto* attribute = assignment == nullptr ? nullptr : attributeIn(assignment->targets.front());
  const bool is_queued = attribute != nullptr && attribute->object == "IO" &&
                         (attribute->name == "DO" || attribute->name == "AO");
  return is_queued ? &room.entries : nullptr;
}

}  // namespace

ScriptScheduler::ScriptScheduler(const Settings& settings, const ScriptedRobot& robot, TagTable& tags,
                                 FaultSwitches& faults, ScriptClients& clients, Outbox& outbox)
    : project_(robot.project),
      tags_(tags),
      clients_(clients),
      outbox_(outbox),
      functions_(tmflowVersion(settings.tmflow_version)),
      environment_(robot, settings, tags, faults, clients) {
  script::declareRobotFunctions(functions_);
  defineControllerFunctions(functions_, robot.state);
}

void ScriptScheduler::add(PendingScript script) {
  if (pending_.size() < kMostWaiting) return pending_.push_back(std::move(script));
  clients_.reply(script.client, protocol::ScriptReply{script.id, false, {1}});
}

tm_script::Findings ScriptScheduler::check(const tm_script::ParsedScript& script) {
  return tm_script::check(script, functions_, scope(), environment_);
}

tm_script::Findings ScriptScheduler::findingsOf(const PendingScript& script) {
  tm_script::Findings findings = check(script.script);
  if (!script.spoiled.empty()) {
    findings.errors.clear();
    for (const int line : script.spoiled) findings.errors.push_back({line, "fault"});
  }
  if (!findings.errors.empty()) return findings;
  ScriptCommands::Room room = environment_.commands().room();
  for (const tm_script::Statement& statement : script.script.statements) {
    std::size_t* left = roomFor(statement, room);
    if (left == nullptr) continue;
    if (*left == 0) {
      findings.errors.push_back({statement.line, "the queue of motions is full"});
    } else {
      --*left;
    }
  }
  return findings;
}

// Checks the next script as a whole; one with an error is answered and nothing of it is executed.
bool ScriptScheduler::begin() {
  PendingScript script = std::move(pending_.front());
  pending_.pop_front();
  const tm_script::Findings findings = findingsOf(script);
  for (const auto* faults : {&findings.errors, &findings.warnings}) {
    for (const tm_script::Fault& fault : *faults) {
      outbox_.log(fmt::format("script {}, line {}: {}", script.id, fault.line, fault.reason));
    }
  }
  if (!findings.errors.empty()) {
    clients_.reply(script.client, protocol::ScriptReply{script.id, false, linesOf(findings.errors)});
    return false;
  }
  running_.emplace(Running{
      script.client, std::move(script.id), linesOf(findings.warnings),
      tm_script::Interpreter(std::move(script.script.statements), functions_, scope(), environment_)});
  return true;
}

bool ScriptScheduler::waits(Instant now) const {
  return wait_ && !wait_->is_released && now < wait_->until && (!wait_->tag || tags_.isOpen(*wait_->tag));
}

void ScriptScheduler::resumeWaiting() {
  if (!wait_) return;
  const bool complete = wait_->tag && tags_.query(wait_->tag->tag) == protocol::TagState::Complete;
  tm_script::Scalar answer(true);
  if (wait_->is_question) answer = complete ? 1 : 0;
  running_->script.resume(answer);
  wait_.reset();
}

ScriptScheduler::Step ScriptScheduler::run(Instant now) {
  environment_.commands().setTime(now);
  if (!running_) {
    if (pending_.empty()) return Step::Waits;
    if (!begin()) return Step::Ran;
  }
  tm_script::Progress progress = tm_script::Progress::Waiting;
  while (progress == tm_script::Progress::Waiting) {
    if (waits(now)) return Step::Waits;
    resumeWaiting();
    progress = running_->script.run(std::numeric_limits<int>::max());
    wait_ = environment_.commands().takeWait();
  }
  if (progress == tm_script::Progress::Failed) {
    const tm_script::Fault fault = *running_->script.fault();
    outbox_.log(fmt::format("script {} failed in line {}: {}", running_->id, fault.line, fault.reason));
    end(false, {fault.line});
  }
  endCurrent();
  return environment_.commands().takeExit() ? Step::Exited : Step::Ran;
}

Instant ScriptScheduler::nextEvent() const {
  return wait_ ? wait_->until : Instant::max();
}

void ScriptScheduler::releaseWait() {
  if (wait_ && wait_->tag) wait_->is_released = true;
}

void ScriptScheduler::endCurrent() {
  if (running_) end(true, running_->warnings);
}

void ScriptScheduler::end(bool accepted, std::vector<int> lines) {
  wait_.reset();
  clients_.reply(running_->client, protocol::ScriptReply{running_->id, accepted, std::move(lines)});
  running_.reset();
}

std::deque<PendingScript> ScriptScheduler::takePending() {
  return std::exchange(pending_, {});
}

void ScriptScheduler::clear() {
  pending_.clear();
  running_.reset();
  wait_.reset();
}

}  // namespace cobot_command::simulator
