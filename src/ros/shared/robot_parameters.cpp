#include "cobot_command/ros/shared/robot_parameters.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/arm/urdf_prefix.h"
#include "cobot_command/common/setting_kinds.h"
#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::ros_adapter {

namespace {

using Arm = std::optional<arm::ArmModel>;
using ArmResult = Result<Arm, SettingFault>;

constexpr const char* kDescriptions =
    "a robot_description of the TM family, or the name of a model in robot_model";

bool isOfSameGeometry(const arm::ArmModel& one, const arm::ArmModel& other) {
  constexpr double kTolerance = 1e-6;  // [m], [rad]
  const auto numbers = [](const arm::ArmModel& arm) {
    const arm::DhLengths& l = arm.lengths();
    std::vector<double> all{l.d1, l.a2, l.a3, l.d4, l.d5, l.d6};
    for (const arm::JointLimit& limit : arm.limits()) {
      all.insert(all.end(), {limit.lower, limit.upper, limit.max_velocity});
    }
    return all;
  };
  const auto a = numbers(one);
  const auto b = numbers(other);
  return std::equal(a.begin(), a.end(), b.begin(),
                    [](double x, double y) { return std::abs(x - y) <= kTolerance; });
}

void compareNames(const RobotParameters& robot, const arm::ArmModel& described,
                  std::vector<std::string>& warnings) {
  const std::string published = jointNames(robot.prefix).front();
  const std::string& found = described.jointNames().front();
  if (published == found) return;
  warnings.push_back(
      fmt::format("prefix is {}, so the first joint is {}, but in robot_description it is {}: RViz and tf "
                  "will not show the robot's motion; use the same prefix for both",
                  quoted(robot.prefix), quoted(published), quoted(found)));
}

/// `named` against what is described.
std::optional<SettingFault> compare(const arm::ArmModel& named, const arm::ArmModel& described,
                                    std::vector<std::string>& warnings) {
  if (named.name() != described.name()) {
    return SettingFault{
        "robot_model",
        fmt::format("is {}, but robot_description describes a {}", named.name(), described.name()),
        "the same model in both, or an empty robot_model to use robot_description"};
  }
  if (!isOfSameGeometry(named, described)) {
    warnings.push_back(
        fmt::format("robot_model is {}, so its nominal lengths and limits are used, but those of "
                    "robot_description differ: leave robot_model empty to use robot_description",
                    named.name()));
  }
  return std::nullopt;
}

ArmResult describedArm(const RobotParameters& robot, const Given& description,
                       std::vector<std::string>& warnings) {
  const auto* urdf = std::get_if<std::string>(&description.value);
  if (urdf == nullptr) {
    return refuse(SettingFault{"robot_model", "is empty, and robot_description is " + describe(description),
                               kDescriptions});
  }
  auto arm = arm::ArmModel::fromUrdf(*urdf);
  if (!arm) {
    return refuse(SettingFault{"robot_model",
                               "is empty, and robot_description cannot be used: " + arm.error().message,
                               kDescriptions});
  }
  compareNames(robot, *arm, warnings);
  return Arm(std::move(*arm));
}

ArmResult namedArm(const RobotParameters& robot, const std::optional<Given>& description,
                   std::vector<std::string>& warnings) {
  auto named = arm::ArmModel::named(robot.robot_model);
  if (!named) {
    return refuse(SettingFault{"robot_model", "cannot be used: " + named.error().message, "a known model"});
  }
  const auto* urdf = description ? std::get_if<std::string>(&description->value) : nullptr;
  const auto described = arm::ArmModel::fromUrdf(urdf == nullptr ? std::string() : *urdf);
  if (described) {
    if (auto fault = compare(*named, *described, warnings)) return refuse(*fault);
    compareNames(robot, *described, warnings);
  }
  return Arm(std::move(*named));
}

}  // namespace

Setting robotModelRow(std::string& robot_model) {
  using namespace setting_kinds;
  return {"robot_model", text(robot_model, orEmpty(oneOf(arm::ArmModel::knownNames()))),
          "arm model for planning and checks; empty: the model of `robot_description`; if that is missing "
          "too, moves are sent unplanned"};
}

Setting prefixRow(std::string& prefix) {
  using namespace setting_kinds;
  const TextRule rule{"letters, digits, _, -, . and /, not beginning with /", arm::isNamePrefix};
  return {"prefix", text(prefix, orEmpty(rule)), "prefix of joint and frame names"};
}

ArmResult armOf(const RobotParameters& robot, const std::optional<Given>& robot_description,
                std::vector<std::string>& warnings) {
  if (!robot.robot_model.empty()) return namedArm(robot, robot_description, warnings);
  if (robot_description) return describedArm(robot, *robot_description, warnings);
  return Arm();
}

}  // namespace cobot_command::ros_adapter
