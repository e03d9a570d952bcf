#include "cobot_command/blocks/ways_back/retrace.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "shared/parameter_checks.h"
#include "ways_back/retrace_run.h"
#include <fmt/format.h>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/refusal_failure.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/units.h"
#include "cobot_command/motion/planner.h"
#include "cobot_command/path/pvt_block.h"
#include "cobot_command/path/retrace.h"

namespace cobot_command::blocks {
namespace {

using path::DrivenPath;
using path::Retrace;

constexpr double kLeastSpeed = 1;  // [%]
constexpr double kRetraceSpeed = 25;

/// What its plan hands to its run.
struct RetraceOrder {
  Order order;
  RetraceWay way;
};

std::string allowedText(const DrivenPath& driven, int method) {
  std::vector<std::string> allowed;
  if (const auto range = driven.passedOf(method)) {
    allowed.push_back(fmt::format("{}..{}", range->first, range->last));
  }
  if (driven.beginOf(method)) allowed.emplace_back("-1 (START)");
  if (driven.stood()) allowed.emplace_back("-2 (END)");
  if (allowed.empty()) allowed.emplace_back("nothing");
  return fmt::format("{} of load_path {}; known are goals {}..{}", fmt::join(allowed, ", "), method,
                     driven.firstGoal(), driven.lastGoal());
}

Failure notDriven(const std::string& what, const DrivenPath& driven, int method) {
  return {own_error::kPointNotDriven, fmt::format("{}; allowed: {}", what, allowedText(driven, method)), ""};
}

Failure notDriven(const RetraceGoal& goal, const DrivenPath& driven, int method) {
  const std::string what = goal.point == RetraceGoal::kStart
                               ? fmt::format("the start of load_path {}", method)
                               : fmt::format("point {} of load_path {}", goal.point, method);
  return notDriven(what + " was not passed, or is no longer recorded", driven, method);
}

struct Target {
  Duration time{};
  std::optional<arm::JointVector> joints;
};

Result<Target, Failure> targetOf(const RetraceGoal& goal, const DrivenPath& driven) {
  if (goal.point == RetraceGoal::kEnd) {
    if (driven.stood()) return Target{driven.reached(), driven.stood()};
    return refuse(
        notDriven("the position at which the robot left the path is not certain", driven, driven.lastGoal()));
  }
  const int method = goal.method_id == 0 ? driven.lastGoal() : goal.method_id;
  const auto time =
      goal.point == RetraceGoal::kStart ? driven.beginOf(method) : driven.passed(method, goal.point);
  if (!time) return refuse(notDriven(goal, driven, method));
  return Target{*time, std::nullopt};
}

Failure notOnTheWay(const DrivenPath& driven, const arm::JointVector& joints) {
  const path::WayMiss miss = path::missOf(driven, joints);
  return {own_error::kNotOnTheWay,
          fmt::format("no point of the path is within 0.1 deg of each joint of the robot; at the nearest "
                      "one, J{} is {:.2f} deg off",
                      miss.joint + 1, radToDeg(miss.gap)),
          ""};
}

std::optional<Failure> objectionTo(const PlanningScene& scene) {
  if (scene.arm == nullptr) return Failure{own_error::kNoModel, "", ""};
  if (!scene.start || !scene.start->joints) return Failure{own_error::kStartUnknown, scene.why_unknown, ""};
  if (scene.driven == nullptr) return Failure{own_error::kNothingDriven, "", ""};
  if (scene.is_pvt_refused) {
    return Failure{own_error::kPvtUnavailable, "the controller has refused to enter a PVT", ""};
  }
  return std::nullopt;
}

Result<Retrace, Failure> retraceOf(const RetraceGoal& goal, const PlanningScene& scene) {
  const DrivenPath& driven = *scene.driven;
  auto target = targetOf(goal, driven);
  if (!target) return refuse(target.error());
  const arm::JointVector& joints = *scene.start->joints;
  const auto place = path::placeOn(driven, joints, scene.give_up);
  if (!place) {
    if (scene.give_up && scene.give_up()) return refuse(Failure{own_error::kPlanningBudget, "", ""});
    return refuse(notOnTheWay(driven, joints));
  }
  Retrace retrace;
  retrace.from = *place;
  retrace.to = target->time;
  retrace.rate = std::max((goal.speed == 0 ? kRetraceSpeed : goal.speed) / kPercent * scene.speed_share,
                          path::kLeastRetraceRate);
  retrace.start = joints;
  retrace.end = target->joints;
  return retrace;
}

Result<Outcome, Failure> planned(const RetraceGoal& goal, const PlanningScene& scene) {
  if (auto objection = objectionTo(scene)) return refuse(*std::move(objection));
  const auto retrace = retraceOf(goal, scene);
  if (!retrace) return refuse(retrace.error());
  const auto most = static_cast<std::size_t>(scene.path.block_points);
  auto points = path::pvtOf(*retrace, *scene.driven, most);
  if (!points) {
    return refuse(Failure{own_error::kPvtTooLong,
                          fmt::format("{:.0f} s of the path's time would take more than {} points in one PVT",
                                      std::abs(toSeconds(retrace->to - retrace->from)), most),
                          ""});
  }
  path::PvtBlock block;
  block.points = *std::move(points);
  // At the full project speed: a slower one only takes longer.
  const auto motion = motion::plan(*scene.arm, retrace->start, motion::Pvt{block.points}, motion::Setting());
  if (!motion) return refuse(toFailure(motion.error()));
  Outcome outcome;
  outcome.planned = fromSeconds(toSeconds((*motion)->duration()) / scene.start->speed_override);
  outcome.detail = Detail(RetraceOrder{motionOrder(path::scriptOf(block, {})), {retrace->from, retrace->to}});
  return outcome;
}

}  // namespace

ErrorTable RetraceGoal::errors() {
  return ErrorTable()
      .anyCommand()
      .turn()
      .underInterface()
      .inCell()
      .shared({motion_error::kReceiveTag, motion_error::kMotionFailed, own_error::kPlanningBudget,
               own_error::kNoFreeTag, own_error::kTagLost, own_error::kNotAtTarget,
               own_error::kStoppedElsewhere})
      .shared(own_error::kJointLimit, "a joint would leave its software limits, which have changed since")
      .shared(own_error::kJointSpeed,
              "cannot occur: it is no faster than the path, which was planned within the rated speeds")
      .shared(motion_error::kSpeedRangePercent, "speed is below 1, above 100 or not a number; 0 means 25 %")
      .shared(own_error::kStartUnknown,
              "the position of the robot is unknown: no status stream, or the robot is in a motion, or "
              "paused in a motion, whose end is unknown")
      .shared(own_error::kNoModel, "the command layer has no model of the arm")
      .shared(own_error::kNotPlannable,
              "the retrace would take more than three hours: at a low speed, and a low speed override")
      .row(own_error::kPvtUnavailable, "PVT not available", "Move the robot out by another command",
           "the controller has refused to enter a PVT since the link was made")
      .row(own_error::kPvtTooLong, "Too long for one PVT", "Choose a nearer point, and continue from there",
           "the retrace would take more points than ~pvt_block_points; their number does not depend on the "
           "speed")
      .row(own_error::kNothingDriven, "No path is recorded", "Run a path with load_path first",
           "no load_path goal has moved this controller's robot since the command layer was started; or the "
           "last one was stopped beside its path, to continue from there")
      .row(
          own_error::kPointNotDriven, "Point was not passed", kSetInRange,
          "the robot has not reached or passed point in that goal; or point is further back than the last "
          "1000 points; or END, and the robot had left its path; or point is below -2, or method_id negative")
      .row(own_error::kNotOnTheWay, "Robot is not on the path",
           "Bring it back to the path by another motion, or move it out by another command",
           "no point of the path is within 0.1 deg of each joint of the robot, up to 3 s after the point "
           "where it was last seen on the path");
}

GoalTraits traitsOf(const RetraceGoal& goal) {
  GoalTraits traits;
  traits.buffer_mode = bufferModeOf(goal.buffer_mode);
  traits.may_move = true;
  traits.needs_plan = true;
  return traits;
}

std::vector<Failure> check(const RetraceGoal& goal) {
  ParameterChecks checks;
  checks.bufferMode(goal.buffer_mode);
  checks.require(goal.speed == 0 || isWithin(goal.speed, kLeastSpeed, kPercent),
                 motion_error::kSpeedRangePercent,
                 fmt::format("speed is {}; allowed: 1..100 %, and 0 for {} %", goal.speed, kRetraceSpeed));
  checks.require(
      goal.point >= RetraceGoal::kEnd && goal.method_id >= 0, own_error::kPointNotDriven,
      fmt::format("point is {}, method_id {}; allowed: 0 or more each, point also -1 (START) and -2 (END)",
                  goal.point, goal.method_id));
  return std::move(checks).violations();
}

Outcome plan(const RetraceGoal& goal, const PlanningScene& scene) {
  auto outcome = planned(goal, scene);
  return outcome ? *std::move(outcome) : toRejection(kBlock<RetraceGoal>, {outcome.error()});
}

std::unique_ptr<Run> runOf(const RetraceGoal& /*goal*/, GoalId id, const Outcome& planned, Instant /*now*/) {
  Command command;
  command.block = kBlock<RetraceGoal>;
  command.traits.awaits_motion = true;
  const auto& retrace = planned.detail.as<RetraceOrder>();
  command.order = [order = retrace.order](const arm::Pose& /*base*/) { return order; };
  return std::make_unique<RetraceRun>(id, std::move(command), retrace.way);
}

}  // namespace cobot_command::blocks
