#include "kinds/relative_motion.h"

#include "cobot_command/arm/forward_kinematics.h"

namespace cobot_command::motion {
namespace {

arm::Pose displaced(const PoseOffset& offset, const arm::ArmModel& arm, const arm::JointVector& start,
                    const Setting& setting) {
  const arm::Pose tool = setting.base.inverse() * arm::forwardKinematics(arm, start) * setting.tcp;
  if (offset.axes == PoseOffset::Axes::Tool) {
    return tool * offset.by;
  }
  arm::Pose target = tool;
  target.translation() += offset.by.translation();
  target.linear() = offset.by.linear() * tool.linear();
  return target;
}

}  // namespace

Ptp absolute(const MovePtp& move, const arm::ArmModel& arm, const arm::JointVector& start,
             const Setting& setting) {
  Ptp ptp;
  ptp.speed_ratio = move.speed_ratio;
  ptp.time_to_top_speed = move.time_to_top_speed;
  if (const auto* joints = std::get_if<arm::JointVector>(&move.offset)) {
    ptp.target = arm::JointVector(start + *joints);
  } else {
    ptp.target = PoseTarget{displaced(std::get<PoseOffset>(move.offset), arm, start, setting), std::nullopt};
  }
  return ptp;
}

Line absolute(const MoveLine& move, const arm::ArmModel& arm, const arm::JointVector& start,
              const Setting& setting) {
  return {displaced(move.offset, arm, start, setting), move.speed, move.time_to_top_speed};
}

PLine absolute(const MovePLine& move, const arm::ArmModel& arm, const arm::JointVector& start,
               const Setting& setting) {
  PLine line;
  line.speed = move.speed;
  line.time_to_top_speed = move.time_to_top_speed;
  if (const auto* joints = std::get_if<arm::JointVector>(&move.offset)) {
    line.target = arm::JointVector(start + *joints);
  } else {
    line.target = displaced(std::get<PoseOffset>(move.offset), arm, start, setting);
  }
  return line;
}

}  // namespace cobot_command::motion
