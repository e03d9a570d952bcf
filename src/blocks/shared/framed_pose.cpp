#include "shared/framed_pose.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/units.h"

namespace cobot_command::blocks {
namespace {

template <std::size_t N>
bool areFinite(const std::array<double, N>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

Eigen::Quaterniond quaternionOf(const FramedPose& pose) {
  const auto& [x, y, z, w] = pose.quaternion;
  return {w, x, y, z};
}

}  // namespace

bool hasKnownFrame(const FramedPose& pose) {
  return pose.frame_in_robot_base && pose.frame_in_robot_base->matrix().allFinite();
}

std::string frameInWords(const FramedPose& pose) {
  return fmt::format("in \"{}\"{}{}", printableFrame(pose), pose.fault.empty() ? "" : ": ",
                     foreignText(pose.fault));
}

bool isFinite(const FramedPose& pose) {
  return areFinite(pose.position) && areFinite(pose.quaternion);
}

double lengthOfQuaternion(const FramedPose& pose) {
  return quaternionOf(pose).norm();
}

bool isOfUnitLength(const FramedPose& pose) {
  return std::abs(lengthOfQuaternion(pose) - 1) <= kUnitLengthTolerance;
}

std::string printableFrame(const FramedPose& pose) {
  return foreignText(pose.frame, kQuoteLimit);
}

arm::Pose inRobotBase(const FramedPose& pose) {
  assert(pose.frame_in_robot_base);
  arm::Pose in_frame = arm::Pose::Identity();
  in_frame.translation() << pose.position[0], pose.position[1], pose.position[2];
  in_frame.linear() = quaternionOf(pose).normalized().toRotationMatrix();
  return *pose.frame_in_robot_base * in_frame;
}

void checkPose(ParameterChecks& checks, const char* field, const FramedPose& pose) {
  const bool frame_known = hasKnownFrame(pose);
  checks.require(frame_known, own_error::kFrameUnknown, fmt::format("{} is {}", field, frameInWords(pose)));
  if (!isFinite(pose)) {
    checks.require(false, own_error::kNotFinite, fmt::format("a number of {} is not finite", field));
    return;
  }
  const bool unit = isOfUnitLength(pose);
  checks.require(unit, own_error::kQuaternion,
                 fmt::format("that of {} has length {}", field, lengthOfQuaternion(pose)));
  if (!frame_known || !unit) return;
  const double furthest = mToMm(inRobotBase(pose).translation().cwiseAbs().maxCoeff());
  checks.require(isWithin(furthest, 0, arm::kMaxCoordinate), own_error::kCoordinateRange,
                 fmt::format("{} is {} mm from the robot base", field, furthest));
}

SixValues seenFrom(const arm::Pose& base, const FramedPose& pose) {
  return arm::toControllerPose(base.inverse() * inRobotBase(pose));
}

SixValues targetOf(const SixValues& values, const std::optional<FramedPose>& pose, const arm::Pose& base) {
  return pose ? seenFrom(base, *pose) : values;
}

}  // namespace cobot_command::blocks
