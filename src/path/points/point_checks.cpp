#include "points/point_checks.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "points/target.h"
#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/units.h"

namespace cobot_command::path {
namespace {

using Finding = std::optional<PathRefusal>;

PathRefusal refusal(int error_id, int index, std::string found, int joint = -1) {
  return {error_id, index, joint, std::move(found)};
}

/// One of 0..last.
Finding checkNumber(int error_id, int index, const char* field, int found, int last, const char* meaning) {
  if (found >= 0 && found <= last) return std::nullopt;
  return refusal(error_id, index,
                 fmt::format("{} is {}, allowed: {}: choose one of these", field, found, meaning));
}

Finding checkTolerance(const PathPoint& point, int index) {
  if (!is(point.termination_type, Termination::Blend)) return std::nullopt;
  if (!(point.command_tolerance >= 0.0) || std::isinf(point.command_tolerance)) {
    return refusal(
        path_error::kTolerance, index,
        fmt::format("command_tolerance is {}, allowed: finite, and 0 or above: choose one in this range",
                    point.command_tolerance));
  }
  if (is(point.interpolation, Interpolation::Ptp) && point.command_tolerance > 100.0) {
    return refusal(
        path_error::kPtpTolerance, index,
        fmt::format(
            "command_tolerance is {} % of the path of a PTP, allowed: 0 to 100 %: choose one in this range",
            point.command_tolerance));
  }
  return std::nullopt;
}

Finding checkTermination(const PathPoint& point, int index) {
  if (is(point.termination_type, Termination::Stop) || is(point.termination_type, Termination::Blend)) {
    return std::nullopt;
  }
  return refusal(path_error::kTermination, index,
                 fmt::format("termination_type is {}, allowed: STOP 0, BLEND 6: choose one of these",
                             point.termination_type));
}

Finding checkPoseType(const PathPoint& point, int index) {
  if (!hasMovedFrame(point) || is(point.pose_type, MovedFrame::Flange) ||
      is(point.pose_type, MovedFrame::Tool)) {
    return std::nullopt;
  }
  return refusal(
      path_error::kPoseType, index,
      fmt::format("pose_type is {}, allowed: FLANGE 2, TOOL 3: choose one of these", point.pose_type));
}

Finding checkReference(const PathPoint& point, int index) {
  if (!hasReference(point) || is(point.ref_frame_type, Reference::World) ||
      is(point.ref_frame_type, Reference::Robot) || is(point.ref_frame_type, Reference::User)) {
    return std::nullopt;
  }
  return refusal(path_error::kReference, index,
                 fmt::format("ref_frame_type is {}, allowed: WORLD 0, ROBOT 1, USER 4: choose one of these",
                             point.ref_frame_type));
}

Finding checkIndex(int error_id, int index, const char* field, int found) {
  if (tables::isIndex(found)) return std::nullopt;
  return refusal(error_id, index,
                 fmt::format("{} is {}, allowed: 0 to 15: choose one in this range", field, found));
}

Finding checkConfigured(int error_id, int index, const Result<arm::Pose, tables::Gap>& entry,
                        const char* table) {
  if (entry || entry.error().reason != tables::Gap::Reason::NotConfigured) return std::nullopt;
  return refusal(error_id, index,
                 fmt::format("{}: write it into the table of {}", entry.error().found, table));
}

bool usesTool(const PathPoint& point) {
  return hasMovedFrame(point) && is(point.pose_type, MovedFrame::Tool);
}
bool usesFrame(const PathPoint& point) {
  return hasReference(point) && is(point.ref_frame_type, Reference::User);
}

Finding checkEntries(const PathPoint& point, int index, const tables::DataTables* tables) {
  Finding found;
  if (usesTool(point)) found = checkIndex(path_error::kToolIndex, index, "pose_id", point.pose_id);
  if (!found && usesFrame(point)) {
    found = checkIndex(path_error::kFrameIndex, index, "ref_frame_id", point.ref_frame_id);
  }
  if (tables == nullptr) return found;
  if (!found && usesTool(point)) {
    found =
        checkConfigured(path_error::kToolNotConfigured, index, tables->toolInFlange(point.pose_id), "tools");
  }
  if (!found && usesFrame(point)) {
    found = checkConfigured(path_error::kFrameNotConfigured, index,
                            tables->frameInRobotBase(point.ref_frame_id), "frames");
  }
  return found;
}

Finding checkNumbers(int index, const char* field, const double* numbers, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (std::abs(numbers[i]) <= arm::kMaxCoordinate) continue;
    return refusal(
        path_error::kTargetPose, index,
        fmt::format("{}[{}] is {}, allowed: finite numbers up to +-{:.0f}: choose one in this range", field,
                    i, numbers[i], arm::kMaxCoordinate));
  }
  return std::nullopt;
}

Finding checkDisabledJoints(const PathPoint& point, int index) {
  if (is(point.target_type, TargetType::Cartesian)) return std::nullopt;
  for (int joint = 6; joint < 9; ++joint) {
    const double found = point.joints[static_cast<std::size_t>(joint)];
    if (found == 0.0) continue;
    return refusal(path_error::kDisabledJoint, index,
                   fmt::format("joints[{}] is {}: this robot has six joints, the others must be 0: make it 0",
                               joint, found),
                   joint);
  }
  return std::nullopt;
}

Finding checkIncrement(const PathPoint& point, int index) {
  if (!is(point.move_type, MoveType::Incremental) || !hasReference(point)) return std::nullopt;
  if (!usesTool(point) && !usesFrame(point)) return std::nullopt;
  return refusal(
      path_error::kIncrementInFrame, index,
      fmt::format("an increment with {}: allowed with FLANGE in WORLD or ROBOT: give the target as "
                  "ABSOLUTE",
                  usesTool(point) ? "a tool" : "a user frame"));
}

}  // namespace

