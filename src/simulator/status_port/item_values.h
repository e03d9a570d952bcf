// Values of items out of the state of the robot, in the units of the controller.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "robot/project_data.h"
#include "robot/tool_twist.h"

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/protocol/item_content.h"
#include "cobot_command/simulator/robot_state.h"
#include "cobot_command/simulator/settings.h"

namespace cobot_command::simulator {

/// All that the items are made from.
struct ItemSource {
  const arm::ArmModel& arm;
  const Settings& settings;
  const RobotState& state;
  const FaultSwitch& hidden;  ///< its text names items that are not there
  const ProjectData& project;
};

using Floats = std::vector<float>;

/// Poses as the controller tells them, each converted once: without a tool and a base, items tell the same
/// one again and again.
class ToldPoses {
 public:
  [[nodiscard]] Floats told(const arm::Pose& pose);  ///< [mm, deg]

 private:
  struct Told {
    arm::Pose pose;
    SixFloats numbers;
  };
  std::array<Told, 6> known_;
  std::size_t count_ = 0;
};

/// The source, and what several items need of it, computed once.
struct ItemValues {
  explicit ItemValues(const ItemSource& from);

  const ItemSource& source;
  const RobotState& state;
  arm::Pose robot_tool;  ///< the TCP in the robot base [m]
  Twist tool_twist;
  mutable ToldPoses poses{};  ///< remembers, and tells nothing else for that
};

/// Each times a unit's size.
[[nodiscard]] Floats floats(const Eigen::Ref<const Eigen::VectorXd>& numbers, double factor = 1.0);
[[nodiscard]] Floats inertiaMoments(const script::ToolInertia& inertia);  ///< [kg mm^2]
[[nodiscard]] Floats massCenter(const script::ToolInertia& inertia);      ///< [mm, deg]
[[nodiscard]] Floats degrees(const arm::JointVector& joints);             ///< [deg] or [deg/s]
[[nodiscard]] Floats twistFloats(const Twist& twist);                     ///< [mm/s, deg/s]
/// Six rows of offset, alpha, a, d, type, lower and upper limit [mm, deg].
[[nodiscard]] Floats dhTable(const arm::ArmModel& arm);
/// One number of each joint's limits [deg, deg/s].
[[nodiscard]] Floats jointLimits(const arm::ArmModel& arm, double arm::JointLimit::*number);
/// The same, where the settings have no other angles for the safety functions.
[[nodiscard]] Floats safetyLimits(const ItemSource& source, double arm::JointLimit::*number);
[[nodiscard]] int robotLight(const RobotState& state);
[[nodiscard]] std::string upperCase(std::string text);

}  // namespace cobot_command::simulator
