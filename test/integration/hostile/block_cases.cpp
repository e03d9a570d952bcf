#include "block_cases.h"

#include <array>
#include <utility>

#include "motion_goals.h"
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/units.h"

namespace cobot_command::hostile {
namespace {

using blocks::Block;
using simulator::RobotState;

using Lie = std::function<std::string(const RobotState&)>;

constexpr std::array<double, 6> kStart{0, 0, 90, 0, 90, 0};
/// Of a simulated robot, whose motions end exactly.
constexpr double kTolerance = 1e-4;
constexpr double kQuickPercent = 20;

double percent(Pace pace) {
  return pace == Pace::Quick ? kQuickPercent : 1;
}
double millimetresPerSecond(Pace pace) {
  return pace == Pace::Quick ? 200 : 12;
}

Lie standsAtJoints(const std::array<double, 6>& joints_deg) {
  return [joints_deg](const RobotState& robot) -> std::string {
    if (robot.in_motion) return "the robot still moves";
    if ((robot.joints - arm::toJointVector(joints_deg)).cwiseAbs().maxCoeff() < kTolerance) return "";
    return fmt::format("the robot stands at {:.3f}, not at {}",
                       fmt::join(arm::toControllerJoints(robot.joints), " "), fmt::join(joints_deg, " "));
  };
}

Lie standsAtPose(const arm::ControllerPose& pose) {
  return [pose](const RobotState& robot) -> std::string {
    if (robot.in_motion) return "the robot still moves";
    return robot.flange.isApprox(arm::toPose(pose), kTolerance) ? "" : "the robot stands elsewhere";
  };
}

BlockCase moveAbsolute(Pace pace) {
  const std::array<double, 6> target{20, -10, 100, 5, 80, -15};
  return {blocks::kBlock<blocks::MoveAbsoluteGoal>, testing::moveJoints(target, percent(pace)), true,
          standsAtJoints(target)};
}

BlockCase moveRelative(Pace pace) {
  blocks::MoveRelativeGoal goal;
  goal.movement_command = static_cast<int>(blocks::Movement::Ptp);
  goal.data_format = static_cast<int>(blocks::RelativeFormat::Jpp);
  goal.target = {15, -5, 10, 0, -5, 20};
  goal.speed = percent(pace);
  goal.accel_time = 200;
  return {blocks::kBlock<blocks::MoveRelativeGoal>, goal, true, standsAtJoints({15, -5, 100, 0, 85, 20})};
}

/// Half a circle of 100 mm in the plane, from where the flange of a TM5-900 is at the start.
BlockCase moveCircle(Pace pace) {
  blocks::MoveCircleGoal goal;
  goal.data_format = static_cast<int>(blocks::CircleFormat::Cap);
  goal.arc_point = {467.5, -72.3, 461.05, 180, 0, 90};
  goal.end_point = {417.5, -122.3, 461.05, 180, 0, 90};
  goal.speed = millimetresPerSecond(pace);
  goal.accel_time = 200;
  return {blocks::kBlock<blocks::MoveCircleGoal>, goal, true, standsAtPose(goal.end_point)};
}

BlockCase changeBase() {
  blocks::ChangeBaseGoal goal;
  goal.transformation = {20, 30, 10, 0, 0, 90};
  return {
      blocks::kBlock<blocks::ChangeBaseGoal>, goal, false, [goal](const RobotState& robot) -> std::string {
        return robot.base.isApprox(arm::toPose(goal.transformation), kTolerance) ? "" : "the base is another";
      }};
}

BlockCase changeTcp() {
  blocks::ChangeTcpGoal goal;
  goal.tcp_offset = {0, 0, 150, 0, 0, 90};
  goal.weight = 1;
  return {blocks::kBlock<blocks::ChangeTcpGoal>, goal, false, [goal](const RobotState& robot) -> std::string {
            return robot.tcp.isApprox(arm::toPose(goal.tcp_offset), kTolerance) ? "" : "the TCP is another";
          }};
}

BlockCase changeLoad() {
  return {
      blocks::kBlock<blocks::ChangeLoadGoal>, blocks::ChangeLoadGoal{1.5}, false,
      [](const RobotState& robot) -> std::string { return robot.load == 1.5 ? "" : "the load is another"; }};
}

BlockCase setOutput() {
  return {blocks::kBlock<blocks::SetOutputGoal>, blocks::SetOutputGoal{0, "EndModule", 3, 1}, false,
          [](const RobotState& robot) -> std::string {
            return robot.outputs.end_module.at(3) ? "" : "the output was not set";
          }};
}

BlockCase programControl() {
  return {blocks::kBlock<blocks::ProgramControlGoal>, blocks::ProgramControlGoal{}, false,
          [](const RobotState& robot) -> std::string {
            return robot.project_paused ? "" : "the project is not paused";
          }};
}

/// Standing is what the layer takes for it: below the noise of a real arm's speeds.
BlockCase stop() {
  constexpr double kStanding = degToRad(0.1);
  return {blocks::kBlock<blocks::StopGoal>, blocks::StopGoal{}, false,
          [](const RobotState& robot) -> std::string {
            const double speed = robot.velocities.cwiseAbs().maxCoeff();
            if (speed < kStanding && robot.queued_motions <= 1) return "";
            return fmt::format("the robot still moves at {} rad/s, {} motions are queued", speed,
                               robot.queued_motions);
          }};
}

BlockCase exitListenNode() {
  return {blocks::kBlock<blocks::ExitListenNodeGoal>, blocks::ExitListenNodeGoal{}, false,
          [](const RobotState& robot) -> std::string {
            return robot.listening ? "the flow is still in the Listen node" : "";
          }};
}

BlockCase runScript(Pace pace) {
  blocks::RunScriptGoal goal;
  goal.script = fmt::format("ChangeLoad(0.5)\r\nPTP(\"JPP\",10,0,90,0,90,20,{},200,0,false)", percent(pace));
  goal.await_motion = true;
  return {blocks::kBlock<blocks::RunScriptGoal>, goal, true, standsAtJoints({10, 0, 90, 0, 90, 20})};
}

BlockCase checkSequence() {
  blocks::CheckSequenceGoal goal;
  goal.start_joints.assign(kStart.begin(), kStart.end());
  goal.steps.assign(3, testing::moveJoints({10, 0, 90, 0, 90, 0}, 50));
  return {blocks::kBlock<blocks::CheckSequenceGoal>, goal, false,
          [](const RobotState&) { return std::string(); }};
}

BlockCase pickAndPlace(Pace pace) {
  blocks::PickAndPlaceGoal goal;
  goal.steps.push_back({testing::moveJoints({10, -5, 95, 0, 90, 0}, percent(pace)),
                        blocks::SetOutputGoal{0, "EndModule", 0, 1}, std::nullopt, 0.05});
  goal.steps.push_back(
      {testing::moveJoints({-5, 5, 85, 0, 90, 0}, percent(pace)), std::nullopt, std::nullopt, 0});
  const Lie moved = standsAtJoints({-5, 5, 85, 0, 90, 0});
  return {blocks::kBlock<blocks::PickAndPlaceGoal>, goal, true,
          [moved](const RobotState& robot) -> std::string {
            if (!robot.outputs.end_module.at(0)) return "the output was not set";
            return moved(robot);
          }};
}

/// One point: no more than one command of it is under way.
BlockCase loadPath(Pace pace) {
  constexpr double kRated = 180;  // [deg/s]
  path::PathPoint point;
  point.joints = {20, -10, 100, 5, 80, -15};
  point.speed = kRated * percent(pace) / 100;
  point.acceleration = point.deceleration = 2 * kRated;
  blocks::LoadPathGoal goal;
  goal.path = {point};
  goal.number_of_moves = 1;
  return {blocks::kBlock<blocks::LoadPathGoal>, goal, true, standsAtJoints({20, -10, 100, 5, 80, -15})};
}

}  // namespace

std::vector<BlockCase> blockCases(Pace pace) {
  return {moveAbsolute(pace), moveRelative(pace), moveCircle(pace),   changeBase(),  changeTcp(),
          changeLoad(),       setOutput(),        programControl(),   stop(),        exitListenNode(),
          runScript(pace),    checkSequence(),    pickAndPlace(pace), loadPath(pace)};
}

BlockCase proofOfWork() {
  const std::array<double, 6> target{-20, 10, 80, 10, 95, 30};
  return {blocks::kBlock<blocks::MoveAbsoluteGoal>, testing::moveJoints(target, 100), true,
          standsAtJoints(target)};
}

}  // namespace cobot_command::hostile
