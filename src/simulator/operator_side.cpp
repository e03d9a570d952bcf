// What the operator does to the simulated controller.
#include <utility>

#include "controller_impl.h"
#include <fmt/format.h>

namespace cobot_command::simulator {

namespace {

OperatorReply done(std::string text) {
  return {true, std::move(text)};
}
OperatorReply notDone(std::string text) {
  return {false, std::move(text)};
}

constexpr const char* kNoProject = "no project runs: run it first";

}  // namespace

OperatorReply SimulatedController::Impl::operate(const OperatorAction& action, Instant now) {
  advance(now);
  OperatorReply reply = std::visit([&](const auto& what) { return act(what); }, action);
  outbox_.log("operator: " + reply.text);
  settle();
  return reply;
}

OperatorReply SimulatedController::Impl::act(const RunProject&) {
  if (emergency_stop_) return notDone("the project does not run: release the emergency stop first");
  if (!node_.projectRuns()) {
    queue_.resetSetting();
    project_.beginAnew();
    project_started_ = now_;
    node_.run(now_);
    settle();
  }
  return done("the project runs");
}

OperatorReply SimulatedController::Impl::act(const StopProject&) {
  queue_.stop(now_);
  node_.stop(now_);
  return done("the project is stopped");
}

OperatorReply SimulatedController::Impl::act(const PauseProject&) {
  if (!node_.projectRuns()) return notDone(kNoProject);
  queue_.pause(now_);
  return done("the project is paused");
}

OperatorReply SimulatedController::Impl::act(const ResumeProject&) {
  if (!node_.projectRuns()) return notDone(kNoProject);
  queue_.resume(now_);
  return done(safeguard_ ? "the project goes on, but the open safeguard holds the arm"
                         : "the project goes on");
}

OperatorReply SimulatedController::Impl::act(const LeaveListenNode&) {
  if (!node_.projectRuns()) return notDone(kNoProject);
  node_.leaveForGood(now_);
  settle();
  return done(queue_.idle() ? "the flow is in another node"
                            : "the flow leaves the Listen node when the queued motions are done");
}

OperatorReply SimulatedController::Impl::act(const EnterListenNode&) {
  if (!node_.projectRuns()) return notDone(kNoProject);
  node_.comeBack(now_);
  settle();
  return done(node_.listening() ? "the flow is in the Listen node"
                                : "the flow comes back to the Listen node when the queued motions are done");
}

OperatorReply SimulatedController::Impl::act(const SetEmergencyStop& action) {
  const bool was_pressed = std::exchange(emergency_stop_, action.pressed);
  if (action.pressed && !was_pressed) {
    queue_.halt(now_);
    node_.stop(now_);
  }
  return done(action.pressed ? "the emergency stop is pressed" : "the emergency stop is released");
}

OperatorReply SimulatedController::Impl::act(const SetSafeguard& action) {
  const bool was_open = std::exchange(safeguard_, action.open);
  if (action.open) {
    queue_.pause(now_, Holder::Safeguard);
    return done("the safeguard is open");
  }
  if (was_open && !settings_.safeguard_resets_itself && node_.projectRuns()) queue_.pause(now_);
  queue_.resume(now_, Holder::Safeguard);
  return done("the safeguard is closed");
}

OperatorReply SimulatedController::Impl::act(const SetOperatingMode& action) {
  mode_ = action.mode;
  return done(mode_ == OperatingMode::Manual ? "manual mode" : "automatic mode");
}

OperatorReply SimulatedController::Impl::act(const SetProjectSpeed& action) {
  if (!isProjectSpeed(action.percent)) {
    return notDone(fmt::format("project speed {} %: allowed are 5 to 100 in steps of 5", action.percent));
  }
  settings_.project_speed_percent = action.percent;
  queue_.setSpeedOverride(action.percent / 100.0);
  return done(fmt::format("the project speed is {} %", action.percent));
}

OperatorReply SimulatedController::Impl::act(const RaiseError& action) {
  if (action.code == 0) return notDone("error code 0 means no error: give another");
  error_since_ = now_;
  queue_.raise({action.code, action.text}, now_);
  return done(fmt::format("the robot is in error 0x{:X}", action.code));
}

OperatorReply SimulatedController::Impl::act(const ClearError&) {
  queue_.clearError();
  return done("the robot is in no error");
}

OperatorReply SimulatedController::Impl::act(const SetInput& action) {
  if (action.index < 0 || action.index >= script::ioCount(action.module)) {
    return notDone(fmt::format("there is no input {}: allowed are 0 to {}", action.index,
                               script::ioCount(action.module) - 1));
  }
  io_.setInput(action.module, action.index, action.on);
  return done(fmt::format("the input is {}", action.on ? "on" : "off"));
}

OperatorReply SimulatedController::Impl::act(const SetFault& order) {
  OperatorReply reply = set(faults_, order);
  node_.updatePort();
  return reply;
}

OperatorReply SimulatedController::Impl::act(const ClearFaults&) {
  faults_ = FaultSwitches{};
  node_.updatePort();
  return done("no fault is on");
}

OperatorReply SimulatedController::Impl::act(const DropConnections&) {
  node_.closeConnections();
  status_.closeAll();
  return done("all connections are dropped");
}

}  // namespace cobot_command::simulator
