#include "chain/loaded_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/arm/any_arm.h"
#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/units.h"
#include "cobot_command/path/path_pieces.h"
#include "cobot_command/path/pvt_block.h"
#include "cobot_command/script/script_command.h"

namespace cobot_command::blocks {
namespace {

using path::PathPlan;
using path::PathRefusal;
using Loaded = Result<LoadedPathPtr, PathRefusal>;
using Pieces = Result<std::vector<LoadedPiecePtr>, PathRefusal>;

/// Two PVTs are at the controller, and it has fifteen tags; one of each is for its end.
constexpr std::size_t kMostMarks = 6;

/// Behind the line that enters, and as many points as it is done behind.
std::size_t lineBehind(const path::PvtBlock& block, std::size_t point) {
  return 1 + block.ends.at(point);
}

/// Of its rated speed, of the joint that is nearest to it.
double shareOfRated(const arm::JointVector& speed, const arm::ArmModel& arm) {
  double largest = 0;
  for (std::size_t joint = 0; joint < arm.limits().size(); ++joint) {
    const double share = std::abs(speed[static_cast<Eigen::Index>(joint)]) / arm.limits()[joint].max_velocity;
    largest = std::max(largest, share);
  }
  return largest;
}

/// By the points that are sent: these are sampled already.
double fastestOf(const path::PvtBlock& block, const arm::ArmModel& arm) {
  double fastest = 0;
  for (const motion::PvtJointPoint& point : block.points) {
    fastest = std::max(fastest, shareOfRated(point.velocity, arm));
  }
  return fastest;
}

double fastestOf(const PathPlan& plan, const arm::ArmModel& arm) {
  constexpr Duration kStep = std::chrono::milliseconds(25);
  double fastest = 0;
  for (Duration time{}; time < plan.duration(); time += kStep) {
    fastest = std::max(fastest, shareOfRated(plan.at(time).velocity, arm));
  }
  return fastest;
}

LoadedPiecePtr toLoaded(path::PathPiece piece, const arm::ArmModel& arm) {
  // A motion also without a way: it is stopped with the others.
  LoadedPiece loaded{std::move(piece.plan), motionOrder(path::scriptOf(piece.block, {}))};
  loaded.order.is_previewed = true;
  loaded.fastest = fastestOf(piece.block, arm);
  if (!loaded.order.lines.empty()) {
    loaded.marked = path::markedPoints(loaded.plan, kMostMarks);
    for (const std::size_t point : loaded.marked) {
      loaded.order.marks.push_back(lineBehind(piece.block, point));
    }
  }
  return std::make_shared<const LoadedPiece>(std::move(loaded));
}

Pieces toLoaded(const PathPlan& plan, const path::PathScene& scene, const PathSettings& settings) {
  auto pieces =
      path::piecesOf(plan, scene, {settings.segment, static_cast<std::size_t>(settings.block_points)});
  if (!pieces) return refuse(pieces.error());
  std::vector<LoadedPiecePtr> loaded;
  loaded.reserve(pieces->size());
  for (path::PathPiece& piece : *pieces) loaded.push_back(toLoaded(std::move(piece), scene.arm));
  return loaded;
}

void report(LoadedPath& loaded) {
  const auto& points = loaded.plan.points();
  const Duration start = points[loaded.first].start;
  for (std::size_t i = loaded.first; i < points.size(); ++i) {
    StepReport step;
    step.start = points[i].start - start;
    step.duration = points[i].motion->duration();
    loaded.report.push_back(std::move(step));
    loaded.move_ids.push_back(points[i].point.move_id != 0 ? points[i].point.move_id : loaded.method_id);
  }
  loaded.planned = fromSeconds(toSeconds(loaded.plan.duration() - start) / loaded.project_speed);
}

/// Its points from `first` on take another time than before. `left`: of what that one was to take.
void retime(LoadedPath& loaded, const std::optional<Duration>& left) {
  const auto& points = loaded.plan.points();
  if (loaded.first == points.size()) return;
  const auto kept = loaded.report.size() - (points.size() - loaded.first);
  const Duration begin = loaded.report[kept].start;
  const Duration driven = left ? loaded.report[kept].duration - *left : Duration::zero();
  const Duration before = loaded.report.back().start + loaded.report.back().duration;
  for (std::size_t i = loaded.first; i < points.size(); ++i) {
    StepReport& step = loaded.report[kept + i - loaded.first];
    step.start = begin + driven + points[i].start - points[loaded.first].start;
    step.duration = points[i].motion->duration();
  }
  loaded.report[kept].start = begin;
  loaded.report[kept].duration += driven;
  const Duration after = loaded.report.back().start + loaded.report.back().duration;
  loaded.planned += fromSeconds(toSeconds(after - before) / loaded.project_speed);
}

path::PathPlanner plannerFor(const LoadPathGoal& goal, const PlanningScene& scene) {
  const ChainEnd& chain = scene.chain.as<ChainToJoin>().end;
  const path::PathScene here{*scene.arm, chain ? chain->scene().start : *scene.start->joints, scene.tables,
                             goal.world, scene.feedrate};
  if (!chain) return path::PathPlanner(here);
  path::PathPlanner planner = *chain;
  planner.setScene(here);
  return planner;
}

void closeEnd(path::PathPlanner& planner) {
  planner.closeEnd();
  static_cast<void>(planner.takeRested());
}

/// Its pieces, and its end for who comes behind it.
std::optional<PathRefusal> loadPvts(path::PathPlanner planner, LoadedPath& loaded) {
  auto pieces = toLoaded(planner.takeRested(), planner.scene(), loaded.settings);
  if (!pieces) return std::move(pieces.error());
  loaded.pieces = std::move(*pieces);
  loaded.end = std::make_shared<const path::PathPlanner>(planner);
  planner.closeEnd();
  auto open_end = toLoaded(planner.takeRested(), planner.scene(), loaded.settings);
  if (!open_end) return std::move(open_end.error());
  if (!open_end->empty()) loaded.open_end = open_end->front();
  loaded.closed_end = std::make_shared<const path::PathPlanner>(std::move(planner));
  return std::nullopt;
}

bool setsFrames(const path::PointScript& point) {
  return point.lines.size() > 1;
}

/// What was active in front of the path; what is not known stays as the path has set it.
Order restoring(const path::ScriptFrames& frames) {
  std::vector<script::ScriptCommand> commands;
  if (frames.base) commands.emplace_back(script::ChangeBase{arm::toControllerPose(*frames.base)});
  if (frames.tcp) commands.emplace_back(script::ChangeTcp{arm::toControllerPose(*frames.tcp), {}, {}});
  return settingOrder(std::move(commands));
}

LoadedPiecePtr toLoaded(const PathPlan& point, const path::PointScript& script, const arm::ArmModel& arm,
                        bool loses_blend) {
  LoadedPiece piece{point, motionOrder(script.lines)};
  piece.order.is_previewed = true;
  piece.fastest = fastestOf(point, arm);
  piece.is_exact = false;
  piece.loses_blend = loses_blend;
  return std::make_shared<const LoadedPiece>(std::move(piece));
}

/// Each point as a motion of its own; what sets base and TCP sets them back behind the last one. `active`: in
/// front of them.
std::optional<PathRefusal> loadScript(path::PathPlanner planner, const path::ScriptFrames& active,
                                      LoadedPath& loaded) {
  auto script = path::scriptOf(loaded.plan, loaded.first, planner.scene(), active);
  if (!script) return std::move(script.error());
  if (loaded.max_deviation > 0) {
    loaded.approximations.emplace_back(
        "max_deviation is not monitored: a script determines its corners itself");
  }
  for (const path::PointScript& point : *script) {
    loaded.approximations.insert(loaded.approximations.end(), point.approximations.begin(),
                                 point.approximations.end());
  }
  if (!loaded.approximations.empty() && !loaded.allow_approximation) {
    return PathRefusal{path::path_error::kNotInAScript, -1, -1,
                       fmt::format("{}", fmt::join(loaded.approximations, "; "))};
  }
  const bool has_set = !loaded.restoring.lines.empty();  // with points that are sent
  if (has_set || std::any_of(script->begin(), script->end(), setsFrames)) {
    loaded.restoring = restoring(loaded.frames);
    script->back().lines.insert(script->back().lines.end(), loaded.restoring.commands->begin(),
                                loaded.restoring.commands->end());
  }
  for (std::size_t i = 0; i < script->size(); ++i) {
    const std::size_t point = loaded.first + i;
    // The last one may blend with what comes in time: that the controller decides.
    const bool loses_blend = i + 1 < script->size() && loaded.plan.points()[point].losesBlend();
    loaded.pieces.push_back(
        toLoaded(loaded.plan.part(point, point + 1), (*script)[i], planner.scene().arm, loses_blend));
  }
  static_cast<void>(planner.takeRested());
  loaded.end = std::make_shared<const path::PathPlanner>(planner);
  closeEnd(planner);
  loaded.closed_end = std::make_shared<const path::PathPlanner>(std::move(planner));
  return std::nullopt;
}

/// `active`: of a script, in front of its own points.
std::optional<PathRefusal> loadPieces(path::PathPlanner planner, const path::ScriptFrames& active,
                                      LoadedPath& loaded) {
  return loaded.execution == Execution::Script ? loadScript(std::move(planner), active, loaded)
                                               : loadPvts(std::move(planner), loaded);
}

}  // namespace

Loaded loadPath(const LoadPathGoal& goal, const PlanningScene& scene) {
  const auto& chain = scene.chain.as<ChainToJoin>();
  const bool is_fallback = path::is(goal.execution, Execution::Auto) && scene.is_pvt_refused;
  const bool is_script = is_fallback || path::is(goal.execution, Execution::Script);
  const auto execution = is_script ? Execution::Script : Execution::Pvt;
  const bool is_otherwise = chain.execution != execution || chain.tracking != goal.enable_tracking;
  const bool from_rest = chain.end && is_otherwise;
  path::PathPlanner planner = plannerFor(goal, scene);
  if (from_rest) closeEnd(planner);
  const std::size_t in_front = planner.plan().points().size();
  if (auto refusal = planner.append({goal.path, goal.start_index, goal.number_of_moves, scene.number})) {
    return refuse(*std::move(refusal));
  }
  auto loaded = std::make_shared<LoadedPath>(planner.plan());
  loaded->behind = chain.end;
  loaded->from_rest = from_rest;
  loaded->execution = execution;
  loaded->tracking = goal.enable_tracking;
  loaded->frames =
      chain.end || !scene.start ? chain.frames : path::ScriptFrames{scene.start->base, scene.start->tcp};
  loaded->first = in_front;
  loaded->method_id = scene.number;
  loaded->start_index = goal.start_index;
  loaded->feedrate = scene.feedrate;
  loaded->project_speed = scene.start ? scene.start->speed_override : 1.0;
  loaded->max_deviation = mmToM(goal.max_deviation);
  loaded->allow_approximation = goal.allow_approximation;
  loaded->knows_arm = scene.arm != &arm::anyArm();
  loaded->settings = scene.path;
  report(*loaded);
  auto refusal = loadPieces(std::move(planner), loaded->frames, *loaded);
  if (refusal) return refuse(*std::move(refusal));
  return LoadedPathPtr(std::move(loaded));
}

Result<std::vector<LoadedPathPtr>, PathRefusal> loadAgain(const PathRest& rest, double feedrate) {
  path::PathScene first = rest.parts.front().loaded->end->scene();
  first.start = rest.start;
  path::PathPlanner planner(first);
  std::vector<LoadedPathPtr> made;
  for (const PathRest::Part& part : rest.parts) {
    path::PathScene scene = part.loaded->end->scene();
    scene.feedrate = feedrate;
    planner.setScene(std::move(scene));
    if (part.loaded->from_rest) closeEnd(planner);
    const std::size_t in_front = planner.plan().points().size();
    auto refusal = planner.appendAgain(part.points, *part.loaded->end);
    if (refusal) return refuse(*std::move(refusal));
    auto loaded = std::make_shared<LoadedPath>(*part.loaded);
    loaded->behind = made.empty() ? nullptr : made.back()->end;
    loaded->plan = planner.plan();
    loaded->first = in_front;
    loaded->feedrate = feedrate;
    loaded->pieces.clear();
    loaded->open_end = nullptr;
    loaded->approximations.clear();
    retime(*loaded, made.empty() ? rest.left : std::nullopt);
    const bool is_begun = made.empty() && rest.is_begun;
    const auto active = is_begun ? path::ScriptFrames() : loaded->frames;
    refusal = loadPieces(planner, active, *loaded);
    if (refusal) return refuse(*std::move(refusal));
    planner = *loaded->end;
    made.push_back(std::move(loaded));
  }
  return made;
}

}  // namespace cobot_command::blocks
