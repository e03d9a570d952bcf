#include "points/target_joints.h"

#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/arm/forward_kinematics.h"
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
    PathRefusal made =
        refusal(path_error::kJointTarget,
                fmt::format("the target has J{} at {:.2f} deg, allowed {:.1f}..{:.1f} deg: choose "
                            "another target",
                            joint + 1, radToDeg(joints[joint]), radToDeg(limit.lower), radToDeg(limit.upper)),
                joint);
    made.where = arm::forwardKinematics(scene_.arm, joints) * target_.moved_frame;
    return refuse(std::move(made));
  }
  [[nodiscard]] Result<arm::JointVector, PathRefusal> jointsAt(const arm::Pose& pose) const {
    const arm::Pose flange = pose * target_.moved_frame.inverse();
    auto bits = askedBits(point_);
    auto joints =
        arm::postureFor(scene_.arm, flange, bits ? *bits : arm::poseBitsOf(scene_.arm, start_), start_);
    if (joints) return *joints;
    PathRefusal made = refusal(idOf(joints.error().reason), joints.error().message, joints.error().joint);
    made.where = pose;
    return refuse(std::move(made));
  }
  [[nodiscard]] Result<arm::JointVector, PathRefusal> jointsAt(const HybridTarget& target) const {
    if (auto wrong = checkFlip(point_, index_, target.wrist[1])) return refuse(*std::move(wrong));
    const arm::WristArm arm(scene_.arm, target_.moved_frame);
    const arm::WristSolutions solutions = arm.solutions(target.wrist, target.origin);
    if (solutions.empty()) {
      return refuse(at(target, refusal(path_error::kReach,
                                       "no posture with these J4 to J6 brings the moved frame there: choose "
                                       "another place, or another wrist")));
    }
    const auto joints = best(arm, target, solutions);
    if (!joints) return refuse(at(target, noSolution()));
    return withinLimits(*joints, target);
  }
  /// Of those that are asked for: a wrist move can go only to the branch of its start, all else to the
  /// nearest.
  [[nodiscard]] std::optional<arm::JointVector> best(const arm::WristArm& arm, const HybridTarget& target,
                                                     const arm::WristSolutions& solutions) const {
    const bool keeps_branch = is(point_.interpolation, Interpolation::Wrist);
    const arm::WristBranch own = arm.branchOf(start_);
    std::optional<arm::JointVector> found;
    double least = 0.0;
    for (const arm::WristSolution& solution : solutions) {
      const bool is_own = keeps_branch && solution.branch == own;
      if (!isAsked(solution.joints, is_own)) continue;
      auto joints = arm.solve(target.wrist, target.origin, solution.branch, start_);
      if (!joints) continue;
      if (is_own) return joints;
      const double way = (*joints - start_).head<3>().cwiseAbs().maxCoeff();
      if (!found || way < least) {
        found = joints;
        least = way;
      }
    }
    return found;
  }
  /// By shoulder and elbow; without a configuration those of the start, or its branch.
  [[nodiscard]] bool isAsked(const arm::JointVector& joints, bool is_own_branch) const {
    const auto bits = askedBits(point_);
    if (!bits && is(point_.interpolation, Interpolation::Wrist)) return is_own_branch;
    const arm::PoseBits asked = bits ? *bits : arm::poseBitsOf(scene_.arm, start_);
    const arm::PoseBits found = arm::poseBitsOf(scene_.arm, joints);
    return found.shoulder == asked.shoulder && found.elbow == asked.elbow;
  }
  /// Of the orientation nothing is known.
  [[nodiscard]] static PathRefusal at(const HybridTarget& target, PathRefusal refusal) {
    refusal.where = arm::Pose(Eigen::Translation3d(target.origin));
    return refusal;
  }
  [[nodiscard]] PathRefusal noSolution() const {
    const auto bits = askedBits(point_);
    return refusal(
        path_error::kNoSolution,
        fmt::format("the target can be reached, but not with {}: choose another configuration, or "
                    "another place",
                    bits ? arm::toString(*bits) : "the shoulder and elbow of the target before it"));
  }
  [[nodiscard]] Result<arm::JointVector, PathRefusal> withinLimits(const arm::JointVector& joints,
                                                                   const HybridTarget& target) const {
    arm::JointVector near = start_;
    near.tail<3>() = joints.tail<3>();  // these are as they were asked for
    const auto turned = arm::nearestTurn(scene_.arm, joints, near);
    if (turned && turned->tail<3>() == joints.tail<3>()) return *turned;
    int joint = 0;
    while (joint < 5 && hasPlace(joints[joint], joint)) ++joint;
    const arm::JointLimit& limit = scene_.arm.limits()[static_cast<std::size_t>(joint)];
    return refuse(at(
        target,
        refusal(path_error::kJointLimit,
                fmt::format("the target needs J{} at {:.2f} deg, allowed {:.1f}..{:.1f} deg: "
                            "choose another target",
                            joint + 1, radToDeg(joints[joint]), radToDeg(limit.lower), radToDeg(limit.upper)),
                joint)));
  }
  /// J1 to J3 at any turn, J4 to J6 as they are.
  [[nodiscard]] bool hasPlace(double angle, int joint) const {
    const arm::JointLimit& limit = scene_.arm.limits()[static_cast<std::size_t>(joint)];
    constexpr int kTurns = 2;
    for (int turn = -kTurns; turn <= kTurns; ++turn) {
      const double turned = joint < 3 ? angle + turn * 2.0 * kPi : angle;
      if (turned >= limit.lower && turned <= limit.upper) return true;
    }
    return false;
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
