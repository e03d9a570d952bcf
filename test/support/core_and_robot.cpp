#include "core_and_robot.h"

#include <algorithm>
#include <utility>
#include <variant>

#include <gtest/gtest.h>

#include "cobot_command/protocol/frame_decoder.h"

namespace cobot_command::testing {

namespace {

command::CorePorts portsWith(const std::shared_ptr<command::Gate>& gate) {
  command::CorePorts ports;
  ports.gate = [gate](const command::Departure& departure, Instant now) {
    return *gate ? (*gate)(departure, now) : std::nullopt;
  };
  return ports;
}

}  // namespace

CoreAndRobot::CoreAndRobot(const std::string& model, simulator::Settings settings, link::LinkSettings link,
                           Duration planning)
    : core_(arm::ArmModel::named(model).value(), link, portsWith(gate_),
            planning > Duration::zero() ? command::Planning::Beside : command::Planning::AtOnce),
      controller_(arm::ArmModel::named(model).value(), std::move(settings), now_),
      planning_(planning) {
  settle();
}

blocks::GoalId CoreAndRobot::connect() {
  blocks::ConnectGoal goal;
  goal.host = "robot";
  const blocks::GoalId id = submit(goal);
  EXPECT_TRUE(passUntil([&] { return status_.link == command::CommandStatus::LinkState::Ready; }));
  pass(std::chrono::milliseconds(200));  // the stream has told where the robot stands
  scripts_.clear();
  return id;
}

blocks::GoalId CoreAndRobot::submit(const blocks::Goal& goal) {
  core_.submit(++goals_, goal, now_);
  settle();
  return goals_;
}

void CoreAndRobot::cancel(blocks::GoalId goal) {
  core_.cancel(goal, now_);
  settle();
}

command::TableAnswer CoreAndRobot::write(const command::TableWrite& entry) {
  auto answer = core_.writeTable(entry);
  core_.advance(now_);
  settle();
  return answer;
}

command::ExchangeAnswer CoreAndRobot::update(const blocks::ExchangeSettings& settings) {
  auto answer = core_.updateExchange(settings, now_);
  settle();
  return answer;
}

std::optional<std::string> CoreAndRobot::switchTracking(const command::TrackingSwitch& request) {
  auto refusal = core_.switchTracking(request, now_);
  settle();
  return refusal;
}

std::optional<command::FeedrateAnswer> CoreAndRobot::setFeedrate(std::optional<double> percent,
                                                                 bool restart) {
  answer_ = std::make_shared<std::optional<command::FeedrateAnswer>>();
  core_.setFeedrate(
      {percent, restart}, [answer = answer_](const command::FeedrateAnswer& given) { *answer = given; },
      now_);
  settle();
  return *answer_;
}

std::optional<command::OverrideAnswer> CoreAndRobot::setSpeedOverride(double percent) {
  override_ = std::make_shared<std::optional<command::OverrideAnswer>>();
  core_.setSpeedOverride(
      percent, [answer = override_](const command::OverrideAnswer& given) { *answer = given; }, now_);
  settle();
  return *override_;
}

command::FinishReport CoreAndRobot::finish() {
  command::FinishReport report = core_.finish(blocks::FinishAfter::Move, now_);
  settle();
  return report;
}

void CoreAndRobot::shutDown() {
  core_.shutDown(now_);
  settle();
}

void CoreAndRobot::operate(const simulator::OperatorAction& action) {
  static_cast<void>(controller_.operate(action, now_));
  settle();
}

void CoreAndRobot::dropConnections() {
  while (!wires_.empty()) {
    const auto [id, wire] = *wires_.begin();
    controller_.clientDisconnected(wire.port, wire.client, now_);
    forget(id, "connection reset by peer");
    settle();
  }
}

CoreAndRobot::InterruptPromise CoreAndRobot::interrupt() {
  auto promise = std::make_shared<std::optional<command::InterruptAnswer>>();
  core_.interrupt([promise](const auto& answer) { *promise = answer; }, now_);
  settle();
  return promise;
}

command::InterruptAnswer CoreAndRobot::goOn() {
  std::optional<command::InterruptAnswer> given;
  core_.goOn([&given](const auto& answer) { given = answer; }, now_);
  settle();
  return given.value_or(command::InterruptAnswer());
}

void CoreAndRobot::keepJogging() {
  core_.keepJogging(now_);
  settle();
}

void CoreAndRobot::pass(Duration duration) {
  const Instant until = now_ + duration;
  while (nextEvent() <= until) advanceTo(nextEvent());
  advanceTo(until);
}

void CoreAndRobot::passRobotAlone(Duration duration) {
  now_ += duration;
  controller_.advance(now_);
  static_cast<void>(controller_.takeOutputs());
}

bool CoreAndRobot::passUntil(const std::function<bool()>& done, Duration most) {
  const Instant until = now_ + most;
  while (!done()) {
    if (nextEvent() > until) return false;
    advanceTo(nextEvent());
  }
  return true;
}

const blocks::Outcome& CoreAndRobot::endOf(blocks::GoalId goal) {
  EXPECT_TRUE(passUntil([&] { return outcome(goal) != nullptr; })) << "goal " << goal << " has no end";
  return ended_[goal];
}

const blocks::Outcome* CoreAndRobot::outcome(blocks::GoalId goal) const {
  const auto found = ended_.find(goal);
  return found == ended_.end() ? nullptr : &found->second;
}

void CoreAndRobot::settle() {
  while (takeActions() || takeOutputs()) {
  }
}

bool CoreAndRobot::takeActions() {
  const auto actions = core_.takeActions();
  for (const command::Action& action : actions) {
    std::visit([this](const auto& known) { take(known); }, action);
  }
  return !actions.empty();
}

bool CoreAndRobot::takeOutputs() {
  const auto outputs = controller_.takeOutputs();
  for (const simulator::Output& output : outputs) {
    std::visit([this](const auto& known) { take(known); }, output);
  }
  return !outputs.empty();
}

Instant CoreAndRobot::nextEvent() const {
  const Instant next = std::min(controller_.nextEvent(), core_.nextDeadline().value_or(Instant::max()));
  return plans_.empty() ? next : std::min(next, plans_.front().due);
}

void CoreAndRobot::advanceTo(Instant instant) {
  now_ = std::max(now_, instant);
  controller_.advance(now_);
  takeOutputs();
  core_.advance(now_);
  settle();
  answerPlans();
}

/// In the order in which they were asked for; those of both lanes take their time beside each other.
void CoreAndRobot::answerPlans() {
  while (!plans_.empty() && plans_.front().due <= now_) {
    const Plan plan = std::move(plans_.front());
    plans_.pop_front();
    core_.planned(plan.asked.id, plan.asked.work(), now_);
    settle();
  }
}

void CoreAndRobot::take(const command::OpenConnection& action) {
  const auto port =
      action.channel == link::Channel::Script ? simulator::Port::Script : simulator::Port::Status;
  if (!open_[port]) {
    core_.openFailed(action.id, {link::OpenFailure::Kind::Refused, "connection refused"}, now_);
    return;
  }
  wires_[action.id] = {port, ++clients_};
  core_.opened(action.id, now_);
  controller_.clientConnected(port, clients_, now_);
}

void CoreAndRobot::take(const command::CloseConnection& action) {
  const auto found = wires_.find(action.id);
  if (found == wires_.end()) return;
  const Wire wire = found->second;
  wires_.erase(found);
  controller_.clientDisconnected(wire.port, wire.client, now_);
}

void CoreAndRobot::take(const command::SendBytes& action) {
  const auto found = wires_.find(action.id);
  if (found != wires_.end()) {
    controller_.received(found->second.port, found->second.client, action.bytes, now_);
  }
}

void CoreAndRobot::take(const command::GoalEnded& action) {
  EXPECT_EQ(ended_.count(action.goal), 0U) << "goal " << action.goal << " has two ends";
  ended_[action.goal] = action.outcome;
}

/// "$TMSCT,length,id,script,*CS"
void CoreAndRobot::take(const command::FrameTraced& action) {
  if (!action.sent || action.bytes.rfind("$TMSCT,", 0) != 0) return;
  const auto data = action.bytes.find(',', action.bytes.find(',') + 1) + 1;
  const auto script = action.bytes.find(',', data) + 1;
  scripts_.push_back(action.bytes.substr(script, action.bytes.rfind(",*") - script));
}

void CoreAndRobot::take(const simulator::Send& output) {
  for (const auto& [id, wire] : wires_) {
    if (wire.client != output.client) continue;
    core_.received(id, output.bytes, now_);
    return;
  }
}

void CoreAndRobot::take(const simulator::CloseClient& output) {
  for (const auto& [id, wire] : wires_) {
    if (wire.client != output.client) continue;
    forget(id, "connection closed by peer");
    return;
  }
}

void CoreAndRobot::forget(link::ConnectionId id, const std::string& reason) {
  wires_.erase(id);
  core_.closed(id, reason, now_);
}

}  // namespace cobot_command::testing
