// Levels of the digital inputs, or outputs, of the robot, from its status stream.
#pragma once

#include <array>
#include <optional>

namespace cobot_command::link {

/// By number; nullopt: the controller's data table does not stream it.
struct DigitalLevels {
  std::array<std::optional<bool>, 16> control_box;
  std::array<std::optional<bool>, 4> end_module;

  friend bool operator==(const DigitalLevels& a, const DigitalLevels& b) {
    return a.control_box == b.control_box && a.end_module == b.end_module;
  }
  friend bool operator!=(const DigitalLevels& a, const DigitalLevels& b) { return !(a == b); }
};

}  // namespace cobot_command::link
