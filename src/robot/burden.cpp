#include "cobot_command/robot/burden.h"

#include <variant>

#include <fmt/format.h>

#include "cobot_command/common/given.h"

namespace cobot_command::robot {

bool Burden::accepted(const script::ScriptCommand& command, bool behind_motion) {
  const auto* tool = std::get_if<script::ChangeTcp>(&command);
  const auto* load = std::get_if<script::ChangeLoad>(&command);
  if (tool != nullptr) tool_ = {tool->weight, behind_motion};
  if (load != nullptr) load_ = {load->weight, behind_motion};
  return tool != nullptr || load != nullptr;
}

void Burden::stopped() {
  for (Commanded* commanded : {&tool_, &load_}) {
    if (commanded->behind_motion) *commanded = {};
  }
}

std::optional<TooMuch> Burden::tooMuchFor(const arm::ArmModel& arm, const ActiveFrames& active) const {
  const double payload = arm.ratings().payload;
  const auto tool = active.tool_mass ? active.tool_mass : tool_.mass;
  if (tool.value_or(0) + load_.mass.value_or(0) <= payload) return std::nullopt;
  const std::string name = active.tcp_name.empty() ? "" : " " + quoted(active.tcp_name);
  std::string carried;
  if (tool) carried = fmt::format("the active tool{} has {} kg", name, *tool);
  if (load_.mass) carried += fmt::format("{}its load (ChangeLoad) {} kg", tool ? ", " : "", *load_.mass);
  return TooMuch{fmt::format("{}, the payload of {} is {} kg", carried, arm.name(), payload), payload};
}

}  // namespace cobot_command::robot
