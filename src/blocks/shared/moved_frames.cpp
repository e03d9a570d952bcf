#include "shared/moved_frames.h"

#include <utility>

#include "shared/framed_pose.h"
#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/common/units.h"

namespace cobot_command::blocks {
namespace {

// More than tf and a localisation that stands still tremble, less than a gripper forgives.
constexpr double kMovedDistance = 1e-3;          // [m]
constexpr double kMovedAngle = 0.1 * kPi / 180;  // [rad]

}  // namespace

std::optional<Failure> findMovedFrame(const char* field, const std::optional<FramedPose>& pose,
                                      const FrameFinder& finder) {
  if (!finder || !pose || !pose->latest) return std::nullopt;
  const std::string frame = printableFrame(*pose);
  const auto now = finder(pose->frame);
  if (!now || !now->matrix().allFinite()) {
    return Failure{own_error::kFrameUnknown,
                   fmt::format("{} is in \"{}\", which is no longer known", field, frame), ""};
  }
  FramedPose moved = *pose;
  moved.frame_in_robot_base = now;
  const arm::Pose change = inRobotBase(*pose).inverse() * inRobotBase(moved);
  const double distance = change.translation().norm();
  const double angle = Eigen::AngleAxisd(change.linear()).angle();
  if (distance <= kMovedDistance && angle <= kMovedAngle) return std::nullopt;
  return Failure{own_error::kFrameMoved,
                 fmt::format("{} is in \"{}\": since the goal arrived it has moved by {:.1f} mm and {:.1f} "
                             "degrees in the robot base",
                             field, frame, mToMm(distance), radToDeg(angle)),
                 ""};
}

}  // namespace cobot_command::blocks
