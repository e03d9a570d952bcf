#include "moved_frames.h"

#include <utility>

#include "framed_pose.h"
#include <fmt/format.h>

#include "cobot_command/blocks/error_ids.h"
#include "cobot_command/common/overloaded.h"
#include "cobot_command/common/units.h"

namespace cobot_command::blocks {
namespace {

// More than tf and a localisation that stands still tremble, less than a gripper forgives.
constexpr double kMovedDistance = 1e-3;          // [m]
constexpr double kMovedAngle = 0.1 * kPi / 180;  // [rad]

std::optional<Failure> find(const char* field, const std::optional<FramedPose>& pose,
                            const FrameFinder& finder) {
  if (!finder || !pose || !pose->latest) return std::nullopt;
  const std::string frame = printableFrame(*pose);
  const auto now = finder(pose->frame);
  if (!now || !now->matrix().allFinite()) {
    return Failure{own_error::kFrameUnknown,
                   fmt::format("{} is in \"{}\", which is not known any more", field, frame), ""};
  }
  FramedPose moved = *pose;
  moved.frame_in_robot_base = now;
  const arm::Pose change = inRobotBase(*pose).inverse() * inRobotBase(moved);
  const double distance = change.translation().norm();
  const double angle = Eigen::AngleAxisd(change.linear()).angle();
  if (distance <= kMovedDistance && angle <= kMovedAngle) return std::nullopt;
  return Failure{own_error::kFrameMoved,
                 fmt::format("{} is in \"{}\": since the goal came it has moved by {:.1f} mm and {:.1f} "
                             "degrees in the robot base",
                             field, frame, mToMm(distance), radToDeg(angle)),
                 ""};
}

std::optional<Failure> findIn(const MoveCircleGoal& goal, const FrameFinder& finder) {
  if (auto moved = find("arc_pose", goal.arc_pose, finder)) return moved;
  return find("end_pose", goal.end_pose, finder);
}

}  // namespace

std::optional<Failure> findMovedFrame(const MoveAbsoluteGoal& goal, const FrameFinder& finder) {
  return find("target_pose", goal.target_pose, finder);
}

std::optional<Outcome> refusalOfMovedFrame(const Goal& goal, const FrameFinder& finder) {
  if (const auto* cycle = std::get_if<PickAndPlaceGoal>(&goal)) {
    for (std::size_t i = 0; i < cycle->steps.size(); ++i) {
      if (const auto moved = findMovedFrame(cycle->steps[i].move, finder)) {
        const Outcome own = toRejection(Block::MoveAbsolute, {*moved});
        return toRejection(Block::PickAndPlace, {stepRefused(i, cycle->steps.size(), own)});
      }
    }
    return std::nullopt;
  }
  using Found = std::optional<Failure>;
  const Found moved =
      std::visit(Overloaded{[&](const MoveAbsoluteGoal& g) { return findMovedFrame(g, finder); },
                            [&](const MoveCircleGoal& g) { return findIn(g, finder); },
                            [&](const ChangeBaseGoal& g) { return find("base_pose", g.base_pose, finder); },
                            [](const auto&) -> Found { return std::nullopt; }},
                 goal);
  if (!moved) return std::nullopt;
  return toRejection(blockOf(goal), {*moved});
}

}  // namespace cobot_command::blocks
