#include "cobot_command/trial/trial_robot.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "cobot_command/cell/artifact/start_setting.h"
#include "cobot_command/common/overloaded.h"

namespace cobot_command::trial {
namespace {

simulator::Settings settingsOf(const cell::Artifact& artifact, cell::RobotIndex robot,
                               const std::vector<std::string>& not_streamed) {
  simulator::Settings settings;
  settings.start_posture = artifact.robots[robot].stations[artifact.program.robots[robot].home].joints;
  settings.start_tcp = cell::startTcp(artifact, robot);
  settings.project_speed_percent = cell::highestProjectSpeed(artifact);
  auto& items = settings.stream_items;
  items.erase(std::remove_if(items.begin(), items.end(),
                             [&](const std::string& item) {
                               return std::count(not_streamed.begin(), not_streamed.end(), item) > 0;
                             }),
              items.end());
  return settings;
}

cell::RobotBodies bodiesOf(const cell::Artifact& artifact, cell::RobotIndex robot) {
  const cell::ArtifactRobot& made = artifact.robots[robot];
  return cell::RobotBodies::fromUrdf(arm::ArmModel::urdfOf(made.model), made.base, {},
                                     artifact.parameters.body_cell)
      ->carrying(made.tool);
}

}  // namespace

TrialRobot::TrialRobot(std::shared_ptr<const cell::Artifact> artifact, cell::RobotIndex robot,
                       std::uint64_t session, Instant now, const std::vector<std::string>& not_streamed)
    : artifact_(std::move(artifact)),
      index_(robot),
      name_(artifact_->program.robots[robot].name),
      now_(now),
      controller_(arm::ArmModel::named(artifact_->robots[robot].model).value(),
                  settingsOf(*artifact_, robot, not_streamed), now),
      bodies_(bodiesOf(*artifact_, robot)) {
  makeCore(session);
  settle();
}

void TrialRobot::makeCore(std::uint64_t session) {
  agent_ = *cell::Agent::of(artifact_, name_, session);
  command::CorePorts ports;
  ports.gate = [this, agent = agent_](command::Departure departure, Instant now) {
    if (tamper) tamper(departure);
    return agent->objectionTo(departure, now);
  };
  ports.program = agent_;
  ports.traced = [](link::Channel channel) { return channel == link::Channel::Script; };
  core_ = std::make_unique<command::CommandCore>(
      arm::ArmModel::named(artifact_->robots[index_].model).value(), link::LinkSettings(), std::move(ports));
}

void TrialRobot::connect() {
  blocks::ConnectGoal goal;
  goal.host = "robot";
  core_->keepConnected(goal, now_);
  settle();
}

bool TrialRobot::isReady() const {
  return status_.link == command::CommandStatus::LinkState::Ready && has_seen_;
}

blocks::GoalId TrialRobot::submit(const blocks::Goal& goal) {
  core_->submit(++goals_, goal, now_);
  settle();
  return goals_;
}

void TrialRobot::cancel(blocks::GoalId goal) {
  core_->cancel(goal, now_);
  settle();
}

void TrialRobot::finish() {
  static_cast<void>(core_->finish(blocks::FinishAfter::Cycle, now_));
  settle();
}

void TrialRobot::operate(const simulator::OperatorAction& action) {
  static_cast<void>(controller_.operate(action, now_));
  settle();
}

void TrialRobot::dropConnections() {
  while (!wires_.empty()) {
    const auto [id, wire] = *wires_.begin();
    controller_.clientDisconnected(wire.port, wire.client, now_);
    forget(id, "connection reset by peer");
    settle();
  }
}

void TrialRobot::restart(std::uint64_t session) {
  for (const auto& [id, wire] : wires_) controller_.clientDisconnected(wire.port, wire.client, now_);
  wires_.clear();
  status_ = {};
  has_seen_ = false;
  makeCore(session);
  connect();
}

void TrialRobot::receiveOfOther(const std::string& bytes) {
  if (!other_) {
    other_ = ++clients_;
    controller_.clientConnected(simulator::Port::Script, *other_, now_);
  }
  controller_.received(simulator::Port::Script, *other_, bytes, now_);
  settle();
}

void TrialRobot::hear(const cell::CellStatus& state, std::uint64_t number) {
  agent_->hear(state, number, now_);
  core_->advance(now_);
  settle();
}

Instant TrialRobot::nextEvent() const {
  const Instant core = core_->nextDeadline().value_or(Instant::max());
  return std::min({controller_.nextEvent(), core, agent_->nextReport()});
}

void TrialRobot::advanceTo(Instant instant) {
  now_ = std::max(now_, instant);
  if (nextEvent() > now_) return;
  controller_.advance(now_);
  takeOutputs();
  agent_->advance(now_);
  core_->advance(now_);
  settle();
}

simulator::RobotState TrialRobot::state() {
  controller_.advance(now_);  // which else only its own events do
  return controller_.state();
}

cell::Capsules TrialRobot::bodies() {
  return bodies_.at(state().joints).capsules;
}

const blocks::Outcome* TrialRobot::outcome(blocks::GoalId goal) const {
  const auto found = ended_.find(goal);
  return found == ended_.end() ? nullptr : &found->second;
}

void TrialRobot::settle() {
  while (takeActions() || takeOutputs()) {
  }
}

bool TrialRobot::takeActions() {
  const auto actions = core_->takeActions();
  for (const command::Action& action : actions) {
    std::visit(
        Overloaded{
            [this](const command::OpenConnection& known) { open(known); },
            [this](const command::CloseConnection& known) { close(known); },
            [this](const command::SendBytes& known) { send(known); },
            [this](const command::GoalProgressed& known) { progress_[known.goal].push_back(known.progress); },
            [this](const command::GoalEnded& known) { ended_[known.goal] = known.outcome; },
            [this](const command::StatusChanged& known) {
              status_ = known.status;
              agent_->linked(command::whyNotReady(status_), now_);
            },
            [this](const command::RobotStatusReceived& known) { observe(known.status); },
            [this](const command::FrameTraced& known) { note(known); }, [](const auto& /*others*/) {}},
        action);
  }
  return !actions.empty();
}

bool TrialRobot::takeOutputs() {
  const auto outputs = controller_.takeOutputs();
  for (const simulator::Output& output : outputs) {
    std::visit(Overloaded{[this](const simulator::Send& known) {
                            const link::ConnectionId id = connectionOf(known.client);
                            if (wires_.count(id) != 0) core_->received(id, known.bytes, now_);
                          },
                          [this](const simulator::CloseClient& known) {
                            const link::ConnectionId id = connectionOf(known.client);
                            if (wires_.count(id) != 0) forget(id, "connection closed by peer");
                          },
                          [this](const simulator::OpenPort& known) { open_[known.port] = true; },
                          [this](const simulator::ClosePort& known) { open_[known.port] = false; },
                          [](const simulator::LogLine& /*known*/) {}},
               output);
  }
  return !outputs.empty();
}

void TrialRobot::open(const command::OpenConnection& action) {
  const auto port =
      action.channel == link::Channel::Script ? simulator::Port::Script : simulator::Port::Status;
  if (!open_[port]) {
    core_->openFailed(action.id, {link::OpenFailure::Kind::Refused, "connection refused"}, now_);
    return;
  }
  wires_[action.id] = {port, ++clients_};
  core_->opened(action.id, now_);
  controller_.clientConnected(port, clients_, now_);
}

void TrialRobot::close(const command::CloseConnection& action) {
  const auto found = wires_.find(action.id);
  if (found == wires_.end()) return;
  const Wire wire = found->second;
  wires_.erase(found);
  controller_.clientDisconnected(wire.port, wire.client, now_);
}

void TrialRobot::send(const command::SendBytes& action) {
  const auto found = wires_.find(action.id);
  if (found == wires_.end()) return;
  controller_.received(found->second.port, found->second.client, action.bytes, now_);
}

void TrialRobot::observe(const link::RobotStatus& status) {
  has_seen_ = true;
  agent_->observe(status, now_);
  core_->advance(now_);
}

void TrialRobot::note(const command::FrameTraced& action) {
  if (action.sent && action.bytes.rfind("$TMSCT,", 0) == 0) scripts_.push_back(action.bytes);
}

link::ConnectionId TrialRobot::connectionOf(simulator::ClientId client) const {
  const auto found = std::find_if(wires_.begin(), wires_.end(),
                                  [client](const auto& wire) { return wire.second.client == client; });
  return found == wires_.end() ? link::ConnectionId{} : found->first;
}

void TrialRobot::forget(link::ConnectionId id, const std::string& reason) {
  wires_.erase(id);
  core_->closed(id, reason, now_);
}

}  // namespace cobot_command::trial
