#include "cobot_command/ros/supervision/supervisor_parameters.h"

#include "shared/name_rules.h"

#include "cobot_command/common/setting_kinds.h"

namespace cobot_command::ros_adapter {

SettingTable settingsTable(SupervisorParameters& p) {
  using namespace setting_kinds;
  using runtime::Deciding;
  const TextRule path = absolutePath();
  return {
      {"artifact", text(p.files.artifact, orEmpty(path)),
       "what `tm_cell build` has made of the cell; has to be given"},
      {"journal", text(p.files.journal, orEmpty(path)),
       "what was granted is kept there over a restart; made where there is none; has to be given"},
      {"cell_file", text(p.files.cell_file, orEmpty(path)),
       "the file of the cell: an artifact that is not made of it is refused; empty: it is only verified"},
      {"policy",
       choice<Deciding>(p.policy, {{"artifact", Deciding::AsBuilt},
                                   {"supervisor", Deciding::Supervisor},
                                   {"safe_order", Deciding::SafeOrder},
                                   {"schedule", Deciding::Schedule}}),
       "what decides; artifact: what that was built for; schedule: that, and turns by the shortest cycle"}};
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
