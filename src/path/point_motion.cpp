#include "point_motion.h"

#include <utility>

#include <fmt/format.h>

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/arm/inverse_kinematics.h"
#include "cobot_command/arm/wrist_inverse.h"
#include "cobot_command/common/units.h"
#include "cobot_command/motion/planner.h"

namespace cobot_command::path {
namespace {

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
    const auto joints = targetJoints();
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
      const auto joints = targetJoints();
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
    return refuse(refusal(path_error::kOtherConfiguration,
                          fmt::format("the target has {}, the start {}, which a line and an arc keep: choose "
                                      "another target, PTP or CP_WRIST",
                                      arm::toString(*bits), arm::toString(own))));
  }

  [[nodiscard]] arm::Pose via() const { return target_.reference * arm::toPose(point_.via_pose); }

  [[nodiscard]] Made made(const motion::Command& command) const {
    motion::Setting setting;
    setting.tcp = target_.moved_frame;
    auto planned = motion::plan(scene_.arm, start_, command, setting);
    if (!planned) return refuse(toRefusal(std::move(planned.error())));
    return PointMotion{command, *planned};
  }

  // --- The joints of the target.

  [[nodiscard]] Result<arm::JointVector, PathRefusal> targetJoints() const {
    return std::visit([&](const auto& place) { return jointsAt(place); }, target_.place);
  }
  [[nodiscard]] Result<arm::JointVector, PathRefusal> jointsAt(const arm::JointVector& joints) const {
    const int joint = scene_.arm.firstJointOutsideLimits(joints);
    if (joint < 0) return joints;
    const arm::JointLimit& limit = scene_.arm.limits()[static_cast<std::size_t>(joint)];
    return refuse(
        refusal(path_error::kJointTarget,
                fmt::format("the target has J{} at {:.2f} deg, allowed {:.1f}..{:.1f} deg: choose a "
                            "target inside the limits",
                            joint + 1, radToDeg(joints[joint]), radToDeg(limit.lower), radToDeg(limit.upper)),
                joint));
  }
  [[nodiscard]] Result<arm::JointVector, PathRefusal> jointsAt(const arm::Pose& pose) const {
    const arm::Pose flange = pose * target_.moved_frame.inverse();
    auto bits = askedBits(point_);
    auto joints =
        arm::postureFor(scene_.arm, flange, bits ? *bits : arm::poseBitsOf(scene_.arm, start_), start_);
    if (joints) return *joints;
    return refuse(refusal(idOf(joints.error().reason), joints.error().message, joints.error().joint));
  }
  [[nodiscard]] Result<arm::JointVector, PathRefusal> jointsAt(const HybridTarget& target) const {
    if (auto wrong = checkFlip(point_, index_, target.wrist[1])) return refuse(*std::move(wrong));
    const arm::WristArm arm(scene_.arm, target_.moved_frame);
    const auto branch = branchFor(arm, target);
    if (!branch) return refuse(branch.error());
    const auto joints = arm.solve(target.wrist, target.origin, *branch, start_);
    if (!joints) return refuse(noSolution());
    return withinLimits(*joints);
  }
  /// The one that is asked for; else that of the start.
  [[nodiscard]] Result<arm::WristBranch, PathRefusal> branchFor(const arm::WristArm& arm,
                                                                const HybridTarget& target) const {
    const arm::WristSolutions solutions = arm.solutions(target.wrist, target.origin);
    if (solutions.empty()) {
      return refuse(
          refusal(path_error::kReach,
                  "no posture with these J4 to J6 brings the moved frame there: choose another place, "
                  "or another wrist"));
    }
    const auto bits = askedBits(point_);
    if (!bits) return arm.branchOf(start_);
    for (const arm::WristSolution& solution : solutions) {
      const arm::PoseBits found = arm::poseBitsOf(scene_.arm, solution.joints);
      if (found.shoulder == bits->shoulder && found.elbow == bits->elbow) return solution.branch;
    }
    return refuse(noSolution());
  }
  [[nodiscard]] PathRefusal noSolution() const {
    const auto bits = askedBits(point_);
    return refusal(
        path_error::kNoSolution,
        fmt::format("the target can be reached, but not with {}: choose another configuration, or "
                    "another place",
                    bits ? arm::toString(*bits) : "the shoulder and elbow of the target before it"));
  }
  [[nodiscard]] Result<arm::JointVector, PathRefusal> withinLimits(const arm::JointVector& joints) const {
    arm::JointVector near = start_;
    near.tail<3>() = joints.tail<3>();  // these are as they were asked for
    const auto turned = arm::nearestTurn(scene_.arm, joints, near);
    if (turned && turned->tail<3>() == joints.tail<3>()) return *turned;
    const int joint = scene_.arm.firstJointOutsideLimits(joints);
    return refuse(
        refusal(path_error::kJointLimit,
                fmt::format("the target needs J{} at {:.2f} deg, which is outside its limits: choose "
                            "another target",
                            joint + 1, radToDeg(joints[std::max(joint, 0)])),
                joint));
  }

  // --- Refusals.

  [[nodiscard]] PathRefusal startOutside(int joint) const {
    return refusal(
        path_error::kStartJoints,
        fmt::format("the move starts with J{} at {:.2f} deg, outside its limits: go back inside by a "
                    "PTP first",
                    joint + 1, radToDeg(start_[joint])),
        joint);
  }
  [[nodiscard]] static int idOf(arm::IkRefusal::Reason reason) {
    using Reason = arm::IkRefusal::Reason;
    switch (reason) {
      case Reason::NotFinite:
        return path_error::kTargetPose;
      case Reason::OutOfReach:
        return path_error::kReach;
      case Reason::BitsNotPossible:
        return path_error::kNoSolution;
      case Reason::OutsideLimits:
        return path_error::kJointLimit;
    }
    return path_error::kNoSolution;
  }
  [[nodiscard]] PathRefusal toRefusal(motion::Refusal why) const {
    PathRefusal made = refusal(idOf(why.reason), std::move(why.message), why.joint);
    made.where = why.point;
    return made;
  }
  [[nodiscard]] static int idOf(motion::Refusal::Reason reason) {
    using Reason = motion::Refusal::Reason;
    switch (reason) {
      case Reason::NotFinite:
      case Reason::DegenerateCircle:
        return path_error::kTargetPose;
      case Reason::Unreachable:
        return path_error::kReach;
      case Reason::PoseBits:
        return path_error::kOtherConfiguration;
      case Reason::JointLimit:
        return path_error::kJointLimit;
      case Reason::JointSpeed:
        return path_error::kJointSpeed;
      case Reason::Singular:
        return path_error::kSingular;
      case Reason::AmbiguousTurn:
      case Reason::BadParameter:
        break;
    }
    return path_error::kNotPlannable;
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

}  // namespace cobot_command::path
