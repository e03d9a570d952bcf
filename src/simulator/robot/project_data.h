// What the project holds that scripts and clients of the status port can read and change: bases, TCPs, points
// and variables.
#pragma once

#include <array>
#include <map>
#include <string>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/types.h"
#include "cobot_command/common/result.h"
#include "cobot_command/simulator/settings.h"
#include "cobot_command/tm_script/variables.h"

namespace cobot_command::simulator {

using SixFloats = std::array<float, 6>;

/// X Y Z [mm] RX RY RZ [deg], as the controller keeps them.
[[nodiscard]] SixFloats toFloats(const arm::Pose& pose);

/// A pose, and its numbers as they were written.
struct Frame {
  explicit Frame(const arm::Pose& from) : pose(from), numbers(toFloats(from)) {}
  explicit Frame(const SixFloats& from);

  arm::Pose pose;  ///< [m]
  SixFloats numbers;
};
struct Tool {
  Frame frame{arm::Pose::Identity()};
  float mass = 0;                 ///< [kg]
  std::array<float, 3> moment{};  ///< [kg mm^2]
  SixFloats mass_center{};        ///< as a Frame has it
};
struct Point {
  Frame frame{arm::Pose::Identity()};  ///< of the TCP in the robot base
  std::array<int, 3> pose_bits{};
  SixFloats flange{};  ///< as a Frame has it
};

template <class T>
struct Taught {
  explicit Taught(const T& value, bool fixed = false) : now(value), taught(value), is_fixed(fixed) {}

  T now;
  T taught;
  bool is_fixed = false;  ///< scripts cannot change it
};

/// Adds the variable that a text like "int var_i = 5" declares, and gives its name; or says why it declares
/// none.
[[nodiscard]] Result<std::string, std::string> declare(tm_script::Variables& variables,
                                                       const std::string& declaration);

struct ProjectData {
  ProjectData(const Settings& settings, const arm::ArmModel& model);

  /// As the project is at its start. Global variables keep their values.
  void beginAnew();

  std::map<std::string, Taught<Frame>> bases;
  std::map<std::string, Taught<Tool>> tools;
  std::map<std::string, Taught<Point>> points;
  tm_script::Variables variables;
  std::map<std::string, tm_script::Value> declared;  ///< what the variables are at the start
};

/// "a, b", for messages.
template <class Map>
[[nodiscard]] std::string namesOf(const Map& map) {
  std::string names;
  for (const auto& entry : map) names += (names.empty() ? "" : ", ") + entry.first;
  return names.empty() ? "none" : names;
}

}  // namespace cobot_command::simulator
