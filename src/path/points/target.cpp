#include "points/target.h"

#include "points/point_checks.h"
#include <fmt/format.h>

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/common/units.h"

namespace cobot_command::path {
namespace {

Result<arm::Pose, PathRefusal> known(Result<arm::Pose, tables::Gap> entry, int error_id, int index) {
  if (entry) return *entry;
  return refuse(PathRefusal{error_id, index, -1,
                            entry.error().found + ": write its value into the table, or have it streamed"});
}

Result<arm::Pose, PathRefusal> movedFrame(const PathPoint& point, int index, const PathScene& scene) {
  if (is(point.pose_type, MovedFrame::Flange)) return arm::Pose(arm::Pose::Identity());
  return known(scene.tables.toolInFlange(point.pose_id), path_error::kToolUnknown, index);
}

Result<arm::Pose, PathRefusal> reference(const PathPoint& point, int index, const PathScene& scene) {
  if (is(point.ref_frame_type, Reference::User)) {
    return known(scene.tables.frameInRobotBase(point.ref_frame_id), path_error::kFrameUnknown, index);
  }
  if (is(point.ref_frame_type, Reference::Robot)) return arm::Pose(arm::Pose::Identity());
  if (scene.world) return *scene.world;
  return refuse(PathRefusal{path_error::kWorldUnknown, index, -1,
                            "the target is in WORLD, and tf has no transform from the robot base to the "
                            "world: publish it, or give the target in ROBOT or USER"});
}

constexpr int kInWorld = 1;

/// Equal where the same is meant: tool 0 is the flange, user frame 0 the robot base.
std::array<int, 4> framesOf(const PathPoint& point) {
  const bool has_tool = is(point.pose_type, MovedFrame::Tool) && point.pose_id != 0;
  const bool has_frame = is(point.ref_frame_type, Reference::User) && point.ref_frame_id != 0;
  const bool in_world = is(point.ref_frame_type, Reference::World);
  return {has_tool ? 1 : 0, has_tool ? point.pose_id : 0, has_frame ? 2 : (in_world ? kInWorld : 0),
          has_frame ? point.ref_frame_id : 0};
}

arm::ControllerPose numbersOf(const Previous& previous, const PathPoint& point, const Target& target,
                              const arm::Pose& reference, const PathScene& scene) {
  if (previous.written && previous.written->frames == framesOf(point)) return previous.written->numbers;
  const arm::Pose flange = arm::forwardKinematics(scene.arm, previous.joints);
  return arm::toControllerPose(reference.inverse() * flange * target.moved_frame);
}

arm::ControllerPose sum(arm::ControllerPose a, const arm::ControllerPose& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
  return a;
}

arm::JointVector jointsOf(const PathPoint& point, const Previous& previous) {
  arm::JointVector joints;
  for (Eigen::Index i = 0; i < joints.size(); ++i) {
    joints[i] = degToRad(point.joints[static_cast<std::size_t>(i)]);
  }
  if (is(point.move_type, MoveType::Incremental)) joints += previous.joints;
  return joints;
}

void placeAt(Target& target, const arm::Pose& reference, const arm::ControllerPose& numbers,
             const PathPoint& point, const Previous& previous) {
  const arm::Pose pose = reference * arm::toPose(numbers);
  if (is(point.target_type, TargetType::Cartesian)) {
    target.place = pose;
    target.written = Previous::Written{framesOf(point), numbers};
  } else {
    target.place = HybridTarget{pose.translation(), jointsOf(point, previous).tail<3>()};
  }
}

}  // namespace

Result<Target, PathRefusal> targetOf(const PathPoint& point, int index, const Previous& previous,
                                     const PathScene& scene) {
  Target target;
  if (hasMovedFrame(point)) {
    auto moved = movedFrame(point, index, scene);
    if (!moved) return refuse(std::move(moved.error()));
    target.moved_frame = *moved;
  }
  if (!hasPose(point)) target.place = jointsOf(point, previous);
  if (!hasReference(point)) return target;
  auto from = reference(point, index, scene);
  if (!from) return refuse(std::move(from.error()));
  const bool adds = is(point.move_type, MoveType::Incremental);
  const arm::ControllerPose before =
      adds ? numbersOf(previous, point, target, *from, scene) : arm::ControllerPose{};
  if (hasPose(point)) placeAt(target, *from, sum(point.pose, before), point, previous);
  const arm::ControllerPose via = sum(point.via_pose, before);
  target.via = *from * Eigen::Vector3d(mmToM(via[0]), mmToM(via[1]), mmToM(via[2]));
  return target;
}

bool isInWorld(const Previous::Written& written) {
  return written.frames[2] == kInWorld;
}

std::optional<arm::PoseBits> askedBits(const PathPoint& point) {
  const int value = point.robot_configuration;
  if ((value & 1) == 0) return std::nullopt;
  const int lefty = (value >> 1) & 1;
  const int above = (value >> 2) & 1;
  const int flip = (value >> 3) & 1;
  return arm::PoseBits::fromNumbers(lefty, 3 - above, 4 + flip);
}

std::optional<PathRefusal> checkFlip(const PathPoint& point, int index, double j5) {
  const auto bits = askedBits(point);
  if (!bits) return std::nullopt;
  const bool righty = bits->shoulder == arm::Shoulder::Righty;
  const bool is_noflip = righty ? j5 > 0.0 : j5 < 0.0;
  const bool asks_noflip = bits->wrist == arm::Wrist::NoFlip;
  if (is_noflip == asks_noflip) return std::nullopt;
  return PathRefusal{
      path_error::kConfiguration, index, -1,
      fmt::format(
          "robot_configuration {} requests {}, and J5 = {:.3f} deg means {}: make both agree, or clear bit 0",
          point.robot_configuration, arm::toString(*bits), radToDeg(j5), is_noflip ? "NOFLIP" : "FLIP")};
}

}  // namespace cobot_command::path
