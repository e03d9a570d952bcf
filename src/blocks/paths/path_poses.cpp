// A path whose targets are poses in any frame: one point, the template, becomes a point for each of them.

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "shared/framed_pose.h"
#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/common/units.h"
#include "cobot_command/path/path_planner.h"

namespace cobot_command::blocks {
namespace {

using path::is;
using path::PathPoint;
using path::PathRefusal;

template <class Numbers>
bool isZero(const Numbers& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double number) { return number == 0.0; });
}

/// What nobody could mean along with poses; empty: nothing. JOINT and WORLD are 0, what a field says that
/// nobody has set: they count as that.
std::string surpriseIn(const PathPoint& model) {
  if (is(model.move_type, path::MoveType::Incremental)) {
    return "its move_type is INCREMENTAL, allowed: ABSOLUTE 0: poses are absolute positions";
  }
  if (is(model.target_type, path::TargetType::Hybrid)) {
    return "its target_point_type is HYBRID, allowed: CARTESIAN 1: poses also give the orientation of the "
           "wrist";
  }
  if (!isZero(model.pose) || !isZero(model.joints)) {
    return "it has a target of its own in pose or joints, allowed: zeros: poses give the targets";
  }
  if (is(model.interpolation, path::Interpolation::Circular)) {
    return "its interpolation_type is CP_CIRCULAR, allowed: PTP 0, CP_LINEAR 1, CP_WRIST 2: an arc needs a "
           "via_pose for each pose; give such points in path";
  }
  if (is(model.ref_frame_type, path::Reference::User)) {
    return "its ref_frame_type is USER, allowed: ROBOT 1: poses give their frame in frame_id; give poses in "
           "a user frame as points in path";
  }
  return "";
}

/// 0 would be told as the number of the goal.
bool hasRoom(int move_id, std::size_t count) {
  const std::int64_t last = std::int64_t{move_id} + static_cast<std::int64_t>(count) - 1;
  return move_id == 0 || (last <= std::numeric_limits<int>::max() && (move_id > 0 || last < 0));
}

PathRefusal unsuitable(std::string found) {
  return {own_error::kPoseTemplate, -1, -1, std::move(found)};
}

/// What is wrong before any pose is looked at.
std::optional<PathRefusal> faultOfAll(const std::vector<PathPoint>& path, std::size_t count) {
  if (count > path::kMostPoints) {
    return PathRefusal{path::path_error::kMovesExceedArray, -1, -1,
                       fmt::format("poses has {}, allowed: 1 to {}: divide them among several goals", count,
                                   path::kMostPoints)};
  }
  if (path.size() != 1) {
    return unsuitable(
        fmt::format("poses has {}, and path {} points, allowed: exactly one, the template of all poses: give "
                    "it, or leave poses empty",
                    count, path.size()));
  }
  if (const std::string surprise = surpriseIn(path.front()); !surprise.empty()) {
    return unsuitable("path[0] is the template of the poses, and " + surprise);
  }
  if (!hasRoom(path.front().move_id, count)) {
    return unsuitable(fmt::format(
        "path[0] is the template of the poses, and its move_id is {}, to which each of the {} poses adds its "
        "index; allowed: 0, or a value for which no sum is 0 or above {}: choose another one",
        path.front().move_id, count, std::numeric_limits<int>::max()));
  }
  return std::nullopt;
}

/// Numbers that are none of their enumeration stay, for the checks of points.
PathPoint withoutTarget(PathPoint model) {
  if (is(model.target_type, path::TargetType::Joint)) {
    model.target_type = static_cast<int>(path::TargetType::Cartesian);
  }
  if (is(model.ref_frame_type, path::Reference::World)) {
    model.ref_frame_type = static_cast<int>(path::Reference::Robot);
  }
  return model;
}

PathRefusal wrong(int error_id, std::size_t index, std::string found) {
  return {error_id, static_cast<int>(index), -1, std::move(found)};
}

std::optional<PathRefusal> place(PathPoint& point, std::size_t index, const FramedPose& pose) {
  if (!hasKnownFrame(pose)) {
    return wrong(
        path::path_error::kWorldUnknown, index,
        fmt::format("its pose is {}; allowed: a frame that tf connects with the robot base: publish it, "
                    "or give the pose in another one",
                    frameInWords(pose)));
  }
  if (!isFinite(pose)) {
    return wrong(path::path_error::kTargetPose, index,
                 "a number of its pose is not finite, allowed: finite numbers: correct the pose");
  }
  if (!isOfUnitLength(pose)) {
    return wrong(path::path_error::kTargetPose, index,
                 fmt::format("the quaternion of its pose has length {}, allowed: 1, within {}: normalise it; "
                             "0, 0, 0, 1 means no rotation",
                             lengthOfQuaternion(pose), kUnitLengthTolerance));
  }
  const arm::Pose in_robot_base = inRobotBase(pose);
  const double furthest = in_robot_base.translation().cwiseAbs().maxCoeff();
  constexpr double kFurthest = mmToM(arm::kMaxCoordinate);
  if (!(furthest <= kFurthest)) {
    return wrong(
        path::path_error::kTargetPose, index,
        fmt::format("its pose is {} m from the robot base, allowed: up to {:.0f} m along each axis: give "
                    "a pose that the arm can reach, in metres",
                    furthest, kFurthest));
  }
  point.pose = arm::toControllerPose(in_robot_base);
  return std::nullopt;
}

}  // namespace

void placeAtPoses(LoadPathGoal& goal, std::size_t count,
                  const std::function<FramedPose(std::size_t index)>& pose_at) {
  goal.poses_fault = faultOfAll(goal.path, count);
  if (goal.poses_fault) {
    goal.path.clear();
    return;
  }
  const PathPoint model = withoutTarget(goal.path.front());
  goal.path.assign(count, model);
  const int size = static_cast<int>(count);
  const bool is_inside =
      goal.start_index >= 0 && goal.start_index < size && goal.number_of_moves <= size - goal.start_index;
  if (!is_inside) return;  // it is refused for that alone
  for (int i = goal.start_index; i < goal.start_index + goal.number_of_moves && !goal.poses_fault; ++i) {
    const auto index = static_cast<std::size_t>(i);
    if (model.move_id != 0) goal.path[index].move_id = model.move_id + i;
    goal.poses_fault = place(goal.path[index], index, pose_at(index));
  }
}

}  // namespace cobot_command::blocks
