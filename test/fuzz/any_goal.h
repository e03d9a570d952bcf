// Goals of all blocks, good ones of which any fields are given any values: an input that changes little gets
// as deep as a good goal does.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "block_goals.h"
#include "fuzz_input.h"

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::fuzz {

/// Planning a path takes time in proportion to its duration, so a fuzzer that is let go slower than this
/// finds nothing but slow inputs [mm/s].
inline constexpr double kSlowestPlannedPath = 50;

class AnyGoal {
 public:
  /// `plans`: the core has an arm, so paths are not to take too long.
  AnyGoal(FuzzInput& input, bool plans) : input_(input), plans_(plans) {}

  [[nodiscard]] blocks::Goal next() { return anyOf<blocks::Goal>(static_cast<const blocks::Goal*>(nullptr)); }

 private:
  static constexpr std::size_t kMostSteps = 3;

  template <class Variant, class... Kinds>
  Variant anyOf(const std::variant<Kinds...>* /*list*/) {
    const std::size_t chosen = input_.choice(sizeof...(Kinds));
    Variant goal;
    std::size_t place = 0;
    static_cast<void>(((place++ == chosen && (goal = any(static_cast<const Kinds*>(nullptr)), true)) || ...));
    return goal;
  }

  blocks::ConnectGoal any(const blocks::ConnectGoal* /*kind*/) {
    blocks::ConnectGoal goal{"robot", 5890, 10, {}};
    begin();
    vary(goal.host, goal.port, goal.timeout, goal.status_port);
    return goal;
  }

  blocks::ExchangeConfigurationGoal any(const blocks::ExchangeConfigurationGoal* /*kind*/) {
    auto goal = testing::good<blocks::ExchangeConfigurationGoal>();
    begin();
    vary(goal.name, goal.exec_mode, goal.priority, goal.settings.log_level, goal.settings.delay_time,
         goal.settings.wait_for_nr_of_cmd, goal.settings.life_sign_time_out, goal.settings.sync_delay,
         goal.settings.sync_reaction);
    return goal;
  }

  blocks::MoveAbsoluteGoal any(const blocks::MoveAbsoluteGoal* /*kind*/) {
    auto goal = testing::good<blocks::MoveAbsoluteGoal>();
    begin();
    vary(goal.command_id, goal.movement_command, goal.data_format, goal.target, goal.target_pose);
    varyMotion(goal);
    vary(goal.robot_pose_enable, goal.robot_pose, goal.check_only);
    return bounded(goal, goal.movement_command == static_cast<int>(blocks::Movement::Line));
  }

  blocks::MoveRelativeGoal any(const blocks::MoveRelativeGoal* /*kind*/) {
    auto goal = testing::good<blocks::MoveRelativeGoal>();
    begin();
    vary(goal.command_id, goal.movement_command, goal.data_format, goal.target);
    varyMotion(goal);
    vary(goal.check_only);
    return bounded(goal, goal.movement_command == static_cast<int>(blocks::Movement::Line));
  }

  blocks::MoveCircleGoal any(const blocks::MoveCircleGoal* /*kind*/) {
    auto goal = testing::good<blocks::MoveCircleGoal>();
    begin();
    vary(goal.command_id, goal.data_format, goal.arc_point, goal.end_point, goal.arc_pose, goal.end_pose);
    varyMotion(goal);
    vary(goal.arc_angle, goal.check_only);
    return bounded(goal, true);
  }

  blocks::ChangeBaseGoal any(const blocks::ChangeBaseGoal* /*kind*/) {
    auto goal = testing::good<blocks::ChangeBaseGoal>();
    begin();
    vary(goal.command_id, goal.transformation, goal.base_pose, goal.base_name, goal.exit_node,
         goal.buffer_mode);
    return goal;
  }

  blocks::ChangeTcpGoal any(const blocks::ChangeTcpGoal* /*kind*/) {
    auto goal = testing::good<blocks::ChangeTcpGoal>();
    begin();
    vary(goal.command_id, goal.tcp_offset, goal.weight, goal.moment_of_inertia, goal.mass_center,
         goal.tcp_name, goal.exit_node, goal.buffer_mode);
    return goal;
  }

  blocks::ProgramControlGoal any(const blocks::ProgramControlGoal* /*kind*/) {
    blocks::ProgramControlGoal goal;
    begin();
    vary(goal.command_id, goal.command);
    return goal;
  }

  blocks::ExitListenNodeGoal any(const blocks::ExitListenNodeGoal* /*kind*/) {
    blocks::ExitListenNodeGoal goal;
    begin();
    vary(goal.buffer_mode);
    return goal;
  }

  blocks::RunScriptGoal any(const blocks::RunScriptGoal* /*kind*/) {
    auto goal = testing::good<blocks::RunScriptGoal>();
    begin();
    vary(goal.script, goal.await_motion, goal.reply_timeout, goal.buffer_mode);
    return goal;
  }

  blocks::CheckSequenceGoal any(const blocks::CheckSequenceGoal* /*kind*/) {
    blocks::CheckSequenceGoal goal;
    goal.steps.resize(input_.choice(kMostSteps + 1));
    for (auto& step : goal.steps) {
      step = anyOf<blocks::SequenceStep>(static_cast<const blocks::SequenceStep*>(nullptr));
    }
    begin();
    varyFault(goal.steps_fault);
    if (varied()) {
      anyJoints(goal.start_joints);
    }
    return goal;
  }

  blocks::PickAndPlaceGoal any(const blocks::PickAndPlaceGoal* /*kind*/) {
    blocks::PickAndPlaceGoal goal;
    goal.steps.resize(input_.choice(kMostSteps + 1));
    for (auto& step : goal.steps) {
      step.move = any(&step.move);
      begin();
      vary(step.output, step.input, step.dwell);
    }
    begin();
    varyFault(goal.steps_fault);
    vary(goal.cycles, goal.buffer_mode, goal.check_only);
    return goal;
  }

  blocks::LoadPathGoal any(const blocks::LoadPathGoal* /*kind*/) {
    auto goal = testing::good<blocks::LoadPathGoal>();
    goal.path.resize(input_.choice(kMostSteps + 1), goal.path.front());
    goal.number_of_moves = static_cast<int>(goal.path.size());
    for (path::PathPoint& point : goal.path) {
      begin();
      vary(point.move_id, point.move_type, point.target_type, point.interpolation, point.pose,
           point.pose_type, point.pose_id, point.ref_frame_type, point.ref_frame_id, point.joints,
           point.via_pose, point.termination_type, point.command_tolerance, point.robot_configuration,
           point.profile_type);
      begin();
      vary(point.speed, point.acceleration, point.deceleration, point.acceleration_jerk,
           point.deceleration_jerk, point.orientation_speed, point.orientation_acceleration,
           point.orientation_deceleration, point.tracking_axis_position);
      const bool is_ptp = is(point.interpolation, path::Interpolation::Ptp);
      if (plans_ && !is_ptp && point.speed > 0 && point.speed < kSlowestPlannedPath) {
        point.speed += kSlowestPlannedPath;
      }
    }
    begin();
    varyFault(goal.path_fault);
    vary(goal.start_index, goal.number_of_moves, goal.enable_tracking[0], goal.enable_tracking[1],
         goal.execution, goal.allow_approximation, goal.buffer_mode, goal.max_deviation, goal.check_only);
    varyPoses(goal);
    return goal;
  }

  blocks::FollowJointTrajectoryGoal any(const blocks::FollowJointTrajectoryGoal* /*kind*/) {
    auto goal = testing::good<blocks::FollowJointTrajectoryGoal>();
    goal.points.resize(input_.choice(kMostSteps + 1), goal.points.back());
    for (blocks::TrajectoryPoint& point : goal.points) {
      begin();
      vary(point.time);
      if (varied()) anyJoints(point.positions);
      if (varied()) anyJoints(point.velocities);
    }
    begin();
    varyFault(goal.names_fault);
    vary(goal.path_tolerance, goal.goal_tolerance, goal.goal_time_tolerance, goal.starts_in,
         goal.buffer_mode);
    return goal;
  }

  blocks::JogGoal any(const blocks::JogGoal* /*kind*/) {
    auto goal = testing::good<blocks::JogGoal>();
    begin();
    vary(goal.mode, goal.directions, goal.speed, goal.increment_mm, goal.increment_deg, goal.frame,
         goal.tool);
    return goal;
  }

  blocks::ReturnToPrimaryGoal any(const blocks::ReturnToPrimaryGoal* /*kind*/) {
    auto goal = testing::good<blocks::ReturnToPrimaryGoal>();
    begin();
    vary(goal.return_mode, goal.trajectory_mode, goal.speed, goal.distance_limit, goal.allow_differences);
    if (varied()) goal.place.reset();
    return goal;
  }

  blocks::RetraceGoal any(const blocks::RetraceGoal* /*kind*/) {
    blocks::RetraceGoal goal;
    begin();
    vary(goal.point, goal.method_id, goal.speed, goal.buffer_mode);
    return goal;
  }

  blocks::RunProgramGoal any(const blocks::RunProgramGoal* /*kind*/) {
    blocks::RunProgramGoal goal;
    begin();
    vary(goal.cycles);
    varyFault(goal.paths_fault);
    if (varied()) goal.paths = {"HOME>T1", ""};
    return goal;
  }

  blocks::StopGoal any(const blocks::StopGoal* /*kind*/) { return {}; }

  blocks::ChangeLoadGoal any(const blocks::ChangeLoadGoal* /*kind*/) {
    blocks::ChangeLoadGoal goal;
    begin();
    vary(goal.weight, goal.buffer_mode);
    return goal;
  }

  blocks::SetOutputGoal any(const blocks::SetOutputGoal* /*kind*/) {
    auto goal = testing::good<blocks::SetOutputGoal>();
    begin();
    vary(goal, goal.buffer_mode);
    return goal;
  }

  blocks::WaitForInputGoal any(const blocks::WaitForInputGoal* /*kind*/) {
    auto goal = testing::good<blocks::WaitForInputGoal>();
    begin();
    vary(goal, goal.buffer_mode);
    return goal;
  }

  blocks::WaitTimeGoal any(const blocks::WaitTimeGoal* /*kind*/) {
    auto goal = testing::good<blocks::WaitTimeGoal>();
    begin();
    vary(goal.time, goal.buffer_mode);
    return goal;
  }

  /// The inputs that all motions have.
  template <class Motion>
  void varyMotion(Motion& goal) {
    vary(goal.speed, goal.accel_time, goal.blending_enable, goal.blending_value,
         goal.disable_precise_positioning, goal.exit_node, goal.buffer_mode);
  }

  template <class Motion>
  [[nodiscard]] Motion bounded(Motion goal, bool along_a_path) const {
    if (plans_ && along_a_path && goal.speed < kSlowestPlannedPath) {
      goal.speed += kSlowestPlannedPath;  // what is out of range by far stays so
    }
    return goal;
  }

  /// Which fields of the next struct are varied.
  void begin() {
    mask_ = 0;
    for (const int shift : {0, 8, 16}) mask_ |= static_cast<unsigned>(input_.byte()) << shift;
  }
  bool varied() {
    const bool is_varied = (mask_ & 1) != 0;
    mask_ >>= 1;
    return is_varied;
  }
  template <class... Fields>
  void vary(Fields&... fields) {
    ((varied() ? any(fields) : void()), ...);
  }

  /// In place of its points, with the first one as their template.
  void varyPoses(blocks::LoadPathGoal& goal) {
    if (!varied() || goal.path.empty()) return;
    goal.path.resize(1);
    goal.path.front().joints = {};
    goal.path.front().pose = {};
    std::vector<blocks::FramedPose> poses(input_.choice(kMostSteps + 1));
    for (blocks::FramedPose& pose : poses) any(pose);
    goal.number_of_moves = static_cast<int>(poses.size());
    blocks::placeAtPoses(goal, poses.size(), [&](std::size_t index) { return poses[index]; });
  }
  /// The layer's own words, from above the core.
  void varyFault(std::string& field) {
    if (varied()) {
      field = foreignText(input_.text());
    }
  }
  /// Six, a few, or many.
  void anyJoints(std::vector<double>& joints) {
    joints.resize(input_.choice(8));
    for (double& joint : joints) {
      any(joint);
    }
    if (input_.choice(16) == 0) {
      joints.resize(10000, input_.number());
    }
  }

  void any(bool& field) { field = input_.flag(); }
  void any(int& field) { field = input_.whole(); }
  void any(double& field) { field = input_.number(); }
  /// Short ones, and those that are longer than any name.
  void any(std::string& field) {
    const std::size_t times = input_.choice(16) == 0 ? 500 : 1;
    const std::string text = input_.text();
    field.clear();
    for (std::size_t i = 0; i < times; ++i) {
      field += text;
    }
  }
  template <class Value, std::size_t kSize>
  void any(std::array<Value, kSize>& field) {
    const std::size_t which = input_.choice(kSize + 1);
    for (std::size_t i = 0; i < kSize; ++i) {
      if (which == kSize || which == i) {
        any(field[i]);
      }
    }
  }
  template <class Value>
  void any(std::optional<Value>& field) {
    field.emplace();
    any(*field);
  }
  void any(blocks::FramedPose& field) {
    field = testing::framedPose();
    const auto mask = std::exchange(mask_, input_.byte());
    vary(field.frame, field.position, field.quaternion, field.fault, field.latest);
    if (varied()) {
      field.frame_in_robot_base.reset();
    } else if (varied()) {
      field.frame_in_robot_base->translation().x() = input_.number();
    }
    mask_ = mask;
  }
  void any(blocks::WaitForInputGoal& field) { vary(field.module, field.input, field.value, field.timeout); }
  void any(blocks::SetOutputGoal& field) {
    field.module = input_.flag() ? "EndModule" : "ControlBox";
    vary(field.kind, field.output, field.value, field.at_once);
    if (input_.choice(8) == 0) {
      any(field.module);
    }
  }

  FuzzInput& input_;
  bool plans_;
  unsigned mask_ = 0;
};

}  // namespace cobot_command::fuzz
