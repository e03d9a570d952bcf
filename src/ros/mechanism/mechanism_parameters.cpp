#include "shared/name_rules.h"

#include "cobot_command/common/setting_kinds.h"
#include "cobot_command/ros/mechanism/mechanism_node.h"

namespace cobot_command::ros_adapter {

SettingTable settingsTable(MechanismParameters& p) {
  using namespace setting_kinds;
  return {{"cell", text(p.cell, absoluteNamespace()), "namespace of the supervisor"},
          {"mechanism", text(p.mechanism), "its name in the cell; has to be given"},
          {"artifact", text(p.artifact, orEmpty(absolutePath())),
           "what `tm_cell build` has made of the cell; has to be given"},
          {"running", flag(p.running), "it runs its program from the start; else once `run` was called"}};
}

Result<MechanismParameters, ParameterError> readMechanismParameters(const GivenParameters& given) {
  MechanismParameters parameters;
  const SettingTable table = settingsTable(parameters);
  auto fault = take(table, given.own);
  if (!fault && parameters.artifact.empty()) fault = SettingFault{"artifact", "is empty", "an absolute path"};
  if (!fault && parameters.mechanism.empty()) {
    fault = SettingFault{"mechanism", "is empty", "a mechanism of the cell"};
  }
  if (fault) return refuse(parameterError(given, *fault));
  parameters.warnings = warningsOfUnknown(given, table, {});
  return parameters;
}

}  // namespace cobot_command::ros_adapter
