// What a plan promises from where the stream says that the arm stands, the arm does from where it stands.
#include <cmath>
#include <random>
#include <vector>

#include "planning_support.h"
#include <fmt/format.h>

#include "cobot_command/common/units.h"
#include "cobot_command/motion/planner.h"
#include "cobot_command/planning/script_motion.h"

namespace cobot_command::planning {
namespace {

using Planned = Result<motion::TrajectoryPtr, motion::Refusal>;

/// As the status stream tells joints: floats, in degrees.
arm::JointVector streamed(const arm::JointVector& joints) {
  return joints.unaryExpr([](double joint) { return degToRad(static_cast<float>(radToDeg(joint))); });
}

/// What the arm makes of a line of a script.
Planned made(const arm::ArmModel& arm, const arm::JointVector& from, const std::string& text) {
  const auto command = std::visit(
      [](const auto& one) -> Result<motion::Command, motion::Refusal> {
        if constexpr (std::is_constructible_v<ScriptMotion, decltype(one)>) {
          return toMotion(ScriptMotion(one));
        } else {
          return refuse(motion::Refusal{});
        }
      },
      line(text));
  if (!command) return refuse(command.error());
  return motion::plan(arm, from, *command, motion::Setting{});
}

Result<PlannedStep, motion::Refusal> forecast(const arm::ArmModel& arm, const arm::JointVector& from,
                                              const std::string& text) {
  return ScriptPlanner(arm, streamed(from), motion::Setting{}).append(line(text));
}

std::string numbers(const arm::Pose& pose) {
  return fmt::format("{:.17g}", fmt::join(arm::toControllerPose(pose), ","));
}

class HalfTurns : public ::testing::Test {
 protected:
  double uniform(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random);
  }
  Eigen::Vector3d direction() {
    return Eigen::Vector3d(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)).normalized();
  }
  /// About half a turn: exactly, or more or less within 3 degrees; mostly about the tool's axis, which J6
  /// can make.
  arm::Pose offset() {
    const double away = uniform(0, 1) < 0.3 ? 0.0 : uniform(-3, 3);
    const Eigen::Vector3d axis = uniform(0, 1) < 0.7 ? Eigen::Vector3d::UnitZ().eval() : direction();
    arm::Pose by = arm::Pose::Identity();
    by.translation() = uniform(0, 0.05) * direction();
    by.linear() = Eigen::AngleAxisd(degToRad(180 + away), axis).toRotationMatrix();
    return by;
  }
  std::string motion(const arm::JointVector& from) {
    const arm::Pose by = offset();
    const arm::Pose start = arm::forwardKinematics(arm, from);
    const std::string target = numbers(start * by);
    arm::Pose middle = start;
    middle.translation() += 0.03 * direction();
    switch (std::uniform_int_distribution<int>(0, 5)(random)) {
      case 0:
        return fmt::format("PTP(\"CPP\",{},50,200,0,false)", target);
      case 1:
        return fmt::format("Circle(\"CAP\",{},{},50,200,0,0,false)", numbers(middle), target);
      case 2:
        return fmt::format("PLine(\"CAP\",{},50,200,0)", target);
      case 3:
        return fmt::format("Move_Line(\"TAP\",{},50,200,0,false)", numbers(by));
      case 4:
        return fmt::format("Move_PTP(\"TPP\",{},50,200,0,false)", numbers(by));
      default:
        return fmt::format("Line(\"CAP\",{},50,200,0,false)", target);
    }
  }
  arm::JointVector posture() {
    arm::ControllerJoints joints{10, 15, 80, -5, 85, 20};
    for (double& joint : joints) joint += uniform(-20, 20);
    joints[5] = uniform(-269, 269);
    return arm::toJointVector(joints);
  }

  arm::ArmModel arm = model();
  std::mt19937 random{20261122};
};

TEST_F(HalfTurns, thatAPlanPromisesAreMadeAsPlanned) {
  int promised = 0;
  int ambiguous = 0;
  for (int i = 0; i < 1000; ++i) {
    const arm::JointVector from = posture();
    const std::string text = motion(from);
    const auto plan = forecast(arm, from, text);
    if (!plan) {
      ambiguous += plan.error().reason == motion::Refusal::Reason::AmbiguousTurn ? 1 : 0;
      continue;
    }
    ++promised;
    const Planned motion = made(arm, from, text);
    ASSERT_TRUE(motion) << text << ": " << motion.error().message;
    const arm::JointVector apart = (*motion)->end().position - plan->trajectory->end().position;
    ASSERT_LT(apart.cwiseAbs().maxCoeff(), 1e-4) << text;
  }
  EXPECT_GT(promised, 100);
  EXPECT_GT(ambiguous, 100);
}

TEST_F(HalfTurns, areRefusedAsTheyWereFound) {
  // The line after the first one failed with 0x1405A, and its check succeeded.
  const arm::JointVector home = arm::toJointVector({0, 0, 90, 0, 90, 0});
  const auto first = made(arm, home, "Line(\"CAP\",400,100,400,180,0,90,100,200,0,false)");
  ASSERT_TRUE(first);
  const auto second =
      forecast(arm, (*first)->end().position, "Line(\"CAP\",400,100,400,0,0,90,100,200,0,false)");
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().reason, motion::Refusal::Reason::AmbiguousTurn);
}

}  // namespace
}  // namespace cobot_command::planning
