#include "target_joints.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/arm/inverse_kinematics.h"
#include "cobot_command/arm/wrist_inverse.h"
#include "cobot_command/common/units.h"

namespace cobot_command::path {
namespace {

int idOf(arm::IkRefusal::Reason reason) {
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

class TargetJoints {
 public:
  TargetJoints(const PathPoint& point, int index, const Target& target, const arm::JointVector& start,
               const PathScene& scene)
      : point_(point), index_(index), target_(target), start_(start), scene_(scene) {}

  [[nodiscard]] Result<arm::JointVector, PathRefusal> find() const {
    return std::visit([&](const auto& place) { return jointsAt(place); }, target_.place);
  }

 private:
  [[nodiscard]] PathRefusal refusal(int error_id, std::string found, int joint = -1) const {
    return {error_id, index_, joint, std::move(found)};
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

  const PathPoint& point_;
  int index_;
  const Target& target_;
  const arm::JointVector& start_;
  const PathScene& scene_;
};

}  // namespace

Result<arm::JointVector, PathRefusal> jointsOf(const PathPoint& point, int index, const Target& target,
                                               const arm::JointVector& start, const PathScene& scene) {
  return TargetJoints(point, index, target, start, scene).find();
}

}  // namespace cobot_command::path
