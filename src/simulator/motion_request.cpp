#include "motion_request.h"

#include <chrono>
#include <optional>

#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/common/units.h"

namespace cobot_command::simulator {

namespace {

using Target = protocol::DataFormat::Target;
using Made = Result<motion::Command, motion::Refusal>;

Duration accelerationTime(const protocol::MotionOptions& options) {
  return std::chrono::milliseconds(options.accel_time);
}

double ratio(const protocol::MotionOptions& options) {
  return options.speed / 100.0;
}

motion::PathSpeed pathSpeed(const protocol::DataFormat& format, const protocol::MotionOptions& options) {
  if (format.speed == protocol::DataFormat::Speed::Percent) return motion::SpeedRatio{ratio(options)};
  return motion::TcpSpeed{mmToM(options.speed)};
}

class Converter {
 public:
  Converter(const arm::ArmModel& arm, const arm::JointVector& start, const motion::Setting& setting)
      : arm_(arm), start_(start), setting_(setting) {}

  Made operator()(const protocol::Ptp& ptp) const {
    if (ptp.format.target == Target::Joint) {
      return motion::Ptp{arm::toJointVector(ptp.target), ratio(ptp.options), accelerationTime(ptp.options)};
    }
    motion::PoseTarget target{arm::toPose(ptp.target), std::nullopt};
    if (ptp.pose_bits) {
      const auto& [config1, config2, config3] = *ptp.pose_bits;
      target.bits = arm::PoseBits::fromNumbers(config1, config2, config3);
      if (!target.bits) return refuse(unknownBits(*ptp.pose_bits, target.pose));
    }
    return motion::Ptp{target, ratio(ptp.options), accelerationTime(ptp.options)};
  }

  Made operator()(const protocol::Line& line) const {
    return motion::Line{arm::toPose(line.target), pathSpeed(line.format, line.options),
                        accelerationTime(line.options)};
  }

  Made operator()(const protocol::Circle& circle) const {
    std::optional<double> angle;
    if (circle.arc_angle != 0) angle = degToRad(circle.arc_angle);
    return motion::Circle{arm::toPose(circle.via), arm::toPose(circle.end), angle,
                          pathSpeed(circle.format, circle.options), accelerationTime(circle.options)};
  }

  Made operator()(const protocol::MovePtp& move) const {
    const double speed = ratio(move.options);
    const Duration acceleration = accelerationTime(move.options);
    if (move.format.target == Target::Joint) {
      return motion::Ptp{arm::JointVector(start_ + arm::toJointVector(move.offset)), speed, acceleration};
    }
    return motion::Ptp{motion::PoseTarget{shifted(move.format, move.offset), std::nullopt}, speed,
                       acceleration};
  }

  Made operator()(const protocol::MoveLine& move) const {
    return motion::Line{shifted(move.format, move.offset), pathSpeed(move.format, move.options),
                        accelerationTime(move.options)};
  }

 private:
  [[nodiscard]] arm::Pose shifted(const protocol::DataFormat& format,
                                  const protocol::SixNumbers& offset) const {
    const arm::Pose tool = setting_.base.inverse() * arm::forwardKinematics(arm_, start_) * setting_.tcp;
    const arm::Pose by = arm::toPose(offset);
    if (format.target == Target::Tool) return tool * by;
    arm::Pose target = tool;
    target.translation() += by.translation();
    target.linear() = by.linear() * tool.linear();
    return target;
  }

  static motion::Refusal unknownBits(const std::array<int, 3>& bits, const arm::Pose& point) {
    motion::Refusal refusal;
    refusal.reason = motion::Refusal::Reason::PoseBits;
    refusal.point = point;
    refusal.message =
        fmt::format("pose configuration {}, {}, {}; allowed are 0..1, 2..3, 4..5", bits[0], bits[1], bits[2]);
    return refusal;
  }

  const arm::ArmModel& arm_;
  const arm::JointVector& start_;
  const motion::Setting& setting_;
};

}  // namespace

Made toCommand(const MotionRequest& request, const arm::ArmModel& arm, const arm::JointVector& start,
               const motion::Setting& setting) {
  return std::visit(Converter(arm, start, setting), request);
}

}  // namespace cobot_command::simulator
