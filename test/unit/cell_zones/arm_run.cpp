#include "arm_run.h"

#include <stdexcept>

#include "cobot_command/blocks/list/goal.h"

namespace cobot_command::cell {
namespace {

double anySpeed(Dice& dice) {
  return dice.upTo(3) == 0 ? 1.0 : dice.ofAnySize(0.05, 1.0);
}

/// In time, late in the corner, or later than its end.
Duration arrivalOf(const std::vector<MadeMotion>& made, bool is_free, Duration last, Dice& dice) {
  if (made.empty()) return Duration::zero();
  const Duration end = made.back().end;
  if (!is_free) return end + fromSeconds(dice.within(0, 1));
  const double left = toSeconds(end - made.back().start);
  const Duration arrival =
      end - fromSeconds(dice.coin() ? dice.ofAnySize(0.001, 1.0) : left * dice.within(-0.1, 1.0));
  return std::max(arrival, last);
}

}  // namespace

std::vector<MadeMotion> runOf(const Cell& cell, const PlannedPath& path, ProjectSpeed speed, Dice& dice) {
  const Robot& robot = cell.robots.front();
  const double highest = cell.parameters.speed_override;
  planning::ScriptPlanner planner(*arm::ArmModel::named(robot.model),
                                  {robot.stations.front().joints, arm::Pose::Identity(),
                                   arm::toPose(robot.tcp), highest * anySpeed(dice)});
  std::vector<MadeMotion> made;
  std::set<std::string> carried;
  Duration last{};
  for (std::size_t frame = 0; frame < path.frames.size(); ++frame) {
    const Step& step = robot.program.front().steps[path.frames[frame].step];
    if (speed == ProjectSpeed::Changing) {
      planning::ScriptPlanner::Start frames = planner.end();
      frames.speed_override = highest * anySpeed(dice);
      planner.follow(frames);
    }
    const bool is_free =
        frame == 0 || path.frames[frame - 1].stands == false || path.frames[frame - 1].motions.empty();
    const Duration arrival = arrivalOf(made, is_free, last, dice);
    last = arrival;
    const auto base = planner.setting().base;
    const blocks::Order order = std::visit([&](const auto& goal) { return orderOf(goal, base); }, step.goal);
    std::size_t motion = 0;
    for (const script::ScriptCommand& command : *order.commands) {
      const auto planned = planner.append(command, arrival);
      if (!planned) throw std::runtime_error(planned.error().message);
      if (!planned->trajectory) continue;
      if (!made.empty()) made.back().end = std::min(made.back().end, planned->start);
      made.push_back({frame, motion++, planned->trajectory, planned->start,
                      planned->start + planned->duration, carried});
    }
    if (!step.attach.empty()) carried.insert(step.attach);
    if (!step.detach.empty()) carried.erase(step.detach);
  }
  return made;
}

}  // namespace cobot_command::cell
