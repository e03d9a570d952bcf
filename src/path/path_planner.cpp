#include "cobot_command/path/path_planner.h"

#include <set>
#include <utility>

#include "dynamics.h"
#include "path_corner.h"
#include "point_checks.h"
#include "point_motion.h"
#include "target.h"
#include <fmt/format.h>

namespace cobot_command::path {
namespace {

std::optional<PathRefusal> checkIndices(const PathSection& section) {
  const auto size = static_cast<int>(std::min<std::size_t>(section.points.size(), kMostPoints + 1));
  const int start = section.start_index;
  const int count = section.number_of_moves;
  const bool starts_inside = start >= 0 && start < size;
  if (section.points.size() > kMostPoints || count < 1 || count > size ||
      (starts_inside && count > size - start)) {
    return PathRefusal{
        path_error::kMovesExceedArray, -1, -1,
        fmt::format("{} moves from point {} on, of a path of {} points; allowed: 1 to as many as "
                    "there are from there on, of at most {} points",
                    count, start, section.points.size(), kMostPoints)};
  }
  if (!starts_inside) {
    return PathRefusal{path_error::kStartIndex, -1, -1,
                       fmt::format("start_index is {}, allowed: 0 to {}", start, size - 1)};
  }
  return std::nullopt;
}

/// As no motion takes longer, no path does.
constexpr Duration kLongest = std::chrono::hours(3);

PathRefusal tooLong(int index) {
  return {path_error::kNotPlannable, index, -1,
          "the path would take more than 3 h with this point: divide it, or choose higher speeds"};
}

/// The pairs of type and number that the poses of a goal refer to.
class References {
 public:
  std::optional<PathRefusal> take(const PathPoint& point, int index) {
    if (!hasReference(point)) return std::nullopt;
    const int id = is(point.ref_frame_type, Reference::User) ? point.ref_frame_id : 0;
    seen_.emplace(point.ref_frame_type, id);
    if (seen_.size() <= kMostReferences) return std::nullopt;
    return PathRefusal{
        path_error::kManyReferences, index, -1,
        fmt::format("the poses of this goal refer to more than {} frames: divide it into several "
                    "goals",
                    kMostReferences)};
  }

 private:
  std::set<std::pair<int, int>> seen_;
};

template <class Visit>
std::optional<PathRefusal> forEachPoint(const PathSection& section, const Visit& visit) {
  for (int index = section.start_index; index < section.start_index + section.number_of_moves; ++index) {
    if (auto refusal = visit(section.points[static_cast<std::size_t>(index)], index)) return refusal;
  }
  return std::nullopt;
}

std::optional<PathRefusal> checkAgainst(const tables::DataTables* tables, const PathSection& section) {
  if (auto refusal = checkIndices(section)) return refusal;
  DynamicsOfGoal dynamics;
  return forEachPoint(section, [&](const PathPoint& point, int index) {
    auto refusal = dynamics.take(point, index);
    return refusal ? refusal : checkPoint(point, index, tables);
  });
}

}  // namespace

std::optional<PathRefusal> checkSection(const PathSection& section, const tables::DataTables& tables) {
  return checkAgainst(&tables, section);
}

std::optional<PathRefusal> checkSection(const PathSection& section) {
  return checkAgainst(nullptr, section);
}

/// One section, behind what is planned already.
class PathPlanner::Appending {
 public:
  Appending(const PathScene& scene, const PathPlan& plan, const std::optional<Previous::Written>& written)
      : scene_(scene), plan_(plan), previous_{plan.at(plan.duration()).position, written} {}

  [[nodiscard]] std::optional<PathRefusal> append(const PathPoint& point, int index, int goal) {
    auto refusal = dynamics_.take(point, index);
    if (!refusal) refusal = checkTarget(point, index);
    if (!refusal) refusal = references_.take(point, index);
    if (refusal) return refusal;
    auto target = targetOf(point, index, previous_, scene_);
    if (!target) return std::move(target.error());
    auto made = planPoint(point, index, *target, dynamics_.current(), previous_.joints, scene_);
    if (!made) return std::move(made.error());
    if (plan_.duration() + made->motion->duration() > kLongest) return tooLong(index);
    previous_ = {made->motion->end().position, target->written};
    const double feedrate = scene_.feedrate;
    take({goal, index, point, dynamics_.current(), feedrate, target->moved_frame, made->command,
          made->motion});
    return std::nullopt;
  }

  [[nodiscard]] const PathPlan& plan() const { return plan_; }
  [[nodiscard]] const std::optional<Previous::Written>& written() const { return previous_.written; }

 private:
  void take(PlannedPoint point) {
    const auto& points = plan_.points();
    const Duration overlap = points.empty() ? Duration::zero() : overlapBetween(points.back(), point, scene_);
    plan_.append(std::move(point), overlap);
  }

  const PathScene& scene_;
  PathPlan plan_;
  Previous previous_;
  DynamicsOfGoal dynamics_;
  References references_;
};

struct PathPlanner::Written {
  std::optional<Previous::Written> last;
};

PathPlanner::PathPlanner(PathScene scene)
    : scene_(std::make_shared<const PathScene>(std::move(scene))), plan_(scene_->start) {}

std::optional<PathRefusal> PathPlanner::append(const PathSection& section) {
  if (auto refusal = checkSection(section, scene_->tables)) return refusal;
  Appending appending(*scene_, plan_, written_ ? written_->last : std::nullopt);
  auto refusal = forEachPoint(section, [&](const PathPoint& point, int index) {
    return appending.append(point, index, section.goal);
  });
  if (refusal) return refusal;
  plan_ = appending.plan();
  written_ = std::make_shared<const Written>(Written{appending.written()});
  return std::nullopt;
}

void PathPlanner::setScene(PathScene scene) {
  scene_ = std::make_shared<const PathScene>(std::move(scene));
}

}  // namespace cobot_command::path
