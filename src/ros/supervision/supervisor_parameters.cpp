#include "cobot_command/ros/supervision/supervisor_parameters.h"

#include "shared/name_rules.h"

#include "cobot_command/common/setting_kinds.h"

namespace cobot_command::ros_adapter {

SettingTable settingsTable(SupervisorParameters& p) {
  using namespace setting_kinds;
  using runtime::Deciding;
  const TextRule path = absolutePath();
  return {
      {"artifact", text(p.files.artifact, orEmpty(path)), "file made by `tm_cell build`; required"},
      {"journal", text(p.files.journal, orEmpty(path)),
       "file that keeps the granted permits over a restart; created if it does not exist; required"},
      {"cell_file", text(p.files.cell_file, orEmpty(path)),
       "cell file: an artifact that was not made from it is refused; empty: the artifact is only verified"},
      {"policy",
       choice<Deciding>(p.policy, {{"artifact", Deciding::AsBuilt},
                                   {"supervisor", Deciding::Supervisor},
                                   {"safe_order", Deciding::SafeOrder},
                                   {"schedule", Deciding::Schedule}}),
       "policy that decides permits. artifact: the one the artifact was built for; schedule: the same, but "
       "robots get zones in the order of the shortest cycle"}};
}

Result<SupervisorParameters, ParameterError> readSupervisorParameters(const GivenParameters& given) {
  SupervisorParameters parameters;
  const SettingTable table = settingsTable(parameters);
  auto fault = take(table, given.own);
  const std::string allowed = "an absolute path";
  if (!fault && parameters.files.artifact.empty()) fault = SettingFault{"artifact", "is empty", allowed};
  if (!fault && parameters.files.journal.empty()) fault = SettingFault{"journal", "is empty", allowed};
  if (fault) return refuse(parameterError(given, *fault));
  parameters.warnings = warningsOfUnknown(given, table, {});
  return parameters;
}

}  // namespace cobot_command::ros_adapter
