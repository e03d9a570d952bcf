#include "cobot_command/blocks/jog.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jog/jog_plan.h"
#include "jog/jog_run.h"
#include "shared/parameter_checks.h"
#include <fmt/format.h>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/tables/refusal.h"

namespace cobot_command::blocks {
namespace {

constexpr double kMostMm = 10000;
constexpr double kMostDeg = 720;

bool is(int mode, JogMode which) {
  return mode == static_cast<int>(which);
}

bool movesIn(const JogGoal& goal, std::size_t first, std::size_t count) {
  return std::any_of(goal.directions.begin() + static_cast<std::ptrdiff_t>(first),
                     goal.directions.begin() + static_cast<std::ptrdiff_t>(first + count),
                     [](int direction) { return direction != 0; });
}

/// Empty: nothing is wrong with them.
std::string faultOfDirections(const JogGoal& goal) {
  if (goal.mode < 0 || goal.mode > static_cast<int>(JogMode::Axes)) {
    return fmt::format("mode is {}; allowed: 0 (FRAME), 1 (TOOL), 2 (AXES)", goal.mode);
  }
  for (std::size_t i = 0; i < goal.directions.size(); ++i) {
    if (goal.directions[i] >= -1 && goal.directions[i] <= 1) continue;
    return fmt::format("directions[{}] is {}; allowed: -1, 0, 1", i, goal.directions[i]);
  }
  if (!movesIn(goal, 0, 6)) return "all directions are 0; allowed: at least one that is not 0";
  if (is(goal.mode, JogMode::Tool) && movesIn(goal, 0, 3) && movesIn(goal, 3, 3)) {
    return "the directions shift and turn the tool, and its axes would turn with it; allowed in TOOL: either "
           "a shift or a turn";
  }
  return "";
}

std::string faultOf(const char* field, double increment, double most) {
  if (std::isnan(increment) || isWithin(increment, 0, most)) return "";  // what is no number is told apart
  return fmt::format("{} is {}; allowed: 0..{}", field, increment, most);
}

/// Empty: nothing is wrong with them. Precondition: the directions are right.
std::string faultOfIncrements(const JogGoal& goal) {
  if (auto fault = faultOf("increment_mm", goal.increment_mm, kMostMm); !fault.empty()) return fault;
  if (auto fault = faultOf("increment_deg", goal.increment_deg, kMostDeg); !fault.empty()) return fault;
  const bool has_mm = goal.increment_mm > 0;
  const bool has_deg = goal.increment_deg > 0;
  if (!has_mm && !has_deg) return "";
  const bool of_axes = is(goal.mode, JogMode::Axes);
  const bool shifts = !of_axes && movesIn(goal, 0, 3);
  const bool turns = of_axes || movesIn(goal, 3, 3);
  if (has_mm == shifts && has_deg == turns) return "";
  return fmt::format(
      "increment_mm is {} and increment_deg {}, and the directions {}; allowed: an increment for each kind "
      "of direction used and for no other, or no increment",
      goal.increment_mm, goal.increment_deg, shifts ? (turns ? "shift and turn" : "shift") : "turn");
}

bool turnsTwice(const JogGoal& goal) {
  return std::count_if(goal.directions.begin() + 3, goal.directions.end(),
                       [](int direction) { return direction != 0; }) > 1;
}

bool isNumber(int number) {
  return number == JogGoal::kActive || tables::isIndex(number);
}

}  // namespace

ErrorTable JogGoal::errors() {
  return ErrorTable()
      .instead({{motion_error::kOtherBlockBusy, jog_error::kMotionActive},
                {own_error::kOrphanMoves, jog_error::kMotionActive}})
      .anyCommand()
      .underInterface()
      .inCell()
      .motion()
      .shared({own_error::kNotListening, own_error::kEmergencyStop, own_error::kRobotError,
               own_error::kStopNotConfirmed})
      .shared(motion_error::kSpeedRangePercent, "speed is negative or above 100; 0 means 10 %")
      .condition(own_error::kNotPlannable,
                 "cannot occur: within the ranges there is no other reason to refuse")
      .shared(own_error::kNotFinite, "speed or an increment is NaN")
      .shared(own_error::kStartUnknown,
              "the position of the robot is unknown, so that limits and singularities cannot be checked: no "
              "status stream; or, in FRAME and TOOL, the active base or TCP is defined in the project and "
              "its value is unknown")
      .shared(own_error::kNoModel,
              "the command layer has no model of the arm: limits and singularities cannot be monitored")
      .row(jog_error::kMotionActive, "Motion active", "Wait until the robot is at standstill, or stop it",
           "another command is Busy, or the robot moves: a jog is never queued and never replaces another "
           "command")
      .row(jog_error::kTwoRotations, "Two rotations by increment", "Turn about one axis after the other",
           "FRAME or TOOL with an increment and more than one direction about an axis: the result would "
           "depend on the order")
      .row(jog_error::kInput, "Jog input invalid", kSetInRange,
           "mode is not 0..2; a direction is not -1, 0 or 1, or all are 0; TOOL with a shift and a turn at "
           "once; an increment is negative, above 10000 mm or 720 deg, or does not match the directions")
      .row(tables::table_error::kFrameIndex, "Frame number invalid", "Give -1 (active) or a configured frame",
           "FRAME, and frame is not -1..15, or that frame has no value in the tables")
      .row(tables::table_error::kToolIndex, "Tool number invalid", "Give -1 (active) or a configured tool",
           "FRAME or TOOL, and tool is not -1..15, or has no value in the tables; or the jog turns about a "
           "tool that is not the active TCP");
}

GoalTraits traitsOf(const JogGoal& /*goal*/) {
  GoalTraits traits;
  traits.may_move = true;
  traits.needs_plan = true;
  traits.needs_standstill = true;
  return traits;
}

std::vector<Failure> check(const JogGoal& goal) {
  ParameterChecks checks;
  const std::string directions = faultOfDirections(goal);
  checks.require(directions.empty(), jog_error::kInput, directions);
  const std::string increments = directions.empty() ? faultOfIncrements(goal) : "";
  checks.require(increments.empty(), jog_error::kInput, increments);
  const bool is_number =
      !std::isnan(goal.speed) && !std::isnan(goal.increment_mm) && !std::isnan(goal.increment_deg);
  checks.require(is_number, own_error::kNotFinite,
                 fmt::format("speed is {}, increment_mm {}, increment_deg {}", goal.speed, goal.increment_mm,
                             goal.increment_deg));
  checks.require(std::isnan(goal.speed) || isWithin(goal.speed, 0, 100), motion_error::kSpeedRangePercent,
                 fmt::format("speed is {}; allowed: 0..100 %", goal.speed));
  if (is(goal.mode, JogMode::Axes)) return std::move(checks).violations();
  const bool steps = goal.increment_mm > 0 || goal.increment_deg > 0;
  checks.require(!steps || !turnsTwice(goal), jog_error::kTwoRotations,
                 fmt::format("directions are {}", fmt::join(goal.directions, " ")));
  checks.require(isNumber(goal.frame), tables::table_error::kFrameIndex,
                 fmt::format("frame is {}", goal.frame));
  checks.require(isNumber(goal.tool), tables::table_error::kToolIndex, fmt::format("tool is {}", goal.tool));
  return std::move(checks).violations();
}

Outcome plan(const JogGoal& goal, const PlanningScene& scene) {
  constexpr Block kThis = kBlock<JogGoal>;
  if (scene.arm == nullptr) return toRejection(kThis, {{own_error::kNoModel, "", ""}});
  const bool is_known = scene.start && scene.start->joints && scene.start->joints->allFinite();
  if (!is_known) return toRejection(kThis, {{own_error::kStartUnknown, scene.why_unknown, ""}});
  const auto planned = planJog(goal, scene);
  if (!planned) return toRejection(kThis, {planned.error()});
  Outcome outcome;
  JogReport report;
  report.plan = *planned;
  outcome.detail = Detail(std::move(report));
  return outcome;
}

std::unique_ptr<Run> runOf(const JogGoal& /*goal*/, GoalId id, const Outcome& planned, Instant now) {
  return std::make_unique<JogRun>(id, planned.detail.as<JogReport>().plan, now);
}

}  // namespace cobot_command::blocks
