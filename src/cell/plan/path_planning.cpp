#include "plan/path_planning.h"

#include <cmath>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/common/units.h"
#include "cobot_command/planning/script_motion.h"

namespace cobot_command::cell {
namespace {

constexpr double kEndTolerance = 1e-6;  // [rad]

template <class Command>
std::optional<motion::Blend> blendOfCommand(const Command& command) {
  if constexpr (std::is_constructible_v<planning::ScriptMotion, Command>) {
    return planning::blendOf(planning::ScriptMotion(command));
  } else {
    return std::nullopt;
  }
}

/// What a PLine rounds at a corner depends on the project speed with which each of the two was planned.
template <class Command>
bool isPassedAsPLine(const Command& command) {
  constexpr bool kIsPLine =
      std::is_same_v<Command, script::PLine> || std::is_same_v<Command, script::MovePLine>;
  return kIsPLine && blendOfCommand(command);
}

/// What the rules of its block say of a step, in the words of the catalogue.
template <class Goal>
std::optional<std::string> objectionOfBlock(const Goal& goal) {
  const auto failures = blocks::check(goal);
  if (failures.empty()) return std::nullopt;
  return blocks::toRejection(blocks::kBlock<Goal>, failures).error_description;
}

}  // namespace

arm::Pose tcpOf(const Robot& robot) {
  return arm::toPose(robot.tcp);
}

PathPlanning::PathPlanning(const Begin& begin, std::string field)
    : separate_(begin.arm, {begin.joints, begin.standing.base, begin.standing.tcp, begin.speed_override}),
      flowing_(separate_),
      carried_(begin.standing.carried),
      field_(std::move(field)) {}

PlannedPath PathPlanning::plan(const Path& path, const arm::JointVector& end) {
  PlannedPath planned;
  planned.name = path.name;
  for (std::size_t index = 0; index < path.steps.size() && faults_.empty(); ++index) {
    planStep(path.steps[index], index, planned);
  }
  if (faults_.empty()) checkEnd(path, end);
  planned.carried_at_end = carried_;
  planned.duration = std::max(flowing_.duration(), ready_);
  return planned;
}

Standing PathPlanning::end() const {
  const planning::ScriptPlanner::Start end = separate_.end();
  return {end.base.value_or(arm::Pose::Identity()), end.tcp.value_or(arm::Pose::Identity()), carried_};
}

void PathPlanning::planStep(const Step& step, std::size_t index, PlannedPath& path) {
  step_ = index;
  const auto objection = std::visit([](const auto& goal) { return objectionOfBlock(goal); }, step.goal);
  if (objection) return fault(step.place, "", *objection, "write a step that its block accepts");
  const arm::Pose base = separate_.end().base.value_or(arm::Pose::Identity());
  const blocks::Order order =
      std::visit([&](const auto& goal) { return blocks::orderOf(goal, base); }, step.goal);
  if (!order.commands) {
    return fault(step.place, "", "has lines whose effect is unknown", "use commands that can be planned");
  }
  PlannedFrame frame;
  frame.step = index;
  frame.lines = order.lines;
  frame.carried = carried_;
  frame.stands = !blends(step);
  frame.dwell = step.dwell;
  frame.begin = std::max(flowing_.duration(), ready_);
  for (const script::ScriptCommand& command : *order.commands) {
    if (!planCommand(command, step, frame)) return;
  }
  frame.end = std::max(flowing_.duration(), ready_);
  if (!path.frames.empty() && !path.frames.back().stands) path.frames.back().end = frame.begin;
  if (frame.stands) ready_ = frame.end + fromSeconds(step.dwell);
  if (!step.attach.empty()) carried_.insert(step.attach);
  if (!step.detach.empty()) carried_.erase(step.detach);
  path.frames.push_back(std::move(frame));
}

bool PathPlanning::planCommand(const script::ScriptCommand& command, const Step& step, PlannedFrame& frame) {
  if (std::visit([](const auto& one) { return isPassedAsPLine(one); }, command)) {
    fault(step.place, "",
          "has a PLine that blends: its rounded corner depends on the speed, and is not swept",
          "set its blending to 0, so that it stops, or use Line");
    return false;
  }
  const auto planned = separate_.append(command, separate_.duration() + kLate);
  if (!planned) {
    fault(step.place, "", fmt::format("cannot be planned: {}", planned.error().message), "");
    return false;
  }
  const bool is_known = planned->planned && separate_.jointsKnown() && separate_.framesKnown();
  if (!is_known) {
    fault(step.place, "", "leads to an unknown position",
          "give bases and TCPs by value, and use no stops or velocities");
    return false;
  }
  if (!planned->trajectory) {
    (void)flowing_.append(command, ready_);
    return true;
  }
  const auto blend = std::visit([](const auto& one) { return blendOfCommand(one); }, command);
  const motion::Setting setting = separate_.setting();
  frame.motions.push_back({planned->trajectory, blend, setting.tcp, setting.base});
  const auto flowing = flowing_.append(command, ready_);
  if (flowing && frame.motions.size() == 1) frame.begin = flowing->start;
  return true;
}

void PathPlanning::checkEnd(const Path& path, const arm::JointVector& end) {
  const arm::JointVector& last = separate_.joints();
  for (Eigen::Index joint = 0; joint < last.size(); ++joint) {
    if (std::abs(last[joint] - end[joint]) <= kEndTolerance) continue;
    return fault(path.place, "to",
                 fmt::format("is {}, whose J{} is {:.4f} deg, but its steps end at {:.4f} deg", path.to,
                             joint + 1, radToDeg(end[joint]), radToDeg(last[joint])),
                 path.steps.back().at == path.to
                     ? "the last step reaches the pose of the station with other joints: use another "
                       "station, or turn the arm in a motion before it"
                     : "let the last step end at the joints of the station");
  }
}

void PathPlanning::fault(const Place& place, const std::string& field, std::string found,
                         std::string advice) {
  const std::string where = field.empty() ? fmt::format("{}.steps[{}]", field_, step_) : field_ + "." + field;
  faults_.push_back({place.file, place.line, place.column, where, std::move(found), "", std::move(advice)});
}

}  // namespace cobot_command::cell
