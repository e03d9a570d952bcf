// A step planned by itself, and random ones, for whoever cuts them.
#pragma once

#include <optional>
#include <random>
#include <variant>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/cell/plan/planned_cell.h"
#include "cobot_command/cell/program/cell.h"
#include "cobot_command/planning/script_planner.h"

namespace cobot_command::cell {

inline arm::ArmModel tm5() {
  return *arm::ArmModel::named("tm5-900");
}

struct Scene {
  arm::JointVector joints = arm::toJointVector({0, -10, 110, -10, 90, 0});
  arm::Pose base = arm::Pose::Identity();
  arm::Pose tcp = arm::toPose({0, 0, 120, 0, 0, 0});

  /// The TCP in the base.
  [[nodiscard]] arm::Pose start() const {
    return base.inverse() * arm::forwardKinematics(tm5(), joints) * tcp;
  }
};

/// Nothing: it cannot be made.
inline std::optional<PlannedMotion> plannedStep(const Step& step, const Scene& scene) {
  planning::ScriptPlanner planner(tm5(), {scene.joints, scene.base, scene.tcp, 1.0});
  const auto order = std::visit([&](const auto& goal) { return orderOf(goal, scene.base); }, step.goal);
  const auto planned = planner.append(order.commands->front());
  if (!planned || !planned->trajectory) return std::nullopt;
  return PlannedMotion{planned->trajectory, std::nullopt, scene.tcp, scene.base};
}

/// Steps of all kinds from random places.
class RandomSteps {
 public:
  explicit RandomSteps(unsigned seed) : random_(seed) {}

  [[nodiscard]] double within(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(random_);
  }
  [[nodiscard]] bool coin() { return within(0, 1) < 0.5; }

  [[nodiscard]] Scene scene() {
    Scene scene;
    scene.joints = arm::toJointVector({within(-150, 150), within(-40, 20), within(70, 125), within(-60, 40),
                                       within(50, 130), within(-150, 150)});
    scene.base = arm::toPose({within(-500, 500), within(-500, 500), within(-200, 200), within(-180, 180),
                              within(-80, 80), within(-180, 180)});
    scene.tcp = arm::toPose({within(-50, 50), within(-50, 50), within(0, 200), within(-40, 40),
                             within(-40, 40), within(-180, 180)});
    return scene;
  }

  [[nodiscard]] Step ptp(const Scene& scene) {
    blocks::MoveAbsoluteGoal goal = options<blocks::MoveAbsoluteGoal>(false);
    goal.movement_command = static_cast<int>(blocks::Movement::Ptp);
    const bool in_joints = coin();
    goal.data_format =
        static_cast<int>(in_joints ? blocks::AbsoluteFormat::Jpp : blocks::AbsoluteFormat::Cpp);
    if (in_joints) {
      for (double& joint : goal.target) joint = within(-90, 90);
    } else {
      goal.target = away(scene, 300, 60);
    }
    return stepOf(goal);
  }
  [[nodiscard]] Step line(const Scene& scene) {
    const bool by_mm = coin();
    auto goal = options<blocks::MoveAbsoluteGoal>(by_mm);
    goal.movement_command = static_cast<int>(blocks::Movement::Line);
    goal.data_format = static_cast<int>(by_mm ? blocks::AbsoluteFormat::Car : blocks::AbsoluteFormat::Cpr);
    goal.target = away(scene, 300, 60);
    return stepOf(goal);
  }
  [[nodiscard]] Step relative(const Scene& /*scene*/) {
    const bool is_line = coin();
    const bool by_mm = is_line && coin();
    auto goal = options<blocks::MoveRelativeGoal>(by_mm);
    goal.movement_command = static_cast<int>(is_line ? blocks::Movement::Line : blocks::Movement::Ptp);
    const bool in_tool = coin();
    if (by_mm) {
      goal.data_format =
          static_cast<int>(in_tool ? blocks::RelativeFormat::Tar : blocks::RelativeFormat::Cap);
    } else {
      goal.data_format =
          static_cast<int>(in_tool ? blocks::RelativeFormat::Tpp : blocks::RelativeFormat::Cpp);
    }
    for (std::size_t i = 0; i < 6; ++i) goal.target[i] = i < 3 ? within(-200, 200) : within(-40, 40);
    return stepOf(goal);
  }
  [[nodiscard]] Step circle(const Scene& scene) {
    const bool by_mm = coin();
    auto goal = options<blocks::MoveCircleGoal>(by_mm);
    goal.data_format = static_cast<int>(by_mm ? blocks::CircleFormat::Cap : blocks::CircleFormat::Cpp);
    goal.arc_point = away(scene, 200, 40);
    goal.end_point = away(scene, 200, 40);
    if (coin()) goal.arc_angle = std::round(within(20, 360));
    return stepOf(goal);
  }

 private:
  template <class Goal>
  Goal options(bool by_mm) {
    Goal goal;
    goal.speed = std::round(by_mm ? within(50, 400) : within(5, 40));
    goal.accel_time = std::round(within(150, 500));
    return goal;
  }
  template <class Goal>
  static Step stepOf(const Goal& goal) {
    Step step;
    step.name = "random";
    step.goal = goal;
    return step;
  }
  blocks::SixValues away(const Scene& scene, double millimetres, double degrees) {
    const arm::Pose by = arm::toPose({within(-millimetres, millimetres), within(-millimetres, millimetres),
                                      within(-millimetres, millimetres), within(-degrees, degrees),
                                      within(-degrees, degrees), within(-degrees, degrees)});
    return arm::toControllerPose(scene.start() * by);
  }

  std::mt19937 random_;
};

}  // namespace cobot_command::cell
