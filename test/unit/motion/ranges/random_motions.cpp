#include "random_motions.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/common/units.h"
#include "cobot_command/motion/blend.h"
#include "cobot_command/motion/planner.h"
#include "cobot_command/motion/velocity.h"

namespace cobot_command::motion {

double Dice::ofAnySize(double low, double high) {
  return low * std::pow(high / low, between(0.0, 1.0));
}

Eigen::Vector3d Dice::direction() {
  Eigen::Vector3d any;
  do {
    any = {between(-1, 1), between(-1, 1), between(-1, 1)};
  } while (any.norm() > 1.0 || any.norm() < 0.1);
  return any.normalized();
}

arm::JointVector Dice::joints(double most) {
  arm::JointVector all;
  for (double& one : all) one = between(-most, most);
  return all;
}

namespace {

struct Scene {
  arm::JointVector start;
  Setting setting;
};

arm::Pose turned(Dice& dice, const arm::Pose& from, double way, double turn) {
  arm::Pose pose = from;
  pose.translation() += way * dice.direction();
  pose.linear() =
      Eigen::AngleAxisd(dice.between(0.0, turn), dice.direction()).toRotationMatrix() * from.linear();
  return pose;
}

Scene anyScene(Dice& dice) {
  Scene scene;
  scene.start = arm::toJointVector({10, 15, 80, -5, 85, 20}) + dice.joints(0.6);
  scene.setting.base = turned(dice, arm::Pose::Identity(), 0.2, 1.0);
  scene.setting.tcp = turned(dice, arm::Pose::Identity(), 0.15, 1.0);
  scene.setting.speed_override = dice.ofAnySize(0.05, 1.0);
  return scene;
}

arm::Pose tcpOf(const arm::ArmModel& arm, const Scene& scene) {
  return scene.setting.base.inverse() * arm::forwardKinematics(arm, scene.start) * scene.setting.tcp;
}

arm::Pose anyTarget(const arm::ArmModel& arm, const Scene& scene, Dice& dice) {
  return turned(dice, tcpOf(arm, scene), dice.ofAnySize(1e-3, 0.3), dice.coin() ? 0.0 : 0.6);
}

Duration anyRamp(Dice& dice) {
  return fromSeconds(dice.ofAnySize(0.02, 1.0));
}

PathSpeed anySpeed(Dice& dice) {
  return dice.coin() ? PathSpeed(SpeedRatio{dice.ofAnySize(0.02, 0.5)})
                     : PathSpeed(TcpSpeed{dice.ofAnySize(0.01, 0.6)});
}

Rates anyRates(Dice& dice) {
  return {dice.ofAnySize(0.02, 1.0), dice.ofAnySize(0.1, 5.0), dice.ofAnySize(0.1, 5.0)};
}

RampShape anyShape(Dice& dice) {
  const auto law = static_cast<SpeedLaw>(static_cast<int>(dice.between(0.0, 3.999)));
  return {law, dice.coin() ? dice.between(0, 1) : 0.0, dice.between(0, 1)};
}

Circle anyCircle(const arm::ArmModel& arm, const Scene& scene, Dice& dice) {
  Circle circle;
  circle.via = anyTarget(arm, scene, dice);
  circle.end = anyTarget(arm, scene, dice);
  if (dice.coin()) circle.arc_angle = dice.between(-6.2, 6.2);
  circle.speed = anySpeed(dice);
  circle.time_to_top_speed = anyRamp(dice);
  return circle;
}

PoseOffset anyOffset(Dice& dice) {
  return {turned(dice, arm::Pose::Identity(), dice.ofAnySize(1e-3, 0.2), 0.4),
          dice.coin() ? PoseOffset::Axes::Base : PoseOffset::Axes::Tool};
}

Pvt anyJointPvt(const Scene& scene, Dice& dice) {
  std::vector<PvtJointPoint> points;
  arm::JointVector at = scene.start;
  for (int i = 0; i < 4; ++i) {
    at += dice.joints(0.2);
    const arm::JointVector velocity = i < 3 ? dice.joints(0.6) : arm::JointVector::Zero();
    points.push_back({at, velocity, dice.ofAnySize(0.2, 3.0)});
  }
  return {points};
}

Pvt anyPosePvt(const arm::ArmModel& arm, const Scene& scene, Dice& dice) {
  std::vector<PvtPosePoint> points;
  arm::Pose at = tcpOf(arm, scene);
  for (int i = 0; i < 3; ++i) {
    at = turned(dice, at, 0.05, 0.3);
    const double moving = i < 2 ? 1.0 : 0.0;
    points.push_back(
        {at,
         {moving * dice.between(0, 0.1) * dice.direction(), moving * dice.between(0, 0.3) * dice.direction()},
         dice.ofAnySize(0.3, 3.0)});
  }
  return {points};
}

Command anyCommand(const arm::ArmModel& arm, const Scene& scene, Dice& dice, std::size_t kind) {
  const PathRates rates{anyRates(dice), anyRates(dice), anyShape(dice)};
  const auto near = [&] { return arm::JointVector(scene.start + dice.joints(0.5)); };
  const auto target = [&] { return anyTarget(arm, scene, dice); };
  switch (kind) {
    case 0:
      return Ptp{near(), dice.ofAnySize(0.05, 1.0), anyRamp(dice)};
    case 1:
      return MovePtp{anyOffset(dice), dice.ofAnySize(0.05, 1.0), anyRamp(dice)};
    case 2:
      return JointMove{near(), anyRates(dice), anyShape(dice)};
    case 3:
      return anyJointPvt(scene, dice);
    case 4:
      return Line{target(), anySpeed(dice), anyRamp(dice)};
    case 5:
      return anyCircle(arm, scene, dice);
    case 6:
      return MoveLine{anyOffset(dice), anySpeed(dice), anyRamp(dice)};
    case 7:
      return PLine{target(), anySpeed(dice), anyRamp(dice)};
    case 8:
      return MovePLine{anyOffset(dice), anySpeed(dice), anyRamp(dice)};
    case 9:
      return StraightMove{target(), rates};
    case 10:
      return WristMove{near(), rates};
    case 11:
      return ArcMove{target(), target(), rates};
    default:
      return anyPosePvt(arm, scene, dice);
  }
}

constexpr std::size_t kCommands = 13;
constexpr std::size_t kThatBlend[] = {0, 1, 2, 4, 5, 6, 7, 9, 10, 11};

TrajectoryPtr tried(const Result<TrajectoryPtr, Refusal>& planned) {
  return planned && (*planned)->duration() > Duration::zero() ? *planned : nullptr;
}

MotionKind command(const char* name, std::size_t kind) {
  return {name, [kind](const arm::ArmModel& arm, Dice& dice) {
            const Scene scene = anyScene(dice);
            return tried(plan(arm, scene.start, anyCommand(arm, scene, dice, kind), scene.setting));
          }};
}

TrajectoryPtr anyVelocity(const arm::ArmModel& arm, Dice& dice, bool of_tcp) {
  const Scene scene = anyScene(dice);
  SetVelocity set;
  set.ramp = anyRamp(dice);
  set.lasting = set.ramp + fromSeconds(dice.between(0.0, 2.0));
  const TcpVelocity tcp{dice.between(0, 0.2) * dice.direction(), dice.between(0, 0.3) * dice.direction()};
  if (of_tcp) set.velocity = tcp;
  if (!of_tcp) set.velocity = dice.joints(1.0);
  const arm::JointVector now = dice.coin() ? dice.joints(0.2) : arm::JointVector::Zero();
  const auto made = planVelocity(arm, {scene.start, now}, set, scene.setting);
  return made ? made->trajectory : nullptr;
}

/// Two of any kinds, or two PLines where `chain`.
TrajectoryPtr anyPassage(const arm::ArmModel& arm, Dice& dice, bool chain) {
  Scene scene = anyScene(dice);
  const auto any = [&] {
    const auto kinds = static_cast<double>(std::size(kThatBlend));
    const std::size_t kind =
        chain ? 7 : kThatBlend[static_cast<std::size_t>(dice.between(0.0, kinds - 1e-3))];
    return tried(plan(arm, scene.start, anyCommand(arm, scene, dice, kind), scene.setting));
  };
  const auto before = any();
  if (!before) return nullptr;
  scene.start = before->end().position;
  const auto next = any();
  if (!next) return nullptr;
  const Blend blend = chain || dice.coin() ? Blend(BlendShare{dice.between(0.2, 1.0)})
                                           : Blend(BlendRadius{dice.ofAnySize(1e-3, 0.1)});
  const Duration left = dice.coin() ? Duration::max() : fromSeconds(dice.ofAnySize(0.01, 1.0));
  const Passage passage = passInto(arm, before, next, scene.setting.tcp, blend, left);
  return passage.overlap > Duration::zero() ? passage.path : nullptr;
}

/// Passes a place where one of the three distances to a singularity is about 3 mm (or its sine 3e-3).
TrajectoryPtr besideSingularity(const arm::ArmModel& arm, Dice& dice) {
  Scene scene = anyScene(dice);
  arm::JointVector there = scene.start;
  const double beside = (dice.coin() ? 1.0 : -1.0) * dice.between(2.7e-3, 3.3e-3);
  const double which = dice.between(0.0, 3.0);
  if (which < 1.0) there[4] = beside;
  if (which >= 1.0 && which < 2.0) there[2] = beside;
  if (which >= 2.0) {  // the shoulder: lean back until the wrist is over the base
    double low = -1.5;
    double high = 1.5;
    const auto distance = [&](double lean) {
      arm::JointVector joints = there;
      joints[1] = lean;
      return arm::singularityDistance(arm, joints).shoulder;
    };
    double best = low;
    for (double lean = low; lean < high; lean += 1e-3) {
      if (std::abs(distance(lean) - 3e-3) < std::abs(distance(best) - 3e-3)) best = lean;
    }
    there[1] = best;
  }
  const arm::Pose middle = arm::forwardKinematics(arm, there) * scene.setting.tcp;
  const Eigen::Vector3d way = dice.ofAnySize(1e-3, 0.03) * dice.direction();
  arm::Pose from = middle;
  arm::Pose to = scene.setting.base.inverse() * middle;
  from.translation() -= way;
  to.translation() += scene.setting.base.linear().transpose() * way;
  // Where the line begins, on the side of the singularity on which it is in its middle.
  Setting straight = scene.setting;
  straight.speed_override = 1.0;
  const Line back{scene.setting.base.inverse() * from, TcpSpeed{1e-3}, std::chrono::milliseconds(100)};
  const auto first = plan(arm, there, back, straight);
  if (!first) return nullptr;
  const Line line{to, TcpSpeed{dice.ofAnySize(1e-3, 0.05)}, anyRamp(dice)};
  return tried(plan(arm, (*first)->end().position, line, scene.setting));
}

}  // namespace

const std::vector<MotionKind>& motionKinds() {
  static const std::vector<MotionKind> kinds = [] {
    constexpr const char* kNames[kCommands] = {
        "Ptp",   "MovePtp",   "JointMove",    "PvtOfJoints", "Line",    "Circle",    "MoveLine",
        "PLine", "MovePLine", "StraightMove", "WristMove",   "ArcMove", "PvtOfPoses"};
    std::vector<MotionKind> made;
    for (std::size_t i = 0; i < kCommands; ++i) made.push_back(command(kNames[i], i));
    const auto add = [&](const char* name, auto make) { made.push_back({name, make}); };
    add("JointVelocity", [](const arm::ArmModel& arm, Dice& dice) { return anyVelocity(arm, dice, false); });
    add("TcpVelocity", [](const arm::ArmModel& arm, Dice& dice) { return anyVelocity(arm, dice, true); });
    add("ChainOfPLines", [](const arm::ArmModel& arm, Dice& dice) { return anyPassage(arm, dice, true); });
    add("Blend", [](const arm::ArmModel& arm, Dice& dice) { return anyPassage(arm, dice, false); });
    add("BesideSingularity", besideSingularity);
    return made;
  }();
  return kinds;
}

}  // namespace cobot_command::motion
