#include "cobot_command/robot/arrival.h"

#include <algorithm>
#include <type_traits>
#include <variant>

#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/common/units.h"

namespace cobot_command::robot {
namespace {

/// What the tool of a calibrated arm may be from where the nominal model has it: captures of real ones show 1
/// to 6 mm (TM 4.1).
constexpr ArrivalLimits kCalibration{0.010, degToRad(1.0)};
/// An arm that is no further from its model than this is not calibrated, or simulated: 32-bit floats of mm
/// and deg.
constexpr ArrivalLimits kNominal{1e-4, degToRad(0.05)};

struct Distance {
  double position = 0;  ///< [m]
  double angle = 0;     ///< [rad]
};

Distance between(const arm::Pose& a, const arm::Pose& b) {
  const Eigen::AngleAxisd turn(a.linear().transpose() * b.linear());
  return {(a.translation() - b.translation()).norm(), std::abs(turn.angle())};
}

arm::Pose toolAt(const arm::ArmModel& arm, const arm::JointVector& joints, const arm::Pose& tcp) {
  return arm::forwardKinematics(arm, joints) * tcp;
}

Gap jointGap(const arm::JointVector& wanted, const arm::JointVector& found, double limit) {
  Eigen::Index joint = 0;
  const double gap = (found - wanted).cwiseAbs().maxCoeff(&joint);
  return {gap <= limit, fmt::format("J{} is {:.2f} deg from its target", joint + 1, radToDeg(gap))};
}

/// The frame's tool is where the model has it with the frame's joints.
bool isNominal(const link::RobotStatus& status, const Target& target, const arm::ArmModel& arm) {
  if (!status.joints || !status.tool) return false;
  const Distance error = between(*status.tool, toolAt(arm, *status.joints, target.tcp));
  return error.position <= kNominal.position && error.angle <= kNominal.angle;
}

std::optional<Gap> toolGap(const Target& target, const link::RobotStatus& status, const arm::ArmModel& arm,
                           ArrivalLimits limits) {
  if (!status.joints && !status.tool) return std::nullopt;
  const bool exact = status.tool && target.kind == TargetKind::Pose;
  if (!exact && !isNominal(status, target, arm)) {
    limits.position += kCalibration.position;
    limits.angle += kCalibration.angle;
  }
  const arm::Pose found = status.tool ? *status.tool : toolAt(arm, *status.joints, target.tcp);
  const Distance gap = between(found, toolAt(arm, target.joints, target.tcp));
  return Gap{gap.position <= limits.position && gap.angle <= limits.angle,
             fmt::format("the TCP is {:.2f} mm and {:.2f} deg from its target", mToMm(gap.position),
                         radToDeg(gap.angle))};
}

TargetKind kindOf(script::DataFormat::Target target, TargetKind cartesian) {
  return target == script::DataFormat::Target::Joint ? TargetKind::Joints : cartesian;
}

template <class Command>
constexpr bool kIsAbsolute = std::is_same_v<Command, script::Ptp> || std::is_same_v<Command, script::Line> ||
                             std::is_same_v<Command, script::PLine>;
template <class Command>
constexpr bool kIsRelative =
    std::is_same_v<Command, script::MovePtp> || std::is_same_v<Command, script::MoveLine> ||
    std::is_same_v<Command, script::MovePLine>;

template <class Command>
std::optional<TargetKind> targetKindOf(const Command& command) {
  if constexpr (kIsAbsolute<Command>) {
    return kindOf(command.format.target, TargetKind::Pose);
  } else if constexpr (kIsRelative<Command>) {
    return kindOf(command.format.target, TargetKind::Offset);
  } else if constexpr (std::is_same_v<Command, script::Circle>) {
    return command.arc_angle == 0 ? TargetKind::Pose : TargetKind::Offset;
  } else if constexpr (std::is_same_v<Command, script::PvtEnter>) {
    return command.cartesian ? TargetKind::Pose : TargetKind::Joints;
  } else {
    return std::nullopt;
  }
}

/// Whatever was queued before it leaves the robot somewhere on its way.
bool stops(const script::ScriptCommand& command) {
  return std::holds_alternative<script::StopAndClearBuffer>(command);
}

}  // namespace

std::optional<TargetKind> targetKindOf(const std::vector<script::ScriptCommand>& commands) {
  std::optional<TargetKind> last;
  for (const auto& command : commands) {
    const auto kind = std::visit([](const auto& c) { return targetKindOf(c); }, command);
    if (kind || stops(command)) last = kind;
  }
  return last;
}

std::optional<Target> jointTargetOf(const std::vector<script::ScriptCommand>& commands) {
  std::optional<Target> last;
  for (const auto& command : commands) {
    const auto* ptp = std::get_if<script::Ptp>(&command);
    if (ptp != nullptr && ptp->format.target == script::DataFormat::Target::Joint) {
      // Where it began is not known, so that it may be there.
      last = Target{TargetKind::Joints, arm::toJointVector(ptp->target), arm::Pose::Identity(), true};
    } else if (stops(command) || std::visit([](const auto& c) { return targetKindOf(c); }, command)) {
      last.reset();
    }
  }
  return last;
}

std::optional<Gap> gapTo(const Target& target, const link::RobotStatus& status, const arm::ArmModel* arm,
                         const ArrivalLimits& limits) {
  if (target.kind != TargetKind::Joints) {
    return arm != nullptr ? toolGap(target, status, *arm, limits) : std::nullopt;
  }
  if (!status.joints) return std::nullopt;
  return jointGap(target.joints, *status.joints, limits.angle);
}

}  // namespace cobot_command::robot
