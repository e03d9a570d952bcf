#include "jog/jog_plan.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/refusal_failure.h"
#include "cobot_command/common/units.h"
#include "cobot_command/motion/velocity.h"
#include "cobot_command/planning/script_planner.h"
#include "cobot_command/tables/refusal.h"

namespace cobot_command::blocks {
namespace {

using Directions = std::array<int, 6>;

constexpr double kUsualSpeed = 10;  // [%]
/// Of an increment, for which nobody has to let go.
constexpr Duration kStepRamp = std::chrono::milliseconds(200);
/// The controller's own watch: so long behind a velocity it lets the arm rest, and ends the mode [ms].
constexpr int kRestsAfter = 300;
constexpr int kEndsAfter = 3000;
/// Of one look ahead for the TCP: a look that finds something is made again and again, finer and finer.
constexpr Duration kLook = std::chrono::seconds(2);

int percentOf(double speed) {
  return std::max(1, static_cast<int>(std::lround(speed == 0 ? kUsualSpeed : speed)));
}

Eigen::Vector3d sum(const Directions& directions, std::size_t first) {
  return {static_cast<double>(directions[first]), static_cast<double>(directions[first + 1]),
          static_cast<double>(directions[first + 2])};
}

Eigen::Vector3d unit(const Directions& directions, std::size_t first) {
  const Eigen::Vector3d all = sum(directions, first);
  return all.isZero(0.0) ? all : all.normalized();
}

Failure missing(int id, const tables::Gap& gap) {
  return {id, gap.found, ""};
}

/// The axes of its directions, in the robot base.
Result<Eigen::Matrix3d, Failure> axesOf(const JogGoal& goal, const PlanningScene& scene,
                                        const motion::Setting& setting) {
  if (goal.mode == static_cast<int>(JogMode::Frame)) {
    if (goal.frame == JogGoal::kActive) return Eigen::Matrix3d(setting.base.linear());
    const auto frame = scene.tables.frameInRobotBase(goal.frame);
    if (!frame) return refuse(missing(tables::table_error::kFrameIndex, frame.error()));
    return Eigen::Matrix3d(frame->linear());
  }
  arm::Pose tool = setting.tcp;
  if (goal.tool != JogGoal::kActive) {
    const auto found = scene.tables.toolInFlange(goal.tool);
    if (!found) return refuse(missing(tables::table_error::kToolIndex, found.error()));
    tool = *found;
  }
  return Eigen::Matrix3d(arm::forwardKinematics(*scene.arm, *scene.start->joints).linear() * tool.linear());
}

/// A turn is one of the active TCP: about that of another tool its own way would be an arc.
std::optional<Failure> otherTool(const JogGoal& goal, const PlanningScene& scene,
                                 const motion::Setting& setting) {
  if (goal.tool == JogGoal::kActive || unit(goal.directions, 3).isZero(0.0)) return std::nullopt;
  const auto tool = scene.tables.toolInFlange(goal.tool);
  if (!tool) return missing(tables::table_error::kToolIndex, tool.error());
  if (arm::isSamePose(*tool, setting.tcp)) return std::nullopt;
  return Failure{
      tables::table_error::kToolIndex,
      fmt::format("tool {} is not the active TCP, and the controller turns only about the active TCP",
                  goal.tool),
      "Make it the active one with change_tcp, or give tool -1"};
}

/// Each joint at its share of its rated speed; or by the same angle.
void setJointRates(JogPlan& plan, const JogGoal& goal, const PlanningScene& scene) {
  for (std::size_t i = 0; i < arm::kJointCount; ++i) {
    const double rated = plan.percent / 100.0 * scene.arm->limits()[i].max_velocity;
    const double rate = plan.step ? degToRad(goal.increment_deg) : rated;
    plan.joint_rate[static_cast<Eigen::Index>(i)] = goal.directions[i] * rate;
  }
}

/// The TCP at its speed, whatever the direction; or by the increment along each of its axes.
std::optional<Failure> setTcpRate(JogPlan& plan, const JogGoal& goal, const PlanningScene& scene) {
  if (auto other = otherTool(goal, scene, plan.setting)) return other;
  const auto axes = axesOf(goal, scene, plan.setting);
  if (!axes) return axes.error();
  const Eigen::Matrix3d turned = plan.setting.base.linear().transpose() * *axes;
  if (plan.step) {
    plan.tcp_rate.linear = turned * sum(goal.directions, 0) * mmToM(goal.increment_mm);
    plan.tcp_rate.angular = turned * sum(goal.directions, 3) * degToRad(goal.increment_deg);
    return std::nullopt;
  }
  const arm::Ratings& ratings = scene.arm->ratings();
  const double share = plan.percent / 100.0;
  plan.tcp_rate.linear = turned * unit(goal.directions, 0) * (share * ratings.max_tcp_speed);
  plan.tcp_rate.angular = turned * unit(goal.directions, 3) * (share * ratings.turn_speed);
  return std::nullopt;
}

std::variant<arm::JointVector, motion::TcpVelocity> velocityOf(const JogPlan& plan) {
  if (plan.of_joints) return plan.joint_rate;
  return plan.tcp_rate;
}

/// Look by look until something is in the way; the first one may be refused, as there is no room at all.
std::optional<Failure> lookAhead(JogPlan& plan, const GiveUp& give_up) {
  const double override = plan.setting.speed_override;
  const double ramp = toSeconds(kJogRamp);
  const Duration look = plan.of_joints ? motion::kMaxLasting : kLook;
  motion::JointState state{plan.start, arm::JointVector::Zero()};
  double driven = 0;      // when `state` is reached
  double starting = 0.5;  // share of the first ramp that is driven
  for (Duration looked{}; looked < motion::kMaxLasting && !plan.obstacle; looked += look) {
    if (give_up && give_up()) return Failure{own_error::kPlanningBudget, "", ""};
    auto ahead = motion::planVelocity(*plan.arm, state, {velocityOf(plan), kJogRamp, look}, plan.setting);
    if (!ahead) {
      if (looked == Duration::zero()) return toFailure(ahead.error());
      plan.obstacle = std::move(ahead.error());
      return std::nullopt;
    }
    const double steady = toSeconds(ahead->trajectory->duration()) - 2 * ramp;
    plan.reach = driven + override * (starting * ramp + steady + 0.5 * ramp);
    plan.rest = ahead->trajectory->end().position;
    plan.obstacle = std::move(ahead->ends_at);
    driven += override * (starting * ramp + steady);
    state = ahead->trajectory->at(fromSeconds(ramp + steady));
    starting = 1.0;
  }
  return std::nullopt;
}

script::SixNumbers inDegrees(const arm::JointVector& joints) {
  return arm::toControllerJoints(joints);
}

script::SixNumbers asControllerTakesIt(const motion::TcpVelocity& rate, bool in_metres) {
  script::SixNumbers six{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double linear = rate.linear[static_cast<Eigen::Index>(i)];
    const double angular = rate.angular[static_cast<Eigen::Index>(i)];
    six[i] = in_metres ? linear : mToMm(linear);
    six[i + 3] = in_metres ? angular : radToDeg(angular);
  }
  return six;
}

/// As planning tells them apart.
std::string nearestSingularity(const arm::ArmModel& arm, const arm::JointVector& joints) {
  const arm::SingularityDistance distance = arm::singularityDistance(arm, joints);
  const double shoulder = std::abs(distance.shoulder);
  if (shoulder <= std::min(distance.elbow, distance.wrist)) {
    return fmt::format("the nearest singularity is that of the shoulder, {:.1f} mm from there",
                       mToMm(shoulder));
  }
  return distance.elbow <= distance.wrist
             ? fmt::format("the nearest singularity is that of the elbow, J3 = {:.1f} deg there",
                           radToDeg(joints[2]))
             : fmt::format("the nearest singularity is that of the wrist, J5 = {:.1f} deg there",
                           radToDeg(joints[4]));
}

Order openEnded(std::vector<script::ScriptCommand> commands) {
  Order order = motionOrder(std::move(commands));
  order.is_open_ended = true;
  return order;
}

}  // namespace

double JogPlan::driveAt(const arm::JointVector& joints, double last) const {
  if (of_joints) return (joints - start).dot(joint_rate) / joint_rate.squaredNorm();
  const arm::Pose tcp = arm::forwardKinematics(*arm, joints) * setting.tcp;
  const Eigen::Vector3d linear = setting.base.linear() * tcp_rate.linear;
  if (!linear.isZero(0.0)) {
    return (tcp.translation() - tcp_start.translation()).dot(linear) / linear.squaredNorm();
  }
  const Eigen::Vector3d angular = setting.base.linear() * tcp_rate.angular;
  const Eigen::AngleAxisd turn(tcp.linear() * tcp_start.linear().transpose());
  const double angle = turn.angle() * turn.axis().dot(angular.normalized());
  const double expected = last * angular.norm();
  return (angle + 2 * kPi * std::round((expected - angle) / (2 * kPi))) / angular.norm();
}

std::string JogPlan::obstacleText() const {
  using Reason = motion::Refusal::Reason;
  const int joint = obstacle->joint;
  if (obstacle->reason == Reason::JointLimit && joint >= 0) {
    const arm::JointLimit& limits = arm->limits()[static_cast<std::size_t>(joint)];
    return fmt::format("J{} reaches its limit, {:.6g} to {:.6g} deg", joint + 1, radToDeg(limits.lower),
                       radToDeg(limits.upper));
  }
  const std::string nearest = nearestSingularity(*arm, rest);
  if (obstacle->reason == Reason::JointSpeed && joint >= 0) {
    return fmt::format("J{} would be faster than rated; {}", joint + 1, nearest);
  }
  const char* const what = obstacle->reason == Reason::Singular ? "the path runs into a singularity"
                                                                : "the path leaves the reach of the arm";
  return fmt::format("{}; {}", what, nearest);
}

double JogPlan::wayOf(double drive) const {
  return of_joints ? 0.0 : drive * tcp_rate.linear.norm();
}

double JogPlan::turnOf(double drive) const {
  return drive * (of_joints ? joint_rate.cwiseAbs().maxCoeff() : tcp_rate.angular.norm());
}

Order JogPlan::move(double drive, bool passes_on) const {
  script::MotionOptions options;
  options.speed = percent;
  const Duration ramp = passes_on ? kJogRamp : kStepRamp;
  options.accel_time = static_cast<int>(std::chrono::duration_cast<std::chrono::milliseconds>(ramp).count());
  options.blending = passes_on ? 100 : 0;
  script::DataFormat format;
  if (of_joints) {
    format.target = script::DataFormat::Target::Joint;
    return motionOrder(script::MovePtp{format, inDegrees(joint_rate * drive), options});
  }
  arm::Pose by = arm::Pose::Identity();
  by.translation() = tcp_rate.linear * drive;
  const double angle = tcp_rate.angular.norm() * drive;
  if (angle > 0) by.linear() = Eigen::AngleAxisd(angle, tcp_rate.angular.normalized()).toRotationMatrix();
  return motionOrder(script::MoveLine{format, arm::toControllerPose(by), options});
}

/// Of joints the controller has no watch.
Order JogPlan::enterVelocity() const {
  if (of_joints) return openEnded({script::ContinueVJog{}, script::SetContinueVJog{inDegrees(joint_rate)}});
  return openEnded({script::ContinueVLine{kRestsAfter, kEndsAfter},
                    script::SetContinueVLine{asControllerTakesIt(tcp_rate, is_in_metres)}});
}

Order JogPlan::setVelocity(bool rests) const {
  script::ScriptCommand set =
      script::SetContinueVLine{rests ? script::SixNumbers{} : asControllerTakesIt(tcp_rate, is_in_metres)};
  if (of_joints) set = script::SetContinueVJog{rests ? script::SixNumbers{} : inDegrees(joint_rate)};
  return rests ? settingOrder(std::move(set)) : openEnded({std::move(set)});
}

Order JogPlan::leaveVelocity() {
  return settingOrder(script::StopContinueVmode{});
}

Result<std::shared_ptr<const JogPlan>, Failure> planJog(const JogGoal& goal, const PlanningScene& scene) {
  auto plan = std::make_shared<JogPlan>();
  plan->of_joints = goal.mode == static_cast<int>(JogMode::Axes);
  plan->percent = percentOf(goal.speed);
  plan->start = *scene.start->joints;
  const VelocityModes::Line line = scene.velocities.line;
  const bool is_permitted = plan->of_joints ? scene.velocities.joints : line != VelocityModes::Line::Off;
  plan->by_velocity = is_permitted && !scene.is_velocity_refused;
  plan->is_in_metres = line == VelocityModes::Line::Metres;
  plan->stop_time = scene.jog_stop_time;
  const bool has_frames = scene.start->base && scene.start->tcp;
  if (!plan->of_joints && !has_frames) {
    return refuse(Failure{own_error::kStartUnknown,
                          "the active base or TCP is defined in the project, and its value is unknown", ""});
  }
  plan->setting = {scene.start->base.value_or(arm::Pose::Identity()),
                   scene.start->tcp.value_or(arm::Pose::Identity()), scene.start->speed_override};
  if (goal.increment_mm > 0 || goal.increment_deg > 0) plan->step = 1.0;
  if (plan->of_joints) {
    setJointRates(*plan, goal, scene);
  } else if (auto failure = setTcpRate(*plan, goal, scene)) {
    return refuse(std::move(*failure));
  }
  plan->arm = std::make_shared<const arm::ArmModel>(*scene.arm);
  plan->tcp_start = arm::forwardKinematics(*scene.arm, plan->start) * plan->setting.tcp;
  if (plan->step) {
    planning::ScriptPlanner planner(*scene.arm, *scene.start);
    const auto made = planner.append(plan->move(*plan->step, false).commands->front());
    if (!made) return refuse(toFailure(made.error()));
  } else if (auto failure = lookAhead(*plan, scene.give_up)) {
    return refuse(std::move(*failure));
  }
  return std::shared_ptr<const JogPlan>(std::move(plan));
}

}  // namespace cobot_command::blocks
