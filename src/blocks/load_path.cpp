#include "cobot_command/blocks/load_path.h"

#include <utility>

#include "chain/loaded_path.h"
#include "paths/load_path_run.h"
#include "shared/parameter_checks.h"
#include <fmt/format.h>

#include "cobot_command/arm/any_arm.h"
#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/error_catalogue.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/joint_path.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/path/path_planner.h"

namespace cobot_command::blocks {
namespace {

using path::is;
using path::PathPoint;
using path::PathRefusal;

constexpr double kMostDeviation = 100000;  // [mm]

path::PathSection sectionOf(const LoadPathGoal& goal) {
  return {goal.path, goal.start_index, goal.number_of_moves, 0};
}

bool isLoaded(const LoadPathGoal& goal, int index) {
  return index >= goal.start_index && index - goal.start_index < goal.number_of_moves &&
         index < static_cast<int>(goal.path.size());
}

PathReport blaming(int index, int joint = -1) {
  PathReport report;
  report.error_index = index;
  report.error_joint = joint;
  return report;
}

/// Of the points up to the one to blame.
StepReport blame(const PathRefusal& refusal) {
  StepReport report;
  report.error_id = refusal.error_id;
  report.error_description = forPeople(refusal.found);
  if (refusal.where) report.offending_point = arm::toControllerPose(*refusal.where);
  return report;
}

/// "point 3: ..."; the description of an error names the point for who reads only that.
std::string foundAt(int index, const std::string& found) {
  return index < 0 ? found : fmt::format("point {}: {}", index, found);
}

Failure toFailure(const PathRefusal& refusal, std::vector<StepReport> points,
                  std::shared_ptr<const path::PathPreview> preview = nullptr) {
  PathReport report = blaming(refusal.index, refusal.joint);
  report.points = std::move(points);
  report.preview = std::move(preview);
  return {refusal.error_id, foundAt(refusal.index, refusal.found), "", Detail(std::move(report))};
}

/// Of the points in front of it is only known that they are right by themselves.
std::vector<StepReport> blameAlone(const LoadPathGoal& goal, const PathRefusal& refusal) {
  std::vector<StepReport> points;
  if (refusal.index >= 0) {
    points.resize(static_cast<std::size_t>(refusal.index - goal.start_index));
    points.push_back(blame(refusal));
  }
  return points;
}

Failure toFailure(const LoadPathGoal& goal, const PathRefusal& refusal) {
  return toFailure(refusal, blameAlone(goal, refusal));
}

std::optional<Failure> checkTracking(const LoadPathGoal& goal) {
  if (goal.enable_tracking == path::TrackingFlags()) return std::nullopt;
  for (int index = 0; index < static_cast<int>(goal.path.size()); ++index) {
    const double position = goal.path[static_cast<std::size_t>(index)].tracking_axis_position;
    if (!isLoaded(goal, index) || position == 0.0) continue;
    return Failure{own_error::kTrackingOffset,
                   fmt::format("point {}: tracking_axis_position is {} mm", index, position), "",
                   Detail(blaming(index))};
  }
  return std::nullopt;
}

/// Without a template there are no points. A pose that is wrong comes behind what points say by themselves,
/// as other targets do.
std::optional<PathRefusal> checkPoints(const LoadPathGoal& goal) {
  if (goal.poses_fault && goal.poses_fault->index < 0) return goal.poses_fault;
  auto refusal = path::checkSection(sectionOf(goal));
  return refusal ? std::move(refusal) : goal.poses_fault;
}

/// Without a model, or a place to start from, nothing is planned.
std::optional<PathRefusal> checkWithoutTransform(const LoadPathGoal& goal) {
  bool had_pose = false;
  for (int index = goal.start_index; isLoaded(goal, index); ++index) {
    const PathPoint& point = goal.path[static_cast<std::size_t>(index)];
    const bool has_pose = !is(point.target_type, path::TargetType::Joint);
    if (has_pose && !std::exchange(had_pose, true) && is(point.move_type, path::MoveType::Incremental)) {
      return PathRefusal{load_path_error::kFirstNotAbsolute, index, -1, "its target is INCREMENTAL"};
    }
    if (!is(point.interpolation, path::Interpolation::Ptp)) {
      return PathRefusal{load_path_error::kOnlyPtp, index, -1,
                         fmt::format("interpolation_type is {}", point.interpolation)};
    }
  }
  return std::nullopt;
}

bool knowsStart(const PlanningScene& scene) {
  return !scene.chain.isNone() || (scene.start && scene.start->joints);
}

/// A pose, or an increment of joints that nobody knows, is no place to send a robot to.
std::optional<std::string> faultOfTargets(const LoadPathGoal& goal, bool knows_start) {
  for (int index = goal.start_index; isLoaded(goal, index); ++index) {
    const PathPoint& point = goal.path[static_cast<std::size_t>(index)];
    if (!is(point.target_type, path::TargetType::Joint)) {
      return fmt::format("point {}: its target is a pose", index);
    }
    const bool is_first = index == goal.start_index;
    if (is_first && !knows_start && is(point.move_type, path::MoveType::Incremental)) {
      return fmt::format("point {}: its target is INCREMENTAL", index);
    }
  }
  return std::nullopt;
}

/// Without model or start: why it cannot go out as motions of a script.
std::optional<Failure> checkUnplanned(const LoadPathGoal& goal, const PlanningScene& scene) {
  const bool has_model = scene.arm != nullptr;
  const std::string missing = !has_model                  ? "no model of the arm"
                              : scene.why_unknown.empty() ? "the position of the arm is unknown"
                                                          : scene.why_unknown;
  if (auto refusal = checkWithoutTransform(goal)) {
    refusal->found = fmt::format("{}, and {}", missing, refusal->found);
    return toFailure(goal, *refusal);
  }
  const int error_id = has_model ? own_error::kStartUnknown : own_error::kNoModel;
  if (goal.check_only) return Failure{error_id, has_model ? scene.why_unknown : "", ""};
  if (is(goal.execution, Execution::Pvt)) return Failure{own_error::kPvtUnavailable, missing, ""};
  if (auto found = faultOfTargets(goal, knowsStart(scene))) return Failure{error_id, *std::move(found), ""};
  return std::nullopt;
}

/// As if the arm stood on its first target: where nothing is known of it, no way there is planned.
PlanningScene unplanned(const LoadPathGoal& goal, PlanningScene scene) {
  if (scene.arm == nullptr) scene.arm = &arm::anyArm();
  if (!scene.start) scene.start.emplace();
  if (!scene.start->joints) {
    arm::ControllerJoints first;
    const auto& joints = goal.path[static_cast<std::size_t>(goal.start_index)].joints;
    std::copy_n(joints.begin(), first.size(), first.begin());
    scene.start->joints = arm::toJointVector(first);
  }
  scene.is_pvt_refused = true;
  return scene;
}

path::PathPreview previewOf(const LoadedPath& loaded) {
  return path::previewOf(loaded.plan, loaded.first, loaded.end->scene().arm);
}

/// Planned alone; nothing where there are none, or they are wrong by themselves, or to be told apart.
std::shared_ptr<const LoadedPath> loadInFront(const LoadPathGoal& goal, const PathRefusal& refusal,
                                              const PlanningScene& scene) {
  if (refusal.index <= goal.start_index) return nullptr;
  LoadPathGoal in_front = goal;
  in_front.number_of_moves = refusal.index - goal.start_index;
  return loadPath(in_front, scene).value_or(nullptr);
}

/// With what was planned in front of the point to blame.
Failure refused(const LoadPathGoal& goal, PathRefusal refusal, const PlanningScene& scene) {
  if (refusal.error_id == path::path_error::kWorldUnknown && !goal.world_fault.empty()) {
    refusal.found += "; " + goal.world_fault;
  }
  const bool knows_arm = scene.arm != &arm::anyArm();
  if (!knows_arm) refusal.where.reset();
  if (refusal.index < 0 || !knows_arm) return toFailure(goal, refusal);
  const auto in_front = loadInFront(goal, refusal, scene);
  path::PathPreview preview;
  std::vector<StepReport> points = blameAlone(goal, refusal);
  if (in_front) {
    preview = previewOf(*in_front);
    std::copy(in_front->report.begin(), in_front->report.end(), points.begin());
  }
  preview.refusal = refusal;
  return toFailure(refusal, std::move(points), std::make_shared<const path::PathPreview>(std::move(preview)));
}

std::string reasonOf(const LoadPathGoal& goal, Execution chosen, const PlanningScene& scene) {
  if (scene.arm == nullptr) {
    return "there is no model of the arm: speeds are shares of those of the fastest arms, so that no arm "
           "exceeds the requested speed, and planned_duration is for such an arm";
  }
  if (!knowsStart(scene)) {
    return "the position of the arm is unknown: planned_duration excludes the path to the first point";
  }
  if (!is(goal.execution, Execution::Auto)) return "it was requested";
  return chosen == Execution::Pvt
             ? "model and position of the arm are known, and a PVT represents the whole path"
             : "the controller has refused to enter a PVT";
}

std::vector<int> lostBlends(const LoadedPath& loaded) {
  const auto& points = loaded.plan.points();
  std::vector<int> lost;
  for (std::size_t i = loaded.first; i + 1 < points.size(); ++i) {
    if (points[i].losesBlend()) lost.push_back(points[i].index);
  }
  return lost;
}

}  // namespace

const char* toString(Execution execution) {
  switch (execution) {
    case Execution::Auto:
      return "AUTO";
    case Execution::Script:
      return "SCRIPT";
    case Execution::Pvt:
      return "PVT";
  }
  return "unknown";
}

GoalTraits traitsOf(const LoadPathGoal& goal) {
  GoalTraits traits;
  traits.buffer_mode = bufferModeOf(goal.buffer_mode);
  traits.may_move = true;
  traits.check_only = goal.check_only;
  traits.needs_plan = true;
  traits.needs_automatic = true;
  traits.chains = true;
  return traits;
}

std::vector<Failure> check(const LoadPathGoal& goal) {
  ParameterChecks checks;
  checks.bufferMode(goal.buffer_mode);
  checks.require(goal.execution >= static_cast<int>(Execution::Auto) &&
                     goal.execution <= static_cast<int>(Execution::Pvt),
                 own_error::kExecutionUnknown, fmt::format("execution is {}", goal.execution));
  checks.require(isWithin(goal.max_deviation, 0, kMostDeviation), own_error::kDeviationRange,
                 fmt::format("max_deviation is {}", goal.max_deviation));
  std::vector<Failure> failures = std::move(checks).violations();
  if (auto tracking = checkTracking(goal)) failures.push_back(std::move(*tracking));
  if (!goal.path_fault.empty()) {
    failures.push_back({own_error::kPathUnreadable, goal.path_fault, ""});
  } else if (const auto refusal = checkPoints(goal)) {
    failures.push_back(toFailure(goal, *refusal));
  }
  sortByTable(kBlock<LoadPathGoal>, failures);
  return failures;
}

tables::Use usesOf(const LoadPathGoal& goal) {
  tables::Use use;
  use.user = LoadPathGoal::kName;
  for (int index = goal.start_index; isLoaded(goal, index); ++index) {
    const PathPoint& point = goal.path[static_cast<std::size_t>(index)];
    if (is(point.pose_type, path::MovedFrame::Tool)) use.tools.push_back(point.pose_id);
    if (is(point.ref_frame_type, path::Reference::User)) use.frames.push_back(point.ref_frame_id);
  }
  return use;
}

Outcome plan(const LoadPathGoal& goal, const PlanningScene& scene) {
  constexpr Block kThis = kBlock<LoadPathGoal>;
  const bool is_known = scene.arm != nullptr && knowsStart(scene);
  if (!is_known) {
    if (auto failure = checkUnplanned(goal, scene)) return toRejection(kThis, {*std::move(failure)});
  }
  const PlanningScene used = is_known ? scene : unplanned(goal, scene);
  const auto loaded = loadPath(goal, used);
  if (!loaded) {
    Failure failure = refused(goal, loaded.error(), used);
    // It would be driven as PVT, if that were known.
    if (!knowsStart(scene) && !scene.why_unknown.empty()) failure.found += "; " + scene.why_unknown;
    if (!is_known && failure.error_id == own_error::kNotInAScript) {
      failure.remedy = fmt::format(
          "{}, or set allow_approximation, or give each point what a script can express: no jerk, whole "
          "percents of the rated speed",
          scene.arm == nullptr ? "Start the node with the model of the arm (~robot_model)"
                               : "Have the controller stream the position of the arm");
    }
    return toRejection(kThis, {std::move(failure)});
  }
  PathReport report;
  report.points = (*loaded)->report;
  report.blends_lost = lostBlends(**loaded);
  report.execution = (*loaded)->execution;
  report.execution_reason = reasonOf(goal, (*loaded)->execution, scene);
  report.approximations = (*loaded)->approximations;
  if (goal.check_only) report.joint_path = wholeJointPath((*loaded)->plan);
  if ((*loaded)->knows_arm) report.preview = std::make_shared<const path::PathPreview>(previewOf(**loaded));
  report.loaded = *loaded;
  Outcome outcome;
  outcome.planned = (*loaded)->planned;
  outcome.detail = Detail(std::move(report));
  return outcome;
}

Detail previewOf(const LoadPathGoal& /*goal*/, const Outcome& planned) {
  const auto& report = planned.detail.as<PathReport>();
  return report.preview ? Detail(*report.preview) : Detail();
}

std::unique_ptr<Run> runOf(const LoadPathGoal& /*goal*/, GoalId id, const Outcome& planned, Instant now) {
  return std::make_unique<LoadPathRun>(id, planned.detail.as<PathReport>(), now);
}

}  // namespace cobot_command::blocks
