#include "cobot_command/planning/script_planner.h"

#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/motion/planner.h"
#include "cobot_command/planning/sampling.h"

namespace cobot_command::planning {
namespace {

using script::SixNumbers;

/// A frame given by value or by name; of the names only `identity` is known.
std::optional<arm::Pose> frameOf(const std::variant<SixNumbers, std::string>& given, const char* identity) {
  if (const auto* value = std::get_if<SixNumbers>(&given)) return arm::toPose(*value);
  if (std::get<std::string>(given) == identity) return arm::Pose::Identity();
  return std::nullopt;
}

const arm::JointVector* jointTarget(const motion::Command& command) {
  const auto* ptp = std::get_if<motion::Ptp>(&command);
  return ptp ? std::get_if<arm::JointVector>(&ptp->target) : nullptr;
}

bool isInJointSpace(const motion::Command& command) {
  const auto* move = std::get_if<motion::MovePtp>(&command);
  const auto* pvt = std::get_if<motion::Pvt>(&command);
  return jointTarget(command) || (move && std::holds_alternative<arm::JointVector>(move->offset)) ||
         (pvt && std::holds_alternative<std::vector<motion::PvtJointPoint>>(pvt->points));
}

/// [m]; 0: no blend, or none by radius.
double radiusOf(const std::optional<motion::Blend>& blend) {
  const auto* radius = blend ? std::get_if<motion::BlendRadius>(&*blend) : nullptr;
  return radius ? radius->metres : 0.0;
}

/// Room for rounding where lengths are compared [m].
constexpr double kRounding = 1e-6;

/// How far the TCP travels [m]: exact on a line, to a thousandth on a circle.
double toolWay(const arm::ArmModel& arm, const motion::Trajectory& trajectory, const arm::Pose& tcp) {
  constexpr std::size_t kPoints = 65;
  const std::vector<arm::Pose> poses = toolPath(arm, trajectory, tcp, kPoints);
  double way = 0.0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    way += (poses[i].translation() - poses[i - 1].translation()).norm();
  }
  return way;
}

}  // namespace

ScriptPlanner::ScriptPlanner(arm::ArmModel arm, const Start& start)
    : arm_(std::move(arm)),
      end_(start.joints),
      base_(start.base),
      tcp_(start.tcp),
      speed_override_(start.speed_override) {}

motion::Setting ScriptPlanner::setting() const {
  return {base_.value_or(arm::Pose::Identity()), tcp_.value_or(arm::Pose::Identity()), speed_override_,
          kStartTolerance};
}

Result<PlannedStep, motion::Refusal> ScriptPlanner::append(const script::ScriptCommand& command,
                                                           Duration arrival) {
  return std::visit(
      [&](const auto& one) -> Appended {
        if constexpr (std::is_constructible_v<ScriptMotion, decltype(one)>) {
          return append(ScriptMotion(one), arrival);
        } else if constexpr (std::is_same_v<decltype(one), const script::PvtExit&>) {
          return append(ScriptMotion(pvt_), arrival);
        } else if constexpr (std::is_same_v<decltype(one), const script::StopAndClearBuffer&>) {
          return stop(arrival);
        } else {
          note(one);
          PlannedStep no_motion;
          no_motion.start = duration_;
          return no_motion;
        }
      },
      command);
}

void ScriptPlanner::note(const script::ChangeBase& change) {
  base_ = frameOf(change.base, script::kRobotBase);
}

void ScriptPlanner::note(const script::ChangeTcp& change) {
  tcp_ = frameOf(change.tcp, script::kNoTool);
  blend_.reset();
}

void ScriptPlanner::note(const script::QueueTag& tag) {
  if (tag.wait) blend_.reset();
}

void ScriptPlanner::note(const script::WaitQueueTag&) {
  blend_.reset();
}

void ScriptPlanner::follow(const Start& frames) {
  const bool same_tcp = tcp_ && frames.tcp ? arm::isSamePose(*tcp_, *frames.tcp) : !tcp_ && !frames.tcp;
  if (!same_tcp) blend_.reset();
  base_ = frames.base;
  tcp_ = frames.tcp;
  speed_override_ = frames.speed_override;
}

void ScriptPlanner::note(const script::ContinueVJog&) {
  end_.reset();
  blend_.reset();
}

void ScriptPlanner::note(const script::ContinueVLine&) {
  end_.reset();
  blend_.reset();
}

ScriptPlanner::Appended ScriptPlanner::append(const ScriptMotion& motion, Duration arrival) {
  const auto command = toMotion(motion);
  if (!command) return refuse(command.error());
  if (!end_ || !(framesKnown() || isInJointSpace(*command))) return appendUnplanned(*command);

  auto planned = motion::plan(arm_, *end_, *command, setting());
  if (!planned) return refuse(std::move(planned.error()));
  const std::optional<motion::Blend> blend = blendOf(motion);
  PlannedStep step;
  step.misfit = misfitOf(**planned, blend);
  motion::Passage passage{Duration::zero(), *planned, *planned};
  if (blend_ && arrival < duration_) {
    passage = motion::passInto(arm_, last_, *planned, setting().tcp, *blend_, duration_ - arrival);
  }
  step.trajectory = passage.path;
  step.start = std::max(arrival, duration_ - passage.overlap);
  step.duration = step.trajectory->duration();
  end_ = step.trajectory->end().position;
  duration_ = step.start + step.duration;
  last_ = passage.planned;
  blend_ = blend;
  return step;
}

std::optional<BlendMisfit> ScriptPlanner::misfitOf(const motion::Trajectory& trajectory,
                                                   const std::optional<motion::Blend>& blend) const {
  const double before = radiusOf(blend_);
  const double behind = radiusOf(blend);
  if (before <= 0.0 && behind <= 0.0) return std::nullopt;
  const double allowed = 0.5 * toolWay(arm_, trajectory, setting().tcp);
  const BlendMisfit misfit{std::max(before, behind), allowed, before > behind};
  return misfit.radius > allowed + kRounding ? std::optional(misfit) : std::nullopt;
}

PlannedStep ScriptPlanner::stop(Duration arrival) {
  PlannedStep step;
  step.start = std::min(arrival, duration_);
  step.planned = arrival >= duration_;
  if (!step.planned) {
    end_.reset();
    blend_.reset();
    duration_ = arrival;
  }
  return step;
}

ScriptPlanner::Appended ScriptPlanner::appendUnplanned(const motion::Command& command) {
  PlannedStep step;
  step.planned = false;
  step.start = duration_;
  const arm::JointVector* target = jointTarget(command);
  if (!target) {
    end_.reset();
    blend_.reset();
    return step;
  }
  // Planned from its own target it says all that can be said without the start.
  auto checked = motion::plan(arm_, *target, command, setting());
  if (!checked) return refuse(std::move(checked.error()));
  end_ = *target;
  blend_.reset();
  return step;
}

}  // namespace cobot_command::planning
