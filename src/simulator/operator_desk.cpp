#include "operator_desk.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::simulator {

namespace {

OperatorReply done(std::string text) {
  return {true, std::move(text)};
}

constexpr const char* kNoProject = "no project runs: run it first";
constexpr int kSpeedStep = 5;  // [%] of Stick_Plus and Stick_Minus (ours)

}  // namespace

OperatorReply OperatorDesk::operate(const OperatorAction& action, Instant now) {
  now_ = now;
  return std::visit([&](const auto& what) { return act(what); }, action);
}

OperatorReply OperatorDesk::press(Button button, Instant now) {
  const auto change_speed = [&](int change) {
    const int speed = parts_.settings.project_speed_percent + change;
    return operate(SetProjectSpeed{std::clamp(speed - speed % kSpeedStep, kSpeedStep, 100)}, now);
  };
  switch (button) {
    case Button::PlayPause:
      if (!parts_.node.projectRuns()) return operate(RunProject{}, now);
      return parts_.queue.paused() ? operate(ResumeProject{}, now) : operate(PauseProject{}, now);
    case Button::Plus:
      return change_speed(kSpeedStep);
    case Button::Minus:
      return change_speed(-kSpeedStep);
    case Button::Stop:
      break;
  }
  return operate(StopProject{}, now);
}

OperatorReply OperatorDesk::act(const RunProject&) {
  if (emergency_stop_) return notDone("the project does not run: release the emergency stop first");
  if (!parts_.node.projectRuns()) {
    parts_.queue.resetSetting(parts_.settings.start_tcp, now_);
    parts_.project.beginAnew();
    project_started_ = now_;
    parts_.node.run(now_);
    settle_();
  }
  return done("the project runs");
}

OperatorReply OperatorDesk::act(const StopProject&) {
  parts_.queue.stop(now_);
  parts_.node.stop(now_);
  return done("the project is stopped");
}

OperatorReply OperatorDesk::act(const PauseProject&) {
  if (!parts_.node.projectRuns()) return notDone(kNoProject);
  parts_.queue.pause(now_);
  return done("the project is paused");
}

OperatorReply OperatorDesk::act(const ResumeProject&) {
  if (!parts_.node.projectRuns()) return notDone(kNoProject);
  parts_.queue.resume(now_);
  return done(safeguard_ ? "the project continues, but the open safeguard stops the arm"
                         : "the project continues");
}

OperatorReply OperatorDesk::act(const LeaveListenNode&) {
  if (!parts_.node.projectRuns()) return notDone(kNoProject);
  parts_.node.leaveForGood(now_);
  settle_();
  return done(parts_.queue.idle() ? "the flow is in another node"
                                  : "the flow leaves the Listen node when the queued motions are done");
}

OperatorReply OperatorDesk::act(const EnterListenNode&) {
  if (!parts_.node.projectRuns()) return notDone(kNoProject);
  parts_.node.comeBack(now_);
  settle_();
  return done(parts_.node.listening()
                  ? "the flow is in the Listen node"
                  : "the flow returns to the Listen node when the queued motions are done");
}

OperatorReply OperatorDesk::act(const SetEmergencyStop& action) {
  const bool was_pressed = std::exchange(emergency_stop_, action.pressed);
  if (action.pressed && !was_pressed) {
    parts_.queue.halt(now_);
    parts_.node.stop(now_);
  }
  return done(action.pressed ? "the emergency stop is pressed" : "the emergency stop is released");
}

OperatorReply OperatorDesk::act(const SetSafeguard& action) {
  const bool was_open = std::exchange(safeguard_, action.open);
  if (action.open) {
    parts_.queue.pause(now_, Holder::Safeguard);
    return done("the safeguard is open");
  }
  if (was_open && !parts_.settings.safeguard_resets_itself && parts_.node.projectRuns()) {
    parts_.queue.pause(now_);
  }
  parts_.queue.resume(now_, Holder::Safeguard);
  return done("the safeguard is closed");
}

OperatorReply OperatorDesk::act(const SetOperatingMode& action) {
  mode_ = action.mode;
  return done(mode_ == OperatingMode::Manual ? "manual mode" : "automatic mode");
}

OperatorReply OperatorDesk::act(const SetProjectSpeed& action) {
  if (!isProjectSpeed(action.percent)) {
    return notDone(fmt::format("project speed {} %: allowed are 5 to 100 in steps of 5", action.percent));
  }
  parts_.settings.project_speed_percent = action.percent;
  parts_.queue.setSpeedOverride(action.percent / 100.0, now_);
  return done(fmt::format("the project speed is {} %", action.percent));
}

OperatorReply OperatorDesk::act(const RaiseError& action) {
  if (action.code == 0) return notDone("error code 0 means no error: give another");
  parts_.queue.raise({action.code, foreignText(action.text)}, now_);
  return done(fmt::format("the robot is in error 0x{:X}", action.code));
}

OperatorReply OperatorDesk::act(const ClearError&) {
  parts_.queue.clearError();
  return done("the robot has no error");
}

OperatorReply OperatorDesk::act(const SetInput& action) {
  if (action.index < 0 || action.index >= script::ioCount(action.module)) {
    return notDone(fmt::format("there is no input {}: allowed are 0 to {}", action.index,
                               script::ioCount(action.module) - 1));
  }
  parts_.io.setInput(action.module, action.index, action.on);
  return done(fmt::format("the input is {}", action.on ? "on" : "off"));
}

OperatorReply OperatorDesk::act(const SetFault& order) {
  OperatorReply reply = set(parts_.faults, order);
  parts_.node.updatePort();
  return reply;
}

OperatorReply OperatorDesk::act(const ClearFaults&) {
  parts_.faults = FaultSwitches{};
  parts_.node.updatePort();
  return done("no fault is on");
}

OperatorReply OperatorDesk::act(const DropConnections&) {
  parts_.node.closeConnections();
  parts_.status.closeAll();
  return done("all clients are disconnected");
}

}  // namespace cobot_command::simulator
