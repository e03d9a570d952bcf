#include "cobot_command/planning/script_planner.h"

#include <string>
#include <utility>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/overloaded.h"
#include "cobot_command/motion/planner.h"

namespace cobot_command::planning {
namespace {

using protocol::SixNumbers;

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
  return jointTarget(command) || (move && std::holds_alternative<arm::JointVector>(move->offset));
}

}  // namespace

ScriptPlanner::ScriptPlanner(arm::ArmModel arm, const Start& start)
    : arm_(std::move(arm)),
      end_(start.joints),
      base_(start.base),
      tcp_(start.tcp),
      speed_override_(start.speed_override) {}

motion::Setting ScriptPlanner::setting() const {
  return {base_.value_or(arm::Pose::Identity()), tcp_.value_or(arm::Pose::Identity()), speed_override_};
}

Result<PlannedStep, motion::Refusal> ScriptPlanner::append(const protocol::ScriptCommand& command) {
  PlannedStep nothing;
  nothing.start = duration_;
  return std::visit(Overloaded{[&](const protocol::Ptp& ptp) { return append(ScriptMotion(ptp)); },
                               [&](const protocol::Line& line) { return append(ScriptMotion(line)); },
                               [&](const protocol::Circle& circle) { return append(ScriptMotion(circle)); },
                               [&](const protocol::MovePtp& move) { return append(ScriptMotion(move)); },
                               [&](const protocol::MoveLine& move) { return append(ScriptMotion(move)); },
                               [&](const protocol::ChangeBase& change) -> Appended {
                                 base_ = frameOf(change.base, "RobotBase");
                                 return nothing;
                               },
                               [&](const protocol::ChangeTcp& change) -> Appended {
                                 tcp_ = frameOf(change.tcp, "NOTOOL");
                                 return nothing;
                               },
                               [&](const auto&) -> Appended { return nothing; }},
                    command);
}

ScriptPlanner::Appended ScriptPlanner::append(const ScriptMotion& motion) {
  const auto command = toMotion(motion);
  if (!command) return refuse(command.error());
  if (!end_ || !(framesKnown() || isInJointSpace(*command))) return appendUnplanned(*command);

  auto planned = motion::plan(arm_, *end_, *command, setting());
  if (!planned) return refuse(std::move(planned.error()));
  PlannedStep step;
  step.trajectory = std::move(*planned);
  step.start = duration_;
  step.duration = step.trajectory->duration();
  end_ = step.trajectory->end().position;
  duration_ += step.duration;
  return step;
}

ScriptPlanner::Appended ScriptPlanner::appendUnplanned(const motion::Command& command) {
  PlannedStep step;
  step.planned = false;
  step.start = duration_;
  const arm::JointVector* target = jointTarget(command);
  if (!target) {
    end_.reset();
    return step;
  }
  // Planned from its own target it says all that can be said without the start.
  auto checked = motion::plan(arm_, *target, command, setting());
  if (!checked) return refuse(std::move(checked.error()));
  end_ = *target;
  return step;
}

}  // namespace cobot_command::planning
