#include "cobot_command/ros/cell_watch/monitor_parameters.h"

#include <fmt/format.h>
#include <ros/console.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/setting_kinds.h"

namespace cobot_command::ros_adapter {
namespace {

using namespace setting_kinds;
using Mode = cell::MonitorSettings::Mode;

/// No margin is greater.
constexpr double kMostDistance = 0.2;  // [m]
constexpr double kHalfOfTheMargin = -1;

TextRule absolutePath() {
  return {"an absolute path", [](const std::string& name) { return !name.empty() && name.front() == '/'; }};
}

/// Absent is written as -1.
SettingKind distanceOrNone(std::optional<double>& value) {
  double unused = 0;
  SettingKind kind = real(unused, 0, kMostDistance, "m");
  kind.range += ", or -1";
  kind.take = [&value](const Given& given) -> std::optional<std::string> {
    const auto found = finiteIn(given);
    const bool is_none = found == kHalfOfTheMargin;
    if (!found || (!is_none && (*found < 0 || *found > kMostDistance))) return isFound(given);
    value = is_none ? std::nullopt : found;
    return std::nullopt;
  };
  kind.show = [&value] { return fmt::format("{:.9g}", value.value_or(kHalfOfTheMargin)); };
  return kind;
}

}  // namespace

SettingTable settingsTable(MonitorParameters& p) {
  return {{"cell_file", text(p.cell_file, orEmpty(absolutePath())), "cell file; required"},
          {"mode", choice<Mode>(p.mode, {{"stop", Mode::Stop}, {"warn", Mode::Warn}}),
           "warn: robots are not stopped; a stop is only logged"},
          {"stop_distance", distanceOrNone(p.stop_distance),
           "at a smaller distance all robots are stopped; at most the margin of the cell; -1: half of the "
           "margin"},
          {"artifact", text(p.artifact, orEmpty(absolutePath())),
           "file made by `tm_cell build` from the cell file. It is used for the parts that robots carry and "
           "for the pictures of zones. Empty: each robot is assumed to carry all parts it can carry, and no "
           "zones are shown"},
          {"publish_frames", flag(p.publish_frames),
           "publishes the transform from `world` to the base of each robot when the prefix of its joint "
           "states is known"},
          {"diagnostic_period", real(p.diagnostic_period, 0.1, 3600, "s"), "period of `/diagnostics`"}};
}

Result<MonitorParameters, ParameterError> readMonitorParameters(const GivenParameters& given) {
  MonitorParameters parameters;
  const SettingTable table = settingsTable(parameters);
  if (const auto fault = take(table, given.own)) return refuse(parameterError(given, *fault));
  if (parameters.cell_file.empty()) {
    return refuse(parameterError(given, {"cell_file", "is empty", "the absolute path of the cell file"}));
  }
  parameters.warnings = warningsOfUnknown(given, table, {});
  return parameters;
}

Result<MonitorParameters, ParameterError> readMonitorParameters(const ros::NodeHandle& node,
                                                                const ros::NodeHandle& self) {
  auto parameters = readMonitorParameters(givenParameters(node, self));
  if (!parameters) return parameters;
  for (const std::string& warning : parameters->warnings) ROS_WARN_STREAM(forPeople(warning));
  return parameters;
}

}  // namespace cobot_command::ros_adapter
