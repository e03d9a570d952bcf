#include "shared/name_rules.h"

#include "cobot_command/common/setting_kinds.h"
#include "cobot_command/ros/mechanism/mechanism_node.h"

namespace cobot_command::ros_adapter {

SettingTable settingsTable(MechanismParameters& p) {
  using namespace setting_kinds;
  return {{"cell", text(p.cell, absoluteNamespace()), "namespace of the cell supervisor"},
          {"mechanism", text(p.mechanism), "name of the mechanism in the cell; required"},
          {"artifact", text(p.artifact, orEmpty(absolutePath())), "file made by `tm_cell build`; required"},
          {"running", flag(p.running),
           "true: the program runs from the start; false: only after a call of `run`"}};
}

Result<MechanismParameters, ParameterError> readMechanismParameters(const GivenParameters& given) {
  MechanismParameters parameters;
  const SettingTable table = settingsTable(parameters);
  auto fault = take(table, given.own);
  if (!fault && parameters.artifact.empty()) fault = SettingFault{"artifact", "is empty", "an absolute path"};
  if (!fault && parameters.mechanism.empty()) {
    fault = SettingFault{"mechanism", "is empty", "the name of a mechanism of the cell"};
  }
  if (fault) return refuse(parameterError(given, *fault));
  parameters.warnings = warningsOfUnknown(given, table, {});
  return parameters;
}

}  // namespace cobot_command::ros_adapter
