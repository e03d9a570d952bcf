#include "cobot_command/planning/script_motion.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/units.h"

namespace cobot_command::planning {
namespace {

using script::DataFormat;
using Made = Result<motion::Command, motion::Refusal>;

Duration timeToTopSpeed(const script::MotionOptions& options) {
  return std::chrono::milliseconds(options.accel_time);
}

double ratio(const script::MotionOptions& options) {
  return options.speed / 100.0;
}

motion::PathSpeed pathSpeed(const DataFormat& format, const script::MotionOptions& options) {
  if (format.speed == DataFormat::Speed::Percent) return motion::SpeedRatio{ratio(options)};
  return motion::TcpSpeed{mmToM(options.speed)};
}

motion::PoseOffset poseOffset(const DataFormat& format, const script::SixNumbers& offset) {
  using Axes = motion::PoseOffset::Axes;
  return {arm::toPose(offset), format.target == DataFormat::Target::Tool ? Axes::Tool : Axes::Base};
}

motion::Refusal unknownBits(const std::array<int, 3>& bits, const arm::Pose& point) {
  motion::Refusal refusal;
  refusal.reason = motion::Refusal::Reason::PoseBits;
  refusal.at = 1.0;
  refusal.point = point;
  refusal.message = fmt::format(
      "pose configuration {}, {}, {}; allowed are 0..1, 2..3, 4..5: choose one of them each, or give none",
      bits[0], bits[1], bits[2]);
  return refusal;
}

}  // namespace

Made toMotion(const script::Ptp& ptp) {
  if (ptp.format.target == DataFormat::Target::Joint) {
    return motion::Ptp{arm::toJointVector(ptp.target), ratio(ptp.options), timeToTopSpeed(ptp.options)};
  }
  motion::PoseTarget target{arm::toPose(ptp.target), std::nullopt};
  if (ptp.pose_bits) {
    const auto& [config1, config2, config3] = *ptp.pose_bits;
    target.bits = arm::PoseBits::fromNumbers(config1, config2, config3);
    if (!target.bits) return refuse(unknownBits(*ptp.pose_bits, target.pose));
  }
  return motion::Ptp{target, ratio(ptp.options), timeToTopSpeed(ptp.options)};
}

Made toMotion(const script::Line& line) {
  return motion::Line{arm::toPose(line.target), pathSpeed(line.format, line.options),
                      timeToTopSpeed(line.options)};
}

Made toMotion(const script::Circle& circle) {
  std::optional<double> angle;
  if (circle.arc_angle != 0) angle = degToRad(circle.arc_angle);
  return motion::Circle{arm::toPose(circle.via), arm::toPose(circle.end), angle,
                        pathSpeed(circle.format, circle.options), timeToTopSpeed(circle.options)};
}

Made toMotion(const script::MovePtp& move) {
  motion::MovePtp made{poseOffset(move.format, move.offset), ratio(move.options),
                       timeToTopSpeed(move.options)};
  if (move.format.target == DataFormat::Target::Joint) made.offset = arm::toJointVector(move.offset);
  return made;
}

Made toMotion(const script::MoveLine& move) {
  return motion::MoveLine{poseOffset(move.format, move.offset), pathSpeed(move.format, move.options),
                          timeToTopSpeed(move.options)};
}

Made toMotion(const script::PLine& line) {
  motion::PLine made{arm::toPose(line.target), pathSpeed(line.format, line.options),
                     timeToTopSpeed(line.options)};
  if (line.format.target == DataFormat::Target::Joint) made.target = arm::toJointVector(line.target);
  return made;
}

Made toMotion(const script::MovePLine& move) {
  motion::MovePLine made{poseOffset(move.format, move.offset), pathSpeed(move.format, move.options),
                         timeToTopSpeed(move.options)};
  if (move.format.target == DataFormat::Target::Joint) made.offset = arm::toJointVector(move.offset);
  return made;
}

Made toMotion(const PvtBlock& pvt) {
  if (!pvt.cartesian) {
    std::vector<motion::PvtJointPoint> points;
    for (const script::PvtPoint& point : pvt.points) {
      points.push_back(
          {arm::toJointVector(point.position), arm::toJointVector(point.velocity), point.duration});
    }
    return motion::Pvt{std::move(points)};
  }
  std::vector<motion::PvtPosePoint> points;
  for (const script::PvtPoint& point : pvt.points) {
    const auto& [x, y, z, rx, ry, rz] = point.velocity;
    points.push_back({arm::toPose(point.position),
                      {{mmToM(x), mmToM(y), mmToM(z)}, {degToRad(rx), degToRad(ry), degToRad(rz)}},
                      point.duration});
  }
  return motion::Pvt{std::move(points)};
}

Made toMotion(const ScriptMotion& any) {
  return std::visit([](const auto& one) { return toMotion(one); }, any);
}

std::optional<motion::Blend> blendOf(const ScriptMotion& motion) {
  return std::visit(
      [](const auto& one) -> std::optional<motion::Blend> {
        if constexpr (std::is_same_v<decltype(one), const PvtBlock&>) {
          return std::nullopt;
        } else {
          if (one.options.blending <= 0) return std::nullopt;
          const bool radius = one.format.blending == DataFormat::Blending::Radius;
          if (radius) return motion::BlendRadius{mmToM(one.options.blending)};
          return motion::BlendShare{std::min(one.options.blending / 100.0, 1.0)};
        }
      },
      motion);
}

}  // namespace cobot_command::planning
