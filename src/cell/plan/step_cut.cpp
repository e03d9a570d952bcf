#include "cobot_command/cell/plan/step_cut.h"

#include <cmath>
#include <utility>

#include "plan/cut_measure.h"

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"

namespace cobot_command::cell {
namespace {

using blocks::AbsoluteFormat;
using blocks::Movement;
using blocks::RelativeFormat;
using script::DataFormat;

/// What the halves do, where they do not follow from the whole.
struct Halves {
  StepGoal before;
  StepGoal behind;
};

/// The formats of lines stand in the same order for targets, offsets in the base,
/// and offsets in the tool.
int absoluteFormatOf(int relative) {
  const int tool = static_cast<int>(RelativeFormat::Tpp);
  const int base = static_cast<int>(RelativeFormat::Cpp);
  return relative >= tool ? relative - tool + base : relative;
}

class Cutter {
 public:
  Cutter(const CutScene& scene, Duration time)
      : scene_(scene), motion_(*scene.whole.trajectory), time_(time) {}

  [[nodiscard]] std::optional<Halves> halves(const StepGoal& goal) const {
    return std::visit([this](const auto& one) { return of(one); }, goal);
  }

 private:
  [[nodiscard]] std::optional<Halves> of(const blocks::MoveAbsoluteGoal& goal) const {
    if (goal.movement_command == static_cast<int>(Movement::Line)) return lines(goal);
    const bool in_joints = goal.data_format == static_cast<int>(AbsoluteFormat::Jpp);
    // A pose would be reached with the bits and turns of the cut, which may be others than those of the
    // start.
    return Halves{passed(toJoints(goal, time_)), in_joints ? goal : toJoints(goal, motion_.duration())};
  }

  [[nodiscard]] std::optional<Halves> of(const blocks::MoveRelativeGoal& goal) const {
    blocks::MoveAbsoluteGoal whole;
    whole.command_id = goal.command_id;
    whole.movement_command = goal.movement_command;
    whole.data_format = absoluteFormatOf(goal.data_format);
    whole.speed = goal.speed;
    whole.accel_time = goal.accel_time;
    whole.blending_enable = goal.blending_enable;
    whole.blending_value = goal.blending_value;
    whole.disable_precise_positioning = goal.disable_precise_positioning;
    whole.exit_node = goal.exit_node;
    whole.buffer_mode = goal.buffer_mode;
    whole.check_only = goal.check_only;
    if (goal.movement_command == static_cast<int>(Movement::Line)) {
      whole.target = poseAt(motion_.duration());
      return lines(whole);
    }
    return Halves{passed(toJoints(whole, time_)), toJoints(whole, motion_.duration())};
  }

  [[nodiscard]] std::optional<Halves> of(const blocks::MoveCircleGoal& goal) const {
    blocks::MoveCircleGoal before = passed(goal);
    before.arc_angle = 0;
    before.arc_pose.reset();
    before.end_pose.reset();
    before.arc_point = poseAt(timeOfProgress(motion_, 0.5 * scene_.progress));
    before.end_point = poseAt(time_);
    blocks::MoveCircleGoal behind = goal;
    behind.arc_pose.reset();
    behind.arc_point = poseAt(timeOfProgress(motion_, 0.5 * (1.0 + scene_.progress)));
    if (goal.arc_angle != 0) {
      // It ends somewhere on its circle, and holds its orientation: as an arc to that very pose does.
      behind.arc_angle = 0;
      behind.end_pose.reset();
      behind.end_point = poseAt(motion_.duration());
    }
    return Halves{before, behind};
  }

  template <class Other>
  [[nodiscard]] std::optional<Halves> of(const Other& /*scripts, and what does not move*/) const {
    return std::nullopt;
  }

  [[nodiscard]] std::optional<Halves> lines(const blocks::MoveAbsoluteGoal& goal) const {
    const auto format = blocks::formatOf(goal);
    if (!format) return std::nullopt;
    blocks::MoveAbsoluteGoal before = passed(goal);
    const bool in_percent = format->speed == DataFormat::Speed::Percent;
    before.data_format = static_cast<int>(in_percent ? AbsoluteFormat::Cpp : AbsoluteFormat::Cap);
    before.target_pose.reset();
    before.target = poseAt(time_);
    return Halves{before, goal};
  }

  [[nodiscard]] blocks::MoveAbsoluteGoal toJoints(blocks::MoveAbsoluteGoal goal, Duration time) const {
    goal.data_format = static_cast<int>(AbsoluteFormat::Jpp);
    goal.target_pose.reset();
    goal.robot_pose_enable = false;
    goal.target = arm::asWritten(arm::toControllerJoints(motion_.at(time).position));
    return goal;
  }

  template <class Goal>
  [[nodiscard]] static Goal passed(Goal goal) {
    goal.blending_enable = true;
    goal.blending_value = 100;
    return goal;
  }

  /// The TCP in the active base.
  [[nodiscard]] blocks::SixValues poseAt(Duration time) const {
    const arm::Pose tcp = arm::forwardKinematics(scene_.arm, motion_.at(time).position) * scene_.whole.tcp;
    return arm::asWritten(arm::toControllerPose(scene_.whole.base.inverse() * tcp));
  }

  const CutScene& scene_;
  const motion::Trajectory& motion_;
  Duration time_;
};

}  // namespace

std::optional<StepCut> cutStep(const arm::ArmModel& arm, const Step& step, const PlannedMotion& motion,
                               double speed_override, Duration time) {
  if (time <= Duration::zero() || time >= motion.trajectory->duration()) return std::nullopt;
  const CutScene scene{arm, motion, speed_override, motion.trajectory->progress(time)};
  const auto halves = Cutter(scene, time).halves(step.goal);
  if (!halves) return std::nullopt;
  const auto measure = measureCut(scene, halves->before, halves->behind);
  if (!measure || measure->deviation > kMostDeviation || measure->turn > kMostTurn) return std::nullopt;
  StepCut cut;
  cut.before.name = step.name;
  cut.before.goal = halves->before;
  cut.before.place = step.place;
  cut.behind = step;
  cut.behind.goal = halves->behind;
  cut.progress = scene.progress;
  cut.measure = *measure;
  return cut;
}

}  // namespace cobot_command::cell
