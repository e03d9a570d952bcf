#include "cobot_command/capabilities/functions.h"

#include <fmt/format.h>

namespace cobot_command::capabilities {
namespace {

constexpr bool kNeedsArm = true;

}  // namespace

const std::vector<Function>& functions() {
  static const std::vector<Function> rows{
      {"ExchangeConfiguration", "action exchange_configuration, service update_configuration"},
      {"ReadRobotData", "topic robot_data"},
      {"ReadMessages", "topic messages, topic pending_messages, service read_messages"},
      {"GroupReset", "service reset", Offer::Partly,
       "an error of the controller cannot be cleared through the Listen node"},
      {"state of the group", "topic group_state"},
      {"ReadToolData", "service read_tool"},
      {"WriteToolData", "service write_tool"},
      {"ReadFrameData", "service read_frame"},
      {"WriteFrameData", "service write_frame"},
      {"ReadLoadData", "service read_load"},
      {"WriteLoadData", "service write_load"},
      {"MoveLinearAbsolute", "action move_absolute"},
      {"MoveAxesAbsolute", "action move_absolute"},
      {"MoveDirectAbsolute", "action move_absolute"},
      {"MoveLinearRelative", "action move_relative"},
      {"MoveAxesRelative", "action move_relative"},
      {"MoveDirectRelative", "action move_relative"},
      {"MoveCircularAbsolute", "action move_circle"},
      {"GroupStop", "action stop"},
      {"GroupInterrupt", "service interrupt", Offer::Partly,
       "refused for a jog, a trajectory, a retrace, a cell program, or a script with more than motions and "
       "outputs: use stop or PAUSE",
       kNeedsArm},
      {"GroupContinue", "service continue", Offer::Whole, {}, kNeedsArm},
      {"CalculateForwardKinematic", "service forward_kinematics", Offer::Whole, {}, kNeedsArm},
      {"CalculateInverseKinematic", "service inverse_kinematics", Offer::Whole, {}, kNeedsArm},
      {"CalculateFrame", "service calculate_frame"},
      {"CalculateTool", "service calculate_tool"},
      {"WriteDigitalOutputs", "action set_output"},
      {"ReadDigitalInputs", "topic digital_io, action wait_for_input", Offer::Partly,
       "only those that the controller streams"},
      {"ReadDigitalOutputs", "topic digital_io", Offer::Partly, "only those that the controller streams"},
      {"WaitTime", "action wait_time"},
      {"CallSubprogram", "action run_script", Offer::Partly, "lines of script, no subprograms"},
      {"ChangeSpeedOverride", "service change_speed_override", Offer::Partly,
       "applies from the next motion on, not to the running motion: Project_Speed is not written; 100 at the "
       "start, not 10"},
      {"ReadRobotReferenceDynamics", "service read_reference_dynamics", Offer::Whole, {}, kNeedsArm},
      {"WriteRobotReferenceDynamics", "", Offer::NoWay, "the controller defines what 100 % means"},
      {"ReadRobotDefaultDynamics", "service read_default_dynamics"},
      {"WriteRobotDefaultDynamics", "service write_default_dynamics"},
      {"ReadRobotSWLimits", "service read_software_limits", Offer::Whole, {}, kNeedsArm},
      {"WriteRobotSWLimits", "service write_software_limits", Offer::Partly,
       "limits of this layer's planning, at most those of the model", kNeedsArm},
      {"GroupJog", "action jog", Offer::Whole, {}, kNeedsArm},
      {"ReturnToPrimary", "action return_to_primary", Offer::Whole, {}, kNeedsArm},
      {"retrace", "action retrace", Offer::Partly, "only for paths of load_path", kNeedsArm},
      {"work areas", "", Offer::NoWay, "a TM controller does not offer them to a Listen node"},
      {"working hours", "", Offer::NoWay, "a TM controller reports only its uptime"},
      {"brake test", "", Offer::NoWay, "a TM controller does not offer it to a Listen node"},
      {"step mode", "", Offer::NoWay, "a TM controller does not offer it to a Listen node"},
      {"path accuracy mode", "", Offer::NoWay, "a TM controller does not offer it to a Listen node"},
      {"avoid singularity", "", Offer::NoWay, "a TM controller does not offer it to a Listen node"},
      {"collision detection", "", Offer::NoWay, "always on; configured on the pendant"},
  };
  return rows;
}

Support supportOf(const Function& function, bool has_arm) {
  switch (function.offer) {
    case Offer::NotBuilt:
      return {false, "not built yet"};
    case Offer::NoWay:
      return {false, std::string(function.reason)};
    case Offer::Whole:
    case Offer::Partly:
      break;
  }
  if (function.needs_arm && !has_arm) return {false, kNoArm};
  return {true, std::string(function.reason)};
}

std::vector<std::string> beyondTheController() {
  std::vector<std::string> names;
  for (const Function& function : functions()) {
    if (function.offer != Offer::NoWay) continue;
    names.push_back(fmt::format("{}: {}", function.srci, function.reason));
  }
  return names;
}

}  // namespace cobot_command::capabilities
