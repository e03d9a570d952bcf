#include "cobot_command/simulator/settings.h"

#include <algorithm>
#include <array>

#include "reserved_names.h"
#include "robot/project_data.h"
#include "settings_text.h"
#include "status_port/item_table.h"
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace cobot_command::simulator {

namespace {

std::optional<SettingFault> faultInVariables(const Settings& settings, tm_script::Variables& variables) {
  for (const std::string& declaration : settings.variables) {
    const auto fault = [&](const std::string& reason) {
      return SettingFault{"variables", fmt::format("holds {}: {}", quoted(declaration), reason),
                          "declarations of variables, such as int var_i = 5, each with its own name"};
    };
    const auto name = declare(variables, declaration);
    if (!name) return fault(name.error());
    if (const auto taken = whatIsNamed(*name)) return fault(fmt::format("{} is {}", *name, *taken));
  }
  return std::nullopt;
}

std::optional<SettingFault> faultInPosture(const arm::JointVector& posture, const arm::ArmModel& arm,
                                           const std::string& setting, const std::string& whose) {
  const SettingFault fault{setting, "", "postures of " + arm.name()};
  if (!posture.allFinite()) return SettingFault{setting, whose + "angles that are not finite", fault.allowed};
  const int outside = arm.firstJointOutsideLimits(posture);
  if (outside < 0) return std::nullopt;
  const auto joint = static_cast<std::size_t>(outside);
  const arm::JointLimit& limit = arm.limits().at(joint);
  return SettingFault{
      setting,
      fmt::format("{}joint {} at {:g} deg, outside its limits {:g} to {:g} deg", whose, joint + 1,
                  radToDeg(posture[outside]), radToDeg(limit.lower), radToDeg(limit.upper)),
      fault.allowed};
}

}  // namespace

std::vector<std::string> defaultStreamItems() {
  std::vector<std::string> names = parseNames(
      "Robot_Link,Robot_Error,Project_Run,Project_Pause,Safeguard_A,ESTOP,Camera_Light,Error_Code,"
      "Joint_Angle,Coord_Robot_Flange,Coord_Robot_Tool,TCP_Force,TCP_Force3D,TCP_Speed,TCP_Speed3D,"
      "Joint_Speed,Joint_Torque,Project_Speed,MA_Mode,Robot_Light");
  const auto add = [&](std::string_view more) {
    const auto list = parseNames(more);
    names.insert(names.end(), list.begin(), list.end());
  };
  for (int i = 0; i < 8; ++i) names.push_back(fmt::format("Ctrl_DO{}", i));
  for (int i = 0; i < 8; ++i) names.push_back(fmt::format("Ctrl_DI{}", i));
  add("Ctrl_AO0,Ctrl_AI0,Ctrl_AI1,End_DO0,End_DO1,End_DO2,End_DO3,End_DI0,End_DI1,End_DI2,End_AI0");
  add("TCP_Name,TCP_Value,TCP_Mass,Base_Name,Base_Value,Coord_Base_Flange,Coord_Base_Tool,Error_Content");
  return names;
}

std::optional<SettingFault> faultIn(const Settings& settings) {
  const auto& versions = knownTmflowVersions();
  if (std::find(versions.begin(), versions.end(), settings.tmflow_version) == versions.end()) {
    return SettingFault{"tmflow_version", "is " + quoted(settings.tmflow_version),
                        fmt::format("{}", fmt::join(versions, ", "))};
  }
  tm_script::Variables variables;
  if (auto fault = faultInVariables(settings, variables)) return fault;
  for (const std::string& name : settings.stream_items) {
    if (isItem(name) || variables.find(name) != nullptr) continue;
    return SettingFault{
        "stream_items",
        fmt::format("names {}, which is neither an item nor one of the variables", quoted(name)),
        "items of doc/simulator.md, and names of variables"};
  }
  return std::nullopt;
}

std::optional<SettingFault> faultIn(const Settings& settings, const arm::ArmModel& arm) {
  if (auto fault = faultIn(settings)) return fault;
  if (auto fault = faultInPosture(settings.start_posture, arm, "start_posture_deg", "has ")) return fault;
  for (const auto& [name, joints] : settings.points) {
    if (auto fault = faultInPosture(joints, arm, "points", quoted(name) + " has ")) return fault;
  }
  return std::nullopt;
}

}  // namespace cobot_command::simulator
