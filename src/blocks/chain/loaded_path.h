// What the plan of a load_path goal hands to the run that it becomes, or that it joins.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/order.h"
#include "cobot_command/blocks/shared/planning_scene.h"
#include "cobot_command/common/path_settings.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"
#include "cobot_command/path/path_controls.h"
#include "cobot_command/path/path_plan.h"
#include "cobot_command/path/path_planner.h"
#include "cobot_command/path/path_refusal.h"
#include "cobot_command/path/path_script.h"

namespace cobot_command::blocks {

/// What goes to the controller at once: a PVT from rest to rest, whose points may be of several goals; or a
/// motion of a script.
struct LoadedPiece {
  path::PathPlan plan;  ///< from time 0
  Order order;
  std::vector<std::size_t> marked = {};  ///< the point of the plan that each mark of the order is behind
  /// The controller makes what is planned; else it has ramps and corners of its own.
  bool is_exact = true;
  bool loses_blend = false;  ///< of one that is not exact: its point is planned to rest, whatever it says
  double fastest = 0;        ///< of any joint, of its rated speed, by the plan
};
using LoadedPiecePtr = std::shared_ptr<const LoadedPiece>;

/// Where a chain ends, with the points that are not sent yet, as the next one may blend with them.
using ChainEnd = std::shared_ptr<const path::PathPlanner>;

/// Detail for the plan of a goal that is to join a chain (Run::chain).
struct ChainToJoin {
  ChainEnd end;
  Execution execution = Execution::Pvt;
  path::ScriptFrames frames;     ///< that were active in front of it all
  path::TrackingFlags tracking;  ///< that the last goal of it waited for
};

struct LoadedPath {
  explicit LoadedPath(path::PathPlan whole) : plan(std::move(whole)) {}

  ChainEnd behind;         ///< that it was planned behind; none: from where the robot stands
  bool from_rest = false;  ///< it does not blend with the one in front, whatever that says: it is sent, or
                           ///< held back, otherwise
  Execution execution = Execution::Pvt;
  path::TrackingFlags tracking{};  ///< its gate
  path::ScriptFrames frames;       ///< that are active in front of it, and behind it
  Order restoring;  ///< of these, once one of its pieces is sent; no lines: nothing changes them
  std::vector<std::string> approximations;  ///< of a script
  int method_id = 0;
  path::PathPlan plan;    ///< behind the points of goals in front that are not sent yet
  std::size_t first = 0;  ///< of its own points in the plan
  int start_index = 0;
  std::vector<int> move_ids;           ///< of its points
  std::vector<LoadedPiecePtr> pieces;  ///< the first one may begin with points of the goals in front
  LoadedPiecePtr open_end;             ///< of PVTs the last one, while something may come that it blends with
  ChainEnd end;                        ///< with the points of the open end
  ChainEnd closed_end;                 ///< once the open end is sent
  Duration planned{};                  ///< of its points, with the project speed of when it was planned
  double feedrate = 1.0;               ///< that it was planned with
  double project_speed = 1.0;          ///< the same
  double max_deviation = 0;            ///< [m]; 0: any
  bool allow_approximation = false;
  bool knows_arm = true;           ///< else it is planned for any (arm::anyArm)
  std::vector<StepReport> report;  ///< of each point
  PathSettings settings;
};

using LoadedPathPtr = std::shared_ptr<const LoadedPath>;

/// Plans the points of a goal behind the chain, or from the start, of the scene, for its execution. Refused
/// (16#271) is a script that would say otherwise, where that is not allowed. Precondition: arm and start are
/// known, or the chain is.
[[nodiscard]] Result<LoadedPathPtr, path::PathRefusal> loadPath(const LoadPathGoal& goal,
                                                                const PlanningScene& scene);

/// What is left of a chain: points that are not sent, and whose they are.
struct PathRest {
  struct Part {
    LoadedPathPtr loaded;
    std::vector<path::PlannedPoint> points;
  };
  arm::JointVector start;  ///< where the arm rests in front of it
  bool is_begun = false;  ///< the first part is: nobody knows here what its points in front of these have set
  std::vector<Part> parts;            ///< one at least; each with its points
  std::optional<Duration> left = {};  ///< of the first point, as it was planned; nothing: all of it
};

/// The same way at another feedrate: of each part what takes the place of `loaded`, with pieces of its rest
/// alone. Refused with the first point that does not go so fast.
[[nodiscard]] Result<std::vector<LoadedPathPtr>, path::PathRefusal> loadAgain(const PathRest& rest,
                                                                              double feedrate);

}  // namespace cobot_command::blocks
