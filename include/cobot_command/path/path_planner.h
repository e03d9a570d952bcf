// Plans the points of goals as one path. Checks, previews, execution and tests all use this planner.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "cobot_command/path/path_plan.h"
#include "cobot_command/path/path_point.h"
#include "cobot_command/path/path_refusal.h"
#include "cobot_command/path/path_scene.h"

namespace cobot_command::path {

/// The part that one goal loads: `number_of_moves` of its points from `start_index`. Other points are not
/// checked.
struct PathSection {
  std::vector<PathPoint> points;
  int start_index = 0;
  int number_of_moves = 0;
  int goal = 0;  ///< number of the goal: reported for a point without a move_id, and distinguishes goals
};

/// Most points of an array.
inline constexpr std::size_t kMostPoints = 1000;
/// Most reference frames of the poses of one goal.
inline constexpr std::size_t kMostReferences = 3;

/// Errors 1010 to 1032: errors of a section that do not depend on the planner, first point first.
[[nodiscard]] std::optional<PathRefusal> checkSection(const PathSection& section,
                                                      const tables::DataTables& tables);
/// The same if the contents of the tables are not known yet: without 1031 and 1032.
[[nodiscard]] std::optional<PathRefusal> checkSection(const PathSection& section);

/// A value: a copy can be used to try a section and be discarded. Consecutive sections form one path: points
/// 0..9 as one section or as two give the bit-identical trajectory, except that each section states its own
/// dynamics. Completed parts can be taken out, so a planner for an endless chain stays small.
class PathPlanner {
 public:
  explicit PathPlanner(PathScene scene);

  /// Plans a section after all previous ones. A refused section is not appended.
  [[nodiscard]] std::optional<PathRefusal> append(const PathSection& section);

  /// Appends already planned points again at the feedrate of the scene: the same path to the same targets,
  /// with another speed. `before` is the planner in which they were the last points; increments after them
  /// continue from it. A refusal appends nothing.
  [[nodiscard]] std::optional<PathRefusal> appendAgain(const std::vector<PlannedPoint>& points,
                                                       const PathPlanner& before);

  /// The arm stops on the last point, whatever its termination type. The next section starts from there.
  void closeEnd() { closed_ = true; }
  /// Takes out all points up to the last one on which the arm certainly stops: a stop, a lost blend, a move
  /// of zero length, a closed end. Points that blend, or may blend with the next section, remain. Both parts
  /// are paths from time 0.
  [[nodiscard]] PathPlan takeRested();

  /// The points that are not taken out.
  [[nodiscard]] const PathPlan& plan() const { return plan_; }
  [[nodiscard]] const PathScene& scene() const { return *scene_; }
  /// Sets feedrate, tables and world from the next section on. Its start is ignored, because the path
  /// continues from its end.
  void setScene(PathScene scene);

 private:
  struct Written;
  class Appending;

  [[nodiscard]] std::size_t restedPoints() const;

  std::shared_ptr<const PathScene> scene_;
  PathPlan plan_;
  bool closed_ = false;                     ///< of the last point, or of the start if there is none
  std::shared_ptr<const Written> written_;  ///< the last pose as given: increments are added to its numbers
};

}  // namespace cobot_command::path
