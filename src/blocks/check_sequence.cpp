#include "cobot_command/blocks/check_sequence.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/joint_path.h"
#include "cobot_command/blocks/shared/refusal_failure.h"
#include "cobot_command/common/units.h"
#include "cobot_command/planning/script_planner.h"

namespace cobot_command::blocks {
namespace {

using Start = planning::ScriptPlanner::Start;

Block blockOf(const SequenceStep& step) {
  return std::visit([](const auto& goal) { return kBlock<std::decay_t<decltype(goal)>>; }, step);
}

bool isJoints(const std::vector<double>& joints_deg) {
  return joints_deg.size() == arm::kJointCount &&
         std::all_of(joints_deg.begin(), joints_deg.end(), [](double v) { return std::isfinite(v); });
}

/// Its joints are absent when they are not known, or not those of an arm.
Start startOf(const CheckSequenceGoal& goal, const PlanningScene& scene) {
  Start start = scene.start.value_or(Start{std::nullopt, std::nullopt, std::nullopt, 1.0});
  if (goal.start_joints.empty()) return start;
  start.joints.reset();
  if (isJoints(goal.start_joints)) {
    arm::ControllerJoints joints_deg{};
    std::copy(goal.start_joints.begin(), goal.start_joints.end(), joints_deg.begin());
    start.joints = arm::toJointVector(joints_deg);
  }
  return start;
}

/// Of joints that are none; there may be any number of them.
std::string foundStart(const std::vector<double>& joints) {
  if (joints.empty()) return "";
  if (joints.size() != arm::kJointCount) return fmt::format("there are {} start_joints", joints.size());
  return fmt::format("start_joints are {}", fmt::join(joints, ", "));
}

Detail blamed(int faulty_step) {
  return faulty_step < 0 ? Detail() : Detail(blaming(static_cast<std::size_t>(faulty_step)));
}

std::vector<Failure> check(const CheckSequenceGoal& goal, const Start& start, const PlanningScene& scene) {
  std::vector<Failure> failures;
  if (!start.joints) {
    const std::string found = foundStart(goal.start_joints);
    failures.push_back({own_error::kStartUnknown, found.empty() ? scene.why_unknown : found, ""});
  }
  if (scene.arm == nullptr) failures.push_back({own_error::kNoModel, "", ""});
  if (!goal.steps_fault.empty()) {
    failures.push_back({own_error::kStepsUnreadable, goal.steps_fault, "", blamed(goal.faulty_step)});
  } else if (goal.steps.empty() || goal.steps.size() > CheckSequenceGoal::kMostSteps) {
    failures.push_back(
        {own_error::kStepCount, foundSteps(goal.steps.size(), CheckSequenceGoal::kMostSteps), ""});
  }
  return failures;
}

/// What is wrong with a step: its errors, in the order of its table, and where.
struct Fault {
  std::vector<Failure> failures;
  std::optional<std::array<double, 6>> point;
};

/// The refusals of an input have no place on the path.
bool hasPoint(motion::Refusal::Reason reason) {
  using Reason = motion::Refusal::Reason;
  return reason != Reason::NotFinite && reason != Reason::BadParameter && reason != Reason::DegenerateCircle;
}

/// Checks and plans one step after the other.
class Sequence {
 public:
  /// Precondition: the scene has an arm.
  Sequence(const CheckSequenceGoal& goal, const Start& start, const PlanningScene& scene)
      : goal_(goal),
        arm_(*scene.arm),
        planner_(arm_, start),
        give_up_(scene.give_up),
        speed_share_(scene.speed_share) {}

  Outcome run() {
    const std::size_t all = goal_.steps.size() + (goal_.comes_round ? 1 : 0);
    for (std::size_t i = 0; i < all && report_.failed_step < 0 && !gaveUp(); ++i) {
      auto planned = std::visit([this](const auto& step) { return plan(step); }, stepAt(i));
      if (!planned) {
        fail(i, planned.error());
        continue;
      }
      const auto misfit = planned->misfit;
      keep(std::move(*planned));
      if (i < goal_.steps.size()) noteTool(i);
      if (misfit) failBlend(*misfit);
    }
    addJointPaths();
    if (report_.failed_step < 0) outcome_.planned = planner_.duration();
    report_.steps.resize(std::min(report_.steps.size(), goal_.steps.size()));
    outcome_.detail = Detail(std::move(report_));
    return std::move(outcome_);
  }

 private:
  [[nodiscard]] bool gaveUp() const { return give_up_ && give_up_(); }
  /// From 0; the one behind the last is the first again.
  [[nodiscard]] const SequenceStep& stepAt(std::size_t i) const {
    return goal_.steps[i % goal_.steps.size()];
  }

  template <class Step>
  Result<planning::PlannedStep, Fault> plan(const Step& step) {
    if (auto failures = check(step); !failures.empty()) return refuse(Fault{std::move(failures), {}});
    const auto base = planner_.end().base;
    if (traitsOf(step).needs_base && !base) return refuse(frameUnknown());
    const Order order = slowed(orderOf(step, base.value_or(arm::Pose::Identity())), speed_share_);
    auto planned = planner_.append(order.commands->front());
    if (!planned) {
      const motion::Refusal& refusal = planned.error();
      Fault fault{{toFailure(refusal)}, {}};
      if (hasPoint(refusal.reason)) fault.point = arm::toControllerPose(refusal.point);
      return refuse(std::move(fault));
    }
    if (!planned->planned) return refuse(frameUnknown());
    return std::move(*planned);
  }

