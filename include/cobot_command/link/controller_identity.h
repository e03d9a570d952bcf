// The identity that a controller reports on its status port.
#pragma once

#include <optional>
#include <string>

namespace cobot_command::link {

/// As reported; nullopt: not reported (yet).
struct ControllerIdentity {
  std::optional<std::string> robot_model;     ///< "TM5-900"
  std::optional<std::string> control_box_sn;  ///< serial number of the control box
  std::optional<std::string> tmflow_version;  ///< "1.84.1200"
};

[[nodiscard]] inline bool operator==(const ControllerIdentity& a, const ControllerIdentity& b) {
  return a.robot_model == b.robot_model && a.control_box_sn == b.control_box_sn &&
         a.tmflow_version == b.tmflow_version;
}
[[nodiscard]] inline bool operator!=(const ControllerIdentity& a, const ControllerIdentity& b) {
  return !(a == b);
}

}  // namespace cobot_command::link
