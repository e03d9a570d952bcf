#include "status_port/item_values.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "cobot_command/common/units.h"

namespace cobot_command::simulator {

namespace {

template <class Numbers>
Floats floatsOf(const Numbers& numbers) {
  Floats floats;
  floats.reserve(std::size(numbers));
  for (const double number : numbers) floats.push_back(static_cast<float>(number));
  return floats;
}

}  // namespace

ItemValues::ItemValues(const ItemSource& from)
    : source(from),
      state(from.state),
      robot_tool(state.flange * state.tcp),
      tool_twist(toolTwist(from.arm, from.state)) {}

Floats floats(const Eigen::Ref<const Eigen::VectorXd>& numbers, double factor) {
  Floats floats;
  floats.reserve(static_cast<std::size_t>(numbers.size()));
  for (const double number : numbers) floats.push_back(static_cast<float>(factor * number) + 0.0F);  // no -0
  return floats;
}

Floats ToldPoses::told(const arm::Pose& pose) {
  // 0 and -0 are not the same: they may turn by 180 and by -180 degrees.
  const auto are_the_same = [](double a, double b) { return a == b && std::signbit(a) == std::signbit(b); };
  const auto is_the_same = [&](const Told& known) {
    const double* numbers = pose.data();
    return std::equal(numbers, numbers + pose.matrix().size(), known.pose.data(), are_the_same);
  };
  const auto end = known_.begin() + static_cast<std::ptrdiff_t>(count_);
  auto found = std::find_if(known_.begin(), end, is_the_same);
  if (found == end) {
    if (count_ < known_.size()) {
      ++count_;
    } else {
      --found;
    }
    *found = Told{pose, toFloats(pose)};
  }
  return {found->numbers.begin(), found->numbers.end()};
}

Floats inertiaMoments(const script::ToolInertia& inertia) {
  return floatsOf(inertia.moment);
}

Floats massCenter(const script::ToolInertia& inertia) {
  return floatsOf(inertia.mass_center);
}

Floats degrees(const arm::JointVector& joints) {
  Floats floats;
  floats.reserve(arm::kJointCount);
  for (const double joint : joints) floats.push_back(static_cast<float>(radToDeg(joint)));
  return floats;
}

Floats twistFloats(const Twist& twist) {
  Floats floats;
  floats.reserve(static_cast<std::size_t>(twist.size()));
  for (int i = 0; i < 6; ++i) {
    floats.push_back(static_cast<float>(i < 3 ? mToMm(twist[i]) : radToDeg(twist[i])));
  }
  return floats;
}

Floats dhTable(const arm::ArmModel& arm) {
  const arm::DhLengths& l = arm.lengths();
  const std::array<std::array<double, 4>, arm::kJointCount> rows{{{0, -90, 0, l.d1},
                                                                  {-90, 0, l.a2, 0},
                                                                  {0, 0, l.a3, 0},
                                                                  {90, 90, 0, l.d4},
                                                                  {0, 90, 0, l.d5},
                                                                  {0, 0, 0, l.d6}}};
  Floats table;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const arm::JointLimit& limit = arm.limits()[i];
    for (const double number : {rows[i][0], rows[i][1], mToMm(rows[i][2]), mToMm(rows[i][3]), 0.0,
                                radToDeg(limit.lower), radToDeg(limit.upper)}) {
      table.push_back(static_cast<float>(number));
    }
  }
  return table;
}

Floats jointLimits(const arm::ArmModel& arm, double arm::JointLimit::*number) {
  Floats floats;
  for (const arm::JointLimit& limit : arm.limits()) {
    floats.push_back(static_cast<float>(radToDeg(limit.*number)));
  }
  return floats;
}

Floats safetyLimits(const ItemSource& source, double arm::JointLimit::*number) {
  Floats floats = jointLimits(source.arm, number);
  for (const auto& [joint, limit] : source.settings.safety_limits) {
    floats.at(joint) = static_cast<float>(radToDeg(limit.*number));
  }
  return floats;
}

int robotLight(const RobotState& state) {
  constexpr int kOff = 0;
  constexpr struct { int standby, running, error; } kAutomatic{3, 4, 9}, kManual{5, 6, 10};
  if (state.emergency_stop) return kOff;
  const auto& lights = state.mode == OperatingMode::Manual ? kManual : kAutomatic;
  if (state.error) return lights.error;
  return state.project_running ? lights.running : lights.standby;
}

std::string upperCase(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
  return name;
}

}  // namespace cobot_command::simulator
