#include "robot_data/robot_data_message.h"

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cobot_command/capabilities/functions.h"
#include "cobot_command/capabilities/layer_version.h"
#include "cobot_command/common/units.h"

namespace cobot_command::ros_adapter {
namespace {

static_assert(cobot_command::RobotData::NOT_OFFERED == capabilities::kNotOffered);

/// Of all arms that arm::ArmModel knows; Omron sells them under its name, too.
constexpr const char* kMaker = "Techman Robot";

/// What the way from degrees into SI and back rounds away is not shown.
double shownDegrees(double radians) {
  constexpr double kPerDegree = 1e9;
  return std::round(radToDeg(radians) * kPerDegree) / kPerDegree;
}

void addAxes(const arm::ArmModel& arm, const JointNames& names, cobot_command::RobotData& message) {
  for (std::size_t i = 0; i < arm::kJointCount; ++i) {
    const arm::JointLimit& limit = arm.limits()[i];
    cobot_command::RobotAxis axis;
    axis.name = names[i];
    axis.lower_limit = shownDegrees(limit.lower);
    axis.upper_limit = shownDegrees(limit.upper);
    axis.rated_speed = shownDegrees(limit.max_velocity);
    message.axes.push_back(std::move(axis));
  }
}

std::vector<std::string> interfacesOf(std::string_view ours) {
  constexpr std::string_view kBetween = ", ";
  std::vector<std::string> interfaces;
  while (!ours.empty()) {
    const std::size_t end = ours.find(kBetween);
    interfaces.emplace_back(ours.substr(0, end));
    ours.remove_prefix(end == std::string_view::npos ? ours.size() : end + kBetween.size());
  }
  return interfaces;
}

void addFunctions(bool has_arm, cobot_command::RobotData& message) {
  for (const capabilities::Function& function : capabilities::functions()) {
    capabilities::Support support = supportOf(function, has_arm);
    cobot_command::RobotFunction told;
    told.name = function.srci;
    told.interfaces = interfacesOf(function.ours);
    told.reason = std::move(support.reason);
    (support.offered ? message.supported : message.unsupported).push_back(std::move(told));
  }
}

}  // namespace

cobot_command::RobotData toMessage(const arm::ArmModel* arm, const JointNames& names,
                                   const link::ControllerIdentity& identity, const ros::Time& stamp) {
  cobot_command::RobotData message;
  message.header.stamp = stamp;
  message.maker = kMaker;
  message.layer_version = capabilities::layerVersion();
  if (arm != nullptr) {
    message.model = arm->name();
    addAxes(*arm, names, message);
  } else {
    message.unknown.push_back(fmt::format("model, axes: {}", capabilities::kNoArm));
  }
  const auto take = [&message](const char* field, const char* item, const std::optional<std::string>& told,
                               std::string& target) {
    if (told) {
      target = *told;
    } else {
      message.unknown.push_back(
          fmt::format("{}: there is no status stream, or the controller has not answered the request for {}",
                      field, item));
    }
  };
  take("controller_model", "Robot_Model", identity.robot_model, message.controller_model);
  take("control_box_sn", "ControlBox_SN", identity.control_box_sn, message.control_box_sn);
  take("tmflow_version", "TMflow_Version", identity.tmflow_version, message.tmflow_version);
  addFunctions(arm != nullptr, message);
  return message;
}

}  // namespace cobot_command::ros_adapter
