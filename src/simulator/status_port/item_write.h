// What writing an item does to the robot.
#pragma once

#include <string>
#include <variant>

#include "robot/io_board.h"

#include "cobot_command/protocol/item_content.h"
#include "cobot_command/script/script_command.h"
#include "cobot_command/simulator/operator_action.h"

namespace cobot_command::simulator {

enum class Button { PlayPause, Plus, Minus, Stop };

/// A button of the stick; false, which is not pressed, does nothing.
struct PressButton {
  Button button = Button::Stop;
  bool pressed = true;
};
struct SetProjectName {
  std::string name;
};
struct SetAutoRemote {
  bool active = true;
};
/// A global variable of the project; of its type and size.
struct SetVariable {
  std::string name;
  protocol::ItemValue value;
};

using ItemWrite = std::variant<PressButton, SetCameraLight, script::WriteAnalogOutput, SetProjectName,
                               SetAutoRemote, SetVariable, SetProjectSpeed, script::WriteOutput>;

}  // namespace cobot_command::simulator
