#include "cobot_command/cell/program/canonical.h"

#include <cmath>

#include <fmt/format.h>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/overloaded.h"
#include "cobot_command/common/sha256.h"

namespace cobot_command::cell {

namespace {

/// Whoever changes what is written below counts it up: an artifact of before is then stale.
constexpr int kFormat = 1;

/// Lines of words; every text has its length in front of it, so that none can be taken for more words.
class Lines {
 public:
  Lines& begin(const char* word) {
    text_ += text_.empty() ? "" : "\n";
    text_ += word;
    return *this;
  }
  Lines& add(const std::string& word) {
    text_ += fmt::format(" {}:{}", word.size(), word);
    return *this;
  }
  Lines& add(double number) {
    text_ += fmt::format(" {}", number == 0 ? 0.0 : number);  // there is no -0 in what a cell means
    return *this;
  }
  Lines& add(int number) {
    text_ += fmt::format(" {}", number);
    return *this;
  }
  Lines& add(bool truth) { return add(truth ? 1 : 0); }
  Lines& add(const Eigen::Vector3d& point) { return add(point.x()).add(point.y()).add(point.z()); }
  Lines& add(const arm::Pose& pose) {
    add(Eigen::Vector3d(pose.translation()));
    for (int row = 0; row < 3; ++row) addRounded(pose.linear().row(row));
    return *this;
  }
  /// Of what was calculated: sines and roots differ in their last digits.
  Lines& addRounded(const Eigen::Vector3d& direction) {
    constexpr double kDigits = 1e12;
    for (const double number : direction) add(std::round(number * kDigits) / kDigits);
    return *this;
  }
  template <class Numbers>
  Lines& addAll(const Numbers& numbers) {
    for (const auto number : numbers) add(number);
    return *this;
  }
  [[nodiscard]] std::string text() const { return text_ + "\n"; }

 private:
  std::string text_;
};

void write(Lines& lines, const Parameters& p) {
  lines.begin("geometry").add(p.voxel).add(p.step_bound).add(p.margin).add(p.tracking);
  lines.add(p.body_tolerance).add(p.body_cell).add(p.speed_override);
  lines.begin("zones").add(p.zone_size).add(p.zone_overlap).add(static_cast<int>(p.split));
  lines.add(p.max_zones).add(p.max_states);
  lines.begin("times");
  for (const Duration time : {p.lease, p.report_period, p.lookahead, p.wait_timeout, p.aging}) {
    lines.add(std::to_string(time.count()));
  }
}

void write(Lines& lines, const std::vector<Shape>& shapes) {
  for (const Shape& shape : shapes) {
    std::visit(
        Overloaded{[&](const CapsuleShape& s) { lines.begin("capsule").add(s.from).add(s.to).add(s.radius); },
                   [&](const SphereShape& s) { lines.begin("sphere").add(s.radius); },
                   [&](const CylinderShape& s) { lines.begin("cylinder").add(s.radius).add(s.length); },
                   [&](const BoxShape& s) { lines.begin("box").add(s.size); }},
        shape.kind);
    lines.add(shape.at);
  }
}

template <class Move>
void writeMotion(Lines& lines, const Move& goal) {
  lines.add(goal.command_id).add(goal.data_format).add(goal.speed).add(goal.accel_time);
  lines.add(goal.blending_enable).add(goal.blending_value).add(goal.disable_precise_positioning);
  lines.add(goal.exit_node);
}

void write(Lines& lines, const StepGoal& any) {
  std::visit(
      Overloaded{
          [&](const blocks::MoveAbsoluteGoal& goal) {
            writeMotion(lines.begin("move_absolute").add(goal.movement_command).addAll(goal.target), goal);
            lines.add(goal.robot_pose_enable).addAll(goal.robot_pose);
          },
          [&](const blocks::MoveRelativeGoal& goal) {
            writeMotion(lines.begin("move_relative").add(goal.movement_command).addAll(goal.target), goal);
          },
          [&](const blocks::MoveCircleGoal& goal) {
            writeMotion(lines.begin("move_circle").addAll(goal.arc_point).addAll(goal.end_point), goal);
            lines.add(goal.arc_angle);
          },
          [&](const blocks::ChangeBaseGoal& goal) { lines.begin("change_base").addAll(goal.transformation); },
          [&](const blocks::ChangeTcpGoal& goal) {
            lines.begin("change_tcp").addAll(goal.tcp_offset).add(goal.weight);
            lines.addAll(goal.moment_of_inertia).addAll(goal.mass_center);
          },
          [&](const blocks::RunScriptGoal& goal) {
            lines.begin("script").add(goal.script).add(goal.await_motion).add(goal.reply_timeout);
          }},
      any);
}

void write(Lines& lines, const Step& step) {
  lines.begin("step").add(step.name);
  write(lines, step.goal);
  lines.begin("then").add(step.attach).add(step.dwell).add(step.detach);
  if (step.output) {
    lines.begin("output").add(step.output->module).add(step.output->output).add(step.output->value);
  }
  if (step.input) {
    lines.begin("input").add(step.input->module).add(step.input->input).add(step.input->value);
    lines.add(step.input->timeout);
  }
}

void write(Lines& lines, const Robot& robot) {
  lines.begin("robot").add(robot.name).add(robot.model).add(sha256Hex(arm::ArmModel::urdfOf(robot.model)));
  lines.add(robot.name_space).add(robot.base).add(robot.home).add(robot.holds);
  lines.addAll(robot.tcp);
  write(lines, robot.tool);
  for (const Station& station : robot.stations) {
    lines.begin("station").add(station.name).addAll(station.degrees);
  }
  for (const Path& path : robot.program) {
    lines.begin("path").add(path.name).add(path.from).add(path.to);
    for (const Step& step : path.steps) write(lines, step);
  }
}

void write(Lines& lines, const Mechanism& mechanism) {
  lines.begin("mechanism").add(mechanism.name).add(static_cast<int>(mechanism.axis)).add(mechanism.at);
  lines.addRounded(mechanism.direction).add(mechanism.home).add(mechanism.holds);
  write(lines, mechanism.shapes);
  for (const MechanismPosition& position : mechanism.positions) {
    lines.begin("position").add(position.name).add(position.value);
  }
  for (const MechanismPath& path : mechanism.program) {
    lines.begin("path").add(path.name).add(path.from).add(path.to).add(path.duration);
    lines.add(path.controllable_go).add(path.controllable_book);
  }
}

}  // namespace

std::string canonicalText(const Cell& cell) {
  Lines lines;
  lines.begin("cobot_command cell").add(kFormat).add(cell.name);
  write(lines, cell.parameters);
  for (const Robot& robot : cell.robots) write(lines, robot);
  for (const Part& part : cell.parts) {
    lines.begin("part").add(part.name).add(part.on).add(part.at);
    write(lines, part.shapes);
  }
  for (const Obstacle& obstacle : cell.obstacles) {
    lines.begin("obstacle").add(obstacle.name);
    write(lines, obstacle.shapes);
  }
  for (const Mechanism& mechanism : cell.mechanisms) write(lines, mechanism);
  return lines.text();
}

std::string hashOf(const Cell& cell) {
  return sha256Hex(canonicalText(cell));
}

}  // namespace cobot_command::cell
