// What clients of the status port do to the robot by writing items.
#include <utility>

#include "controller_impl.h"
#include "status_port/variable_items.h"
#include <fmt/format.h>

namespace cobot_command::simulator {

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

// A button that cannot do what it is for: the log says why.
void SimulatedController::Impl::on(const PressButton& press) {
  if (press.pressed) outbox_.log("stick: " + operator_.press(press.button, now_).text);
}

void SimulatedController::Impl::on(const SetProjectName& project) {
  settings_.project_name = project.name;
}

void SimulatedController::Impl::on(const SetAutoRemote& remote) {
  auto_remote_ = remote.active;
}

void SimulatedController::Impl::on(const SetVariable& variable) {
  if (!project_.variables.set(variable.name, toLanguage(variable.value))) {
    outbox_.log("no space for " + variable.name);
  }
}

void SimulatedController::Impl::on(const SetProjectSpeed& speed) {
  outbox_.log(operator_.operate(speed, now_).text);
}

}  // namespace cobot_command::simulator
