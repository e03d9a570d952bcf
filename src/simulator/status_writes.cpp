// What clients of the status port do to the robot by writing items.
#include <algorithm>
#include <utility>

#include "controller_impl.h"
#include "status_port/variable_items.h"
#include <fmt/format.h>

namespace cobot_command::simulator {

namespace {

constexpr int kSpeedStep = 5;  // [%] of Stick_Plus and Stick_Minus (ours)

}  // namespace

void SimulatedController::Impl::receivedOnStatus(ClientId client, std::string_view bytes) {
  status_.feed(client, bytes);
  // Frame by frame: a request in the same piece sees what the one before has written.
  while (true) {
    const RobotState robot = measured();
    if (!status_.answerNext(client, source(robot))) return;
    for (const ItemWrite& write : status_.takeWrites()) {
      std::visit([&](const auto& what) { on(what); }, write);
    }
    settle();
  }
}

// A stick that does what the operator does; a button that cannot do it does nothing, and the log says why.
void SimulatedController::Impl::on(const PressButton& press) {
  if (!press.pressed) return;
  const auto change_speed = [&](int change) {
    const int speed = settings_.project_speed_percent + change;
    return act(SetProjectSpeed{std::clamp(speed - speed % kSpeedStep, kSpeedStep, 100)});
  };
  const auto play_or_pause = [&] {
    if (!node_.projectRuns()) return act(RunProject{});
    return queue_.paused() ? act(ResumeProject{}) : act(PauseProject{});
  };
  const OperatorReply reply = press.button == Button::PlayPause ? play_or_pause()
                              : press.button == Button::Plus    ? change_speed(kSpeedStep)
                              : press.button == Button::Minus   ? change_speed(-kSpeedStep)
                                                                : act(StopProject{});
  outbox_.log("stick: " + reply.text);
}

void SimulatedController::Impl::on(const SetProjectName& project) {
  settings_.project_name = project.name;
}

void SimulatedController::Impl::on(const SetAutoRemote& remote) {
  auto_remote_ = remote.active;
}

void SimulatedController::Impl::on(const SetVariable& variable) {
  if (!project_.variables.set(variable.name, toLanguage(variable.value))) {
    outbox_.log("no room for " + variable.name);
  }
}

void SimulatedController::Impl::on(const SetProjectSpeed& speed) {
  outbox_.log(act(speed).text);
}

}  // namespace cobot_command::simulator
