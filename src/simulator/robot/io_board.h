// The inputs and outputs of the control box and of the end module, and the light of the camera.
#pragma once

#include "wire/outbox.h"
#include <fmt/format.h>

#include "cobot_command/script/script_command.h"
#include "cobot_command/simulator/robot_state.h"

namespace cobot_command::simulator {

struct SetCameraLight {
  bool on = true;
};

class IoBoard {
 public:
  explicit IoBoard(Outbox& outbox) : outbox_(outbox) {}

  void write(const script::WriteOutput& write) {
    outputs_.at(write.module, write.index) = write.on;
    outbox_.log(script::toText(write));
  }
  void write(const script::WriteAnalogOutput& write) {
    analog_output_ = static_cast<float>(write.volt);
    outbox_.log(fmt::format("the analog output of the control box is {} V", analog_output_));
  }
  void write(const SetCameraLight& write) {
    camera_light_ = write.on;
    outbox_.log(fmt::format("the light of the camera is {}", write.on ? "on" : "off"));
  }
  void setInput(script::IoModule module, int index, bool on) {
    inputs_.at(module, index) = on;
    outbox_.log(fmt::format("input {} of the {} is {}", index,
                            module == script::IoModule::ControlBox ? "control box" : "end module",
                            on ? "on" : "off"));
  }

  [[nodiscard]] const DigitalIo& inputs() const { return inputs_; }
  [[nodiscard]] const DigitalIo& outputs() const { return outputs_; }
  [[nodiscard]] float analogOutput() const { return analog_output_; }
  [[nodiscard]] bool cameraLight() const { return camera_light_; }

 private:
  Outbox& outbox_;
  DigitalIo inputs_, outputs_;
  float analog_output_ = 0;
  bool camera_light_ = false;
};

}  // namespace cobot_command::simulator
