#include "points/point_motion.h"

#include <type_traits>
#include <utility>
#include <variant>

#include "motion_refusal.h"
#include "points/target_joints.h"
#include <fmt/format.h>

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/arm/pose_bits.h"
#include "cobot_command/common/units.h"
#include "cobot_command/motion/planner.h"

namespace cobot_command::path {
namespace {

PathRefusal toRefusal(motion::Refusal why, int index, const PathScene& scene) {
  PathRefusal made{errorIdOf(why.reason), index, why.joint, std::move(why.message)};
  if (made.error_id != path_error::kNotPlannable && made.error_id != path_error::kTargetPose) {
    made.where = why.point;
  }
  const bool is_of_its_pace =
      made.error_id == path_error::kJointSpeed || made.error_id == path_error::kNotPlannable;
  if (is_of_its_pace) made.found += textOfFeedrate(scene.feedrate);
  return made;
}

/// The same way at the pace of the feedrate.
motion::Command atFeedrate(const PlannedPoint& point, double feedrate) {
  motion::Command command = point.command;
  std::visit(
      [&](auto& move) {
        using Move = std::decay_t<decltype(move)>;
        if constexpr (std::is_same_v<Move, motion::JointMove>) {
          move.rates = jointRates(point.dynamics, feedrate);
        } else if constexpr (std::is_same_v<Move, motion::StraightMove> ||
                             std::is_same_v<Move, motion::ArcMove> ||
                             std::is_same_v<Move, motion::WristMove>) {
          move.rates = pathRates(point.dynamics, point.point.profile_type, feedrate);
        }
      },
      command);
  return command;
}

class PointPlanner {
 public:
  PointPlanner(const PathPoint& point, int index, const Target& target, const Dynamics& dynamics,
               const arm::JointVector& start, const PathScene& scene)
      : point_(point), index_(index), target_(target), dynamics_(dynamics), start_(start), scene_(scene) {}

  [[nodiscard]] Result<PointMotion, PathRefusal> plan() const {
    if (is(point_.interpolation, Interpolation::Ptp)) {
      return withJoints([&](const arm::JointVector& joints) -> motion::Command {
        return motion::JointMove{joints, motion::Rates(jointRates(dynamics_, scene_.feedrate)),
                                 rampShape(dynamics_, point_.profile_type)};
      });
    }
    if (const int joint = scene_.arm.firstJointOutsideLimits(start_); joint >= 0) {
      return refuse(startOutside(joint));
    }
    if (is(point_.interpolation, Interpolation::Wrist)) {
      return withJoints([&](const arm::JointVector& joints) -> motion::Command {
        return motion::WristMove{joints, rates()};
      });
    }
    return alongACurve();
  }

 private:
  using Made = Result<PointMotion, PathRefusal>;

  [[nodiscard]] PathRefusal refusal(int error_id, std::string found, int joint = -1) const {
    return {error_id, index_, joint, std::move(found)};
  }
  [[nodiscard]] motion::PathRates rates() const {
    return pathRates(dynamics_, point_.profile_type, scene_.feedrate);
  }

  template <class MakeCommand>
  [[nodiscard]] Made withJoints(const MakeCommand& command) const {
    const auto joints = jointsOf(point_, index_, target_, start_, scene_);
    if (!joints) return refuse(joints.error());
    return made(command(*joints));
  }

  /// A line or an arc, which keeps the posture of its start.
  [[nodiscard]] Made alongACurve() const {
    const bool is_pose = std::holds_alternative<arm::Pose>(target_.place);
    arm::Pose to;
    auto bits = askedBits(point_);
    if (is_pose) {
      to = std::get<arm::Pose>(target_.place);
    } else {
      const auto joints = jointsOf(point_, index_, target_, start_, scene_);
      if (!joints) return refuse(joints.error());
      to = arm::forwardKinematics(scene_.arm, *joints) * target_.moved_frame;
      bits = arm::poseBitsOf(scene_.arm, *joints);
    }
    auto planned = is(point_.interpolation, Interpolation::Circular)
                       ? made(motion::ArcMove{via(), to, rates()})
                       : made(motion::StraightMove{to, rates()});
    const arm::PoseBits own = arm::poseBitsOf(scene_.arm, start_);
    const bool can_go = planned || planned.error().error_id == path_error::kJointSpeed;
    if (!can_go || !bits || *bits == own) return planned;
    PathRefusal other = refusal(path_error::kOtherConfiguration,
                                fmt::format("the target has {}, the start {}, which a line and an arc keep: "
                                            "choose another target, PTP or CP_WRIST",
                                            arm::toString(*bits), arm::toString(own)));
    other.where = to;
    return refuse(std::move(other));
  }

  [[nodiscard]] arm::Pose via() const {
    arm::Pose via = arm::Pose::Identity();
    via.translation() = target_.via;
    return via;
  }

  [[nodiscard]] Made made(const motion::Command& command) const {
    motion::Setting setting;
    setting.tcp = target_.moved_frame;
    auto planned = motion::plan(scene_.arm, start_, command, setting);
    if (!planned) return refuse(toRefusal(std::move(planned.error()), index_, scene_));
    return PointMotion{command, *planned};
  }

  // --- Refusals.

  [[nodiscard]] PathRefusal startOutside(int joint) const {
    const arm::JointLimit& limit = scene_.arm.limits()[static_cast<std::size_t>(joint)];
    return refusal(
        path_error::kStartJoints,
        fmt::format("the move starts with J{} at {:.2f} deg, allowed {:.1f}..{:.1f} deg: move back inside by "
                    "a PTP first",
                    joint + 1, radToDeg(start_[joint]), radToDeg(limit.lower), radToDeg(limit.upper)),
        joint);
  }

  const PathPoint& point_;
  int index_;
  const Target& target_;
  const Dynamics& dynamics_;
  const arm::JointVector& start_;
  const PathScene& scene_;
};

}  // namespace

Result<PointMotion, PathRefusal> planPoint(const PathPoint& point, int index, const Target& target,
                                           const Dynamics& dynamics, const arm::JointVector& start,
                                           const PathScene& scene) {
  return PointPlanner(point, index, target, dynamics, start, scene).plan();
}

Result<PointMotion, PathRefusal> planAgain(const PlannedPoint& point, const arm::JointVector& start,
                                           const PathScene& scene) {
  const motion::Command command = atFeedrate(point, scene.feedrate);
  motion::Setting setting;
  setting.tcp = point.moved_frame;
  auto planned = motion::plan(scene.arm, start, command, setting);
  if (!planned) return refuse(toRefusal(std::move(planned.error()), point.index, scene));
  return PointMotion{command, *planned};
}

}  // namespace cobot_command::path
