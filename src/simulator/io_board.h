// The digital inputs and outputs of the control box and of the end module.
#pragma once

#include "outbox.h"
#include <fmt/format.h>

#include "cobot_command/protocol/script_command.h"
#include "cobot_command/simulator/robot_state.h"

namespace cobot_command::simulator {

class IoBoard {
 public:
  explicit IoBoard(Outbox& outbox) : outbox_(outbox) {}

  void write(const protocol::WriteOutput& write) {
    outputs_.at(write.module, write.index) = write.on;
    outbox_.log(protocol::toText(write));
  }
  void setInput(protocol::IoModule module, int index, bool on) {
    inputs_.at(module, index) = on;
    outbox_.log(fmt::format("input {} of the {} is {}", index,
                            module == protocol::IoModule::ControlBox ? "control box" : "end module",
                            on ? "on" : "off"));
  }

  [[nodiscard]] const DigitalIo& inputs() const { return inputs_; }
  [[nodiscard]] const DigitalIo& outputs() const { return outputs_; }

 private:
  Outbox& outbox_;
  DigitalIo inputs_, outputs_;
};

}  // namespace cobot_command::simulator