bool hasPose(const PathPoint& point) {
  return !is(point.target_type, TargetType::Joint);
}

bool hasReference(const PathPoint& point) {
  return hasPose(point) || is(point.interpolation, Interpolation::Circular);
}

bool hasMovedFrame(const PathPoint& point) {
  return hasPose(point) || !is(point.interpolation, Interpolation::Ptp);
}

Finding checkPoint(const PathPoint& point, int index, const tables::DataTables* tables) {
  Finding found =
      checkNumber(path_error::kMoveType, index, "move_type", point.move_type, 1, "ABSOLUTE 0, INCREMENTAL 1");
  if (!found) {
    found = checkNumber(path_error::kTargetType, index, "target_point_type", point.target_type, 2,
                        "JOINT 0, CARTESIAN 1, HYBRID 2");
  }
  if (!found) {
    found = checkNumber(path_error::kInterpolation, index, "interpolation_type", point.interpolation, 3,
                        "PTP 0, CP_LINEAR 1, CP_WRIST 2, CP_CIRCULAR 3");
  }
  if (!found) found = checkTolerance(point, index);
  if (!found) found = checkTermination(point, index);
  if (!found) {
    found = checkNumber(path_error::kProfile, index, "profile_type", point.profile_type, 3,
                        "S_CURVE 0, POLY5 1, MOD_SINE 2, SINE2 3");
  }
  if (!found) {
    found = checkNumber(path_error::kConfiguration, index, "robot_configuration", point.robot_configuration,
                        15, "0 to 15");
  }
  if (!found && is(point.target_type, TargetType::Hybrid) && is(point.move_type, MoveType::Absolute)) {
    found = checkFlip(point, index, degToRad(point.joints[4]));
  }
  if (!found) found = checkPoseType(point, index);
  if (!found) found = checkReference(point, index);
  if (!found) found = checkEntries(point, index, tables);
  return found;
}

Finding checkTarget(const PathPoint& point, int index) {
  Finding found = checkIncrement(point, index);
  if (!found && hasPose(point)) {
    const std::size_t used = is(point.target_type, TargetType::Hybrid) ? 3 : 6;
    found = checkNumbers(index, "pose", point.pose.data(), used);
  }
  if (!found && !is(point.target_type, TargetType::Cartesian)) {
    const std::size_t first = is(point.target_type, TargetType::Hybrid) ? 3 : 0;
    found = checkNumbers(index, "joints", point.joints.data() + first, 6 - first);
  }
  if (!found && is(point.interpolation, Interpolation::Circular)) {
    found = checkNumbers(index, "via_pose", point.via_pose.data(), 3);
  }
  if (!found) found = checkDisabledJoints(point, index);
  return found;
}

}  // namespace cobot_command::path
