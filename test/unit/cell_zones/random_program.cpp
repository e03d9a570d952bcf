#include "random_program.h"

#include <cmath>
#include <set>

#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/common/units.h"

namespace cobot_command::cell {
namespace {

const arm::ArmModel& model() {
  static const arm::ArmModel kModel = *arm::ArmModel::named("tm5-900");
  return kModel;
}

arm::JointVector startOf(std::uint64_t seed) {
  Dice dice(seed);
  return arm::toJointVector({0, 10, 90, -10, 90, 0}) + dice.joints(0.5);
}

template <class Goal>
std::string textOf(const Goal& goal) {
  return fmt::format("{}", fmt::join(orderOf(goal, arm::Pose::Identity()).lines, "\n"));
}

}  // namespace

arm::JointVector Dice::joints(double most) {
  arm::JointVector joints;
  for (Eigen::Index i = 0; i < joints.size(); ++i) joints[i] = within(-most, most);
  return joints;
}

double Dice::ofAnySize(double lower, double upper) {
  return std::exp(within(std::log(lower), std::log(upper)));
}

std::vector<Part> sheetAndClip() {
  Part sheet;
  sheet.name = "sheet";
  sheet.shapes = {{BoxShape{{0.400, 0.300, 0.005}}, arm::Pose::Identity()}};
  sheet.at.translation().z() = 0.125;
  Part clip = sheet;
  clip.name = "clip";
  clip.on = "sheet";
  clip.shapes = {{BoxShape{{0.050, 0.300, 0.020}}, arm::Pose::Identity()}};
  clip.at.translation() = Eigen::Vector3d(0.200, 0.100, 0.015);
  return {sheet, clip};
}

Cell cellOfOne(const arm::JointVector& home) {
  Cell cell;
  cell.name = "random";
  Robot robot;
  robot.name = "R";
  robot.model = "tm5-900";
  robot.home = "HOME";
  robot.tool = {{CapsuleShape{{0, 0, 0}, {0, 0, 0.120}, 0.050}, arm::Pose::Identity()}};
  robot.stations = {{"HOME", home, arm::toControllerJoints(home), {}}};
  robot.stations.front().joints = arm::toJointVector(robot.stations.front().degrees);
  robot.program = {{"P", "HOME", "HOME", {}, {}}};
  cell.robots = {robot};
  cell.parts = sheetAndClip();
  return cell;
}

RandomProgram::RandomProgram(std::uint64_t seed, int steps)
    : cell(cellOfOne(startOf(seed))),
      dice_(seed),
      planner_(model(), {cell.robots.front().stations.front().joints, arm::Pose::Identity(),
                         arm::Pose::Identity(), 1.0}) {
  auto& path = cell.robots.front().program.front().steps;
  for (int i = 0; i < 100 && path.size() < static_cast<std::size_t>(steps); ++i) {
    Step step = anyStep();
    if (!blends(step)) carry(step);
    add(std::move(step));
  }
  endAtHome();
}

Step RandomProgram::anyStep() {
  Step step;
  switch (dice_.upTo(11)) {
    case 0:
      step.goal = script();
      break;
    case 1:
      step.goal = frame();
      break;
    case 2:
    case 3:
      step.goal = circle();
      break;
    case 4:
    case 5:
      step.goal = relative();
      break;
    case 6:
    case 7:
    case 8:
      step.goal = line();
      break;
    default:
      step.goal = ptp();
  }
  return step;
}

template <class Goal>
void RandomProgram::takeDynamics(Goal& goal) {
  goal.accel_time = std::round(dice_.within(150, 600));
  goal.blending_enable = dice_.upTo(2) > 0;
  const auto format = formatOf(goal);
  const bool absolute = format && format->speed == script::DataFormat::Speed::Absolute;
  const bool radius = format && format->blending == script::DataFormat::Blending::Radius;
  goal.speed = absolute ? dice_.ofAnySize(20, 800) : dice_.ofAnySize(5, 100);
  goal.blending_value = radius ? dice_.ofAnySize(2, 200) : dice_.within(5, 100);
}

blocks::SixValues RandomProgram::nearby(double metres, double radians) {
  const auto setting = planner_.setting();
  arm::Pose pose = setting.base.inverse() * arm::forwardKinematics(model(), planner_.joints()) * setting.tcp;
  const arm::JointVector by = dice_.joints(1.0);
  pose.translation() += metres * by.head<3>();
  pose.rotate(Eigen::AngleAxisd(radians * by[3], by.tail<3>().normalized()));
  return arm::toControllerPose(pose);
}

StepGoal RandomProgram::ptp() {
  blocks::MoveAbsoluteGoal goal;
  goal.movement_command = static_cast<int>(blocks::Movement::Ptp);
  goal.data_format =
      static_cast<int>(dice_.coin() ? blocks::AbsoluteFormat::Jpp : blocks::AbsoluteFormat::Cpp);
  goal.target = goal.data_format == 0
                    ? arm::toControllerJoints(planner_.joints() + dice_.joints(dice_.ofAnySize(0.01, 1.0)))
                    : nearby(dice_.ofAnySize(0.01, 0.3), 0.5);
  takeDynamics(goal);
  return goal;
}

StepGoal RandomProgram::line() {
  blocks::MoveAbsoluteGoal goal;
  goal.movement_command = static_cast<int>(blocks::Movement::Line);
  goal.data_format = 1 + dice_.upTo(3);
  goal.target = nearby(dice_.ofAnySize(0.005, 0.3), dice_.coin() ? 0.5 : 0.0);
  takeDynamics(goal);
  return goal;
}

StepGoal RandomProgram::circle() {
  blocks::MoveCircleGoal goal;
  goal.data_format = dice_.upTo(1);
  const double size = dice_.ofAnySize(0.02, 0.2);
  goal.arc_point = nearby(size, 0.3);
  goal.end_point = nearby(size, 0.3);
  if (dice_.coin()) goal.arc_angle = dice_.within(20, 340);
  takeDynamics(goal);
  return goal;
}

StepGoal RandomProgram::relative() {
  blocks::MoveRelativeGoal goal;
  const bool joints = dice_.coin();
  goal.movement_command = joints ? 1 : 0;
  goal.data_format = joints ? 0 : 1 + dice_.upTo(7);
  const arm::JointVector by = dice_.joints(1.0);
  for (std::size_t i = 0; i < 6; ++i) {
    goal.target[i] = by[static_cast<Eigen::Index>(i)] * (joints || i > 2 ? 20.0 : dice_.ofAnySize(5, 200));
  }
  takeDynamics(goal);
  return goal;
}

/// Two motions in one frame, a PVT, or none.
StepGoal RandomProgram::script() {
  blocks::RunScriptGoal goal;
  goal.await_motion = true;
  const int kind = dice_.upTo(2);
  if (kind == 0) {
    goal.script = "ChangeLoad(2.0)";
  } else if (kind == 1) {
    goal.script = textOf(std::get<blocks::MoveAbsoluteGoal>(ptp())) + "\n" +
                  textOf(std::get<blocks::MoveRelativeGoal>(relative()));
  } else {
    const auto by = arm::toControllerJoints(planner_.joints() + dice_.joints(0.3));
    const auto to = arm::toControllerJoints(planner_.joints() + dice_.joints(0.3));
    const auto speed = arm::toControllerJoints(dice_.joints(0.4));
    goal.script = fmt::format(
        "PVTEnter(0)\nPVTPoint({},{},{:.3f})\nPVTPoint({},0,0,0,0,0,0,{:.3f})\nPVTExit()", fmt::join(by, ","),
        fmt::join(speed, ","), dice_.within(0.5, 2.0), fmt::join(to, ","), dice_.within(0.5, 2.0));
  }
  return goal;
}

StepGoal RandomProgram::frame() {
  const double by = dice_.within(-50, 50);
  if (dice_.coin()) {
    blocks::ChangeBaseGoal goal;
    goal.transformation = {by, -by, 20, 0, 0, by};
    return goal;
  }
  blocks::ChangeTcpGoal goal;
  goal.tcp_offset = {0, 0, 120 + by, 0, 0, by};
  return goal;
}

void RandomProgram::carry(Step& step) {
  // Blocks that change frames have no such keys.
  if (std::holds_alternative<blocks::ChangeBaseGoal>(step.goal) ||
      std::holds_alternative<blocks::ChangeTcpGoal>(step.goal) || dice_.coin()) {
    return;
  }
  std::set<std::string> carried;
  for (const Step& before : cell.robots.front().program.front().steps) {
    if (!before.attach.empty()) carried.insert(before.attach);
    if (!before.detach.empty()) carried.erase(before.detach);
  }
  if (carried.empty()) {
    step.attach = "sheet";
  } else if (carried.size() == 1) {
    (dice_.coin() ? step.attach : step.detach) = step.attach.empty() && dice_.coin() ? "clip" : "";
    if (step.attach.empty()) step.detach = "sheet";
  } else {
    step.detach = "clip";
  }
  if (!step.attach.empty() && carried.count(step.attach) > 0) step.attach.clear();
}

bool RandomProgram::add(Step step) {
  const auto base = planner_.setting().base;
  const bool is_right = std::visit([](const auto& goal) { return blocks::check(goal).empty(); }, step.goal);
  if (!is_right) return false;
  const blocks::Order order = std::visit([&](const auto& goal) { return orderOf(goal, base); }, step.goal);
  if (!order.commands) return false;
  planning::ScriptPlanner tried(planner_);
  for (const script::ScriptCommand& command : *order.commands) {
    const auto planned = tried.append(command, tried.duration() + std::chrono::seconds(1));
    if (!planned || !planned->planned || !tried.jointsKnown()) return false;
  }
  planner_ = std::move(tried);
  cell.robots.front().program.front().steps.push_back(std::move(step));
  return true;
}

void RandomProgram::endAtHome() {
  Robot& robot = cell.robots.front();
  // What is carried stays so: a program of one way needs no home that is as it was.
  blocks::MoveAbsoluteGoal goal;
  goal.data_format = static_cast<int>(blocks::AbsoluteFormat::Jpp);
  goal.target = robot.stations.front().degrees;
  goal.speed = 50;
  goal.accel_time = 300;
  Step step;
  step.goal = goal;
  if (!add(std::move(step))) throw std::runtime_error("no way home");
}

}  // namespace cobot_command::cell
