// From the points of goals to one planned path: the one planner of checks, previews, execution and tests.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "cobot_command/path/path_plan.h"
#include "cobot_command/path/path_point.h"
#include "cobot_command/path/path_refusal.h"
#include "cobot_command/path/path_scene.h"

namespace cobot_command::path {

/// What one goal loads: `number_of_moves` of its points from `start_index` on. No other point is looked at.
struct PathSection {
  std::vector<PathPoint> points;
  int start_index = 0;
  int number_of_moves = 0;
  int goal = 0;  ///< the number of the goal: of a point without a move_id, and to tell goals apart
};

/// So many points may an array have.
inline constexpr std::size_t kMostPoints = 1000;
/// So many references may the poses of one goal have.
inline constexpr std::size_t kMostReferences = 3;

/// 1010 to 1032: what is wrong with a section whoever plans it, the first point first.
[[nodiscard]] std::optional<PathRefusal> checkSection(const PathSection& section,
                                                      const tables::DataTables& tables);
/// The same before it is known what is in the tables by then: without 1031 and 1032.
[[nodiscard]] std::optional<PathRefusal> checkSection(const PathSection& section);

/// A value: a copy can be tried out and thrown away. Sections that are planned behind each other are one
/// path: points 0..9 as one section, or as two, give the bit-identical trajectory, but that each section
/// states its own dynamics. What rests can be taken out, so that a chain without an end is planned by one
/// that stays small.
class PathPlanner {
 public:
  explicit PathPlanner(PathScene scene);

  /// Plans a section behind all before it. Refused: it is not appended.
  [[nodiscard]] std::optional<PathRefusal> append(const PathSection& section);

  /// Points that were planned before, behind all that is here, at the feedrate of the scene: the same way to
  /// the same targets, at another pace. `before`: the planner that they ended in, of which increments behind
  /// them go on. Refused: nothing is appended.
  [[nodiscard]] std::optional<PathRefusal> appendAgain(const std::vector<PlannedPoint>& points,
                                                       const PathPlanner& before);

  /// The arm rests on the last point, whatever that says; what is planned behind it begins from there.
  void closeEnd() { closed_ = true; }
  /// Takes out all up to the last point on which the arm certainly rests: a stop, a blend that is lost, a
  /// move without a way, a closed end. What stays are the points that blend on, or may blend with the next
  /// section. Both are paths from time 0.
  [[nodiscard]] PathPlan takeRested();

  /// What is not taken out.
  [[nodiscard]] const PathPlan& plan() const { return plan_; }
  [[nodiscard]] const PathScene& scene() const { return *scene_; }
  /// What the feedrate, tables and world are from the next section on; its start is not looked at, as the
  /// path goes on from its end.
  void setScene(PathScene scene);

 private:
  struct Written;
  class Appending;

  [[nodiscard]] std::size_t restedPoints() const;

  std::shared_ptr<const PathScene> scene_;
  PathPlan plan_;
  bool closed_ = false;                     ///< the last point, or the start where there is none
  std::shared_ptr<const Written> written_;  ///< the last pose as it was given: increments add to its numbers
};

}  // namespace cobot_command::path
