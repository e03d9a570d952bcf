// Arms and tables that are easily written down.
#pragma once

#include <limits>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/units.h"
#include "cobot_command/tables/data_tables.h"

namespace cobot_command::kinematics {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInf = std::numeric_limits<double>::infinity();

/// SRCI oracle 19, and section 5.2 of what is known of the robot.
inline constexpr arm::ControllerJoints kJoints = {30, -20, 100, 10, 80, -45};
inline constexpr arm::ControllerPose kPoseOf700 = {330.992, 27.191, 397.019, -172.893, 7.053, 165.439};

inline arm::ArmModel model(const std::string& name) {
  auto found = arm::ArmModel::named(name);
  if (!found) throw std::runtime_error(found.error().message);
  return *found;
}

/// The same arm with other limits of one joint, as a planner may be given.
inline arm::ArmModel narrowed(const std::string& name, const std::string& joint, double lower_deg,
                              double upper_deg) {
  std::string urdf = arm::ArmModel::urdfOf(name);
  const std::size_t at = urdf.find("<limit", urdf.find("<joint name=\"" + joint + "\""));
  const std::size_t end = urdf.find("/>", at);
  const auto of = [&](const char* attribute) {
    const std::size_t from = urdf.find(attribute, at);
    return urdf.substr(from, urdf.find('"', urdf.find('"', from) + 1) + 1 - from);
  };
  if (at == std::string::npos) throw std::runtime_error("no joint " + joint);
  const std::string limit = "<limit " + of("effort=") + " " + of("velocity=") + " lower=\"" +
                            std::to_string(degToRad(lower_deg)) + "\" upper=\"" +
                            std::to_string(degToRad(upper_deg)) + "\"";
  urdf.replace(at, end - at, limit);
  auto found = arm::ArmModel::fromUrdf(urdf);
  if (!found) throw std::runtime_error(found.error().message);
  return *found;
}

/// Tool 1 is 150 mm long, tool 2 the project's; frame 1 is turned, frame 2 stands in it, frame 3 is the
/// project's, frame 4 stands in that one.
inline tables::DataTables someTables() {
  tables::Entries entries;
  entries.tools[1] = tables::Tool{"", arm::toPose({0, 0, 150, 0, 0, 30}), 0};
  entries.tools[2] = tables::Tool{"gripper", std::nullopt, 0};
  entries.frames[1] = tables::Frame{"", arm::toPose({100, -200, 50, 10, 0, 90}), 0};
  entries.frames[2] = tables::Frame{"", arm::toPose({0, 0, 25, 0, 0, 180}), 1};
  entries.frames[3] = tables::Frame{"table", std::nullopt, 0};
  auto tables = tables::DataTables::of(entries, {});
  if (!tables) throw std::runtime_error(describe(tables.error()));
  return *tables;
}

/// Postures all over the ranges, the same ones in every run.
class RandomJoints {
 public:
  explicit RandomJoints(const arm::ArmModel& arm) : arm_(arm) {}

  arm::ControllerJoints next() {
    arm::ControllerJoints joints{};
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const arm::JointLimit& limit = arm_.limits()[i];
      joints[i] =
          std::uniform_real_distribution<double>(radToDeg(limit.lower), radToDeg(limit.upper))(generator_);
    }
    return joints;
  }
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(generator_); }

 private:
  const arm::ArmModel& arm_;
  std::mt19937_64 generator_{20240607};
};

}  // namespace cobot_command::kinematics