  static Fault frameUnknown() {
    return {{{own_error::kBaseUnknown,
              "identified only by its name in the project; its value is unknown here", ""}},
            {}};
  }

  void keep(planning::PlannedStep planned) {
    StepReport report;
    report.start = planned.start;
    report.duration = planned.duration;
    report_.steps.push_back(std::move(report));
    planned_.push_back(std::move(planned));
    settings_.push_back(planner_.setting());
  }

  /// The controller takes a tool that is too heavy, and data sheets are not the last word: it is told, and no
  /// reason to refuse (doc/actions/change_tcp.md).
  void noteTool(std::size_t step) {
    const auto* tool = std::get_if<ChangeTcpGoal>(&goal_.steps[step]);
    const double payload = arm_.ratings().payload;
    if (tool == nullptr || !tool->tcp_name.empty() || tool->weight <= payload) return;
    const std::string note = fmt::format(
        "the tool has {} kg, the payload of {} is {} kg: expect its motions to fail in the controller "
        "(16#222)",
        tool->weight, arm_.name(), payload);
    report_.steps[step].error_description = note;
    std::string& text = outcome_.error_description;
    text += fmt::format("{}step {}: {}", text.empty() ? "" : "; ", step + 1, note);
  }

  /// The step whose radius it is fails, which may be the motion before. The point is the corner.
  void failBlend(const planning::BlendMisfit& misfit) {
    std::size_t step = planned_.size() - 1;
    if (misfit.of_before) {
      do --step;
      while (!planned_[step].trajectory);
    }
    const arm::Pose flange = arm::forwardKinematics(arm_, planned_[step].trajectory->end().position);
    const motion::Setting& setting = settings_[step];
    fail(step,
         {{{own_error::kBlendingTooLarge,
            fmt::format("the radius is {:.1f} mm, at most {:.1f} mm fit: half of the path {} the corner",
                        mToMm(misfit.radius), mToMm(misfit.allowed), misfit.of_before ? "after" : "to"),
            ""}},
          arm::toControllerPose(setting.base.inverse() * flange * setting.tcp)});
  }

  void fail(std::size_t place, const Fault& fault) {
    const std::size_t step = place % goal_.steps.size();
    Outcome refusal = toRejection(blockOf(goal_.steps[step]), fault.failures);
    if (place != step) refusal.error_description += "; this is when it is repeated after the last step";
    report_.steps.resize(place + 1);
    planned_.resize(std::min(planned_.size(), report_.steps.size()));
    outcome_ = toRejection(kBlock<CheckSequenceGoal>, {stepRefused(step, goal_.steps.size(), refusal)});
    const StepReport& own = outcome_.detail.as<SequenceReport>().steps.back();
    StepReport& report = report_.steps[step];
    report.error_id = own.error_id;
    report.error_description = own.error_description;
    report.offending_point = fault.point;
    report_.failed_step = static_cast<int>(step);
  }

  /// Each to where the next motion takes over, which is before its own end where they blend.
  void addJointPaths() {
    Duration until = Duration::max();
    for (std::size_t i = planned_.size(); i-- > 0;) {
      const planning::PlannedStep& step = planned_[i];
      if (!step.trajectory) continue;
      report_.steps[i].joint_path =
          jointPath(*step.trajectory, until == Duration::max() ? until : until - step.start);
      until = step.start;
    }
  }

  const CheckSequenceGoal& goal_;
  const arm::ArmModel& arm_;
  planning::ScriptPlanner planner_;
  const GiveUp& give_up_;
  double speed_share_;
  std::vector<planning::PlannedStep> planned_;
  std::vector<motion::Setting> settings_;  ///< that each was planned with
  SequenceReport report_;
  Outcome outcome_;  ///< without that, until the end
};

}  // namespace

ErrorTable CheckSequenceGoal::errors() {
  return ErrorTable()
      .row(own_error::kStartUnknown, "Start unknown",
           "Give six start_joints, or wait until the status stream shows the robot at standstill",
           "start_joints are neither six finite numbers nor empty; or they are empty, and the position of "
           "the robot, or the position after the commands already sent, is unknown")
      .shared(own_error::kNoModel, "the command layer has no model of the arm")
      .shared({own_error::kPlanningBudget, own_error::kShutDown})
      .shared(own_error::kQueueFull, "the queue of checks to be planned is full")
      .shared(own_error::kStepCount, "there are no steps, or more than 200")
      .shared({own_error::kStepRefused})
      .row(own_error::kStepsUnreadable, "Steps cannot be read",
           "Set the kind of each step to one that SequenceStep lists", "a step has an unknown kind");
}

GoalTraits traitsOf(const CheckSequenceGoal& /*goal*/) {
  GoalTraits traits;
  traits.way = Way::Plan;
  return traits;
}

std::vector<Failure> check(const CheckSequenceGoal& /*goal*/) {
  return {};
}

Outcome plan(const CheckSequenceGoal& goal, const PlanningScene& scene) {
  const Start start = startOf(goal, scene);
  if (const auto failures = check(goal, start, scene); !failures.empty()) {
    return toRejection(kBlock<CheckSequenceGoal>, failures);
  }
  return Sequence(goal, start, scene).run();
}

}  // namespace cobot_command::blocks
