#include "cobot_command/path/path_planner.h"

#include <algorithm>
#include <set>
#include <utility>

#include "motion_refusal.h"
#include "path_corner.h"
#include "points/dynamics.h"
#include "points/point_checks.h"
#include "points/point_motion.h"
#include "points/target.h"
#include "pvt/pvt_points.h"
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
        fmt::format("{} moves from point {} on, of a path of {} points; allowed: 1 to the number of points "
                    "from there on, in a path of at most {} points: choose fewer moves, or an earlier start",
                    count, start, section.points.size(), kMostPoints)};
  }
  if (!starts_inside) {
    return PathRefusal{
        path_error::kStartIndex, -1, -1,
        fmt::format("start_index is {}, allowed: 0 to {}: choose one in this range", start, size - 1)};
  }
  return std::nullopt;
}

/// As no motion takes longer, no path does.
constexpr Duration kLongest = std::chrono::hours(3);

PathRefusal tooLong(int index, double feedrate) {
  return {path_error::kNotPlannable, index, -1,
          "the path would take more than 3 h with this point: divide it, or choose higher speeds" +
              textOfFeedrate(feedrate)};
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

/// Of each point, in order, where nothing is wrong with the section (checkSection()).
Result<std::vector<Dynamics>, PathRefusal> dynamicsOf(const PathSection& section,
                                                      const tables::DataTables* tables) {
  if (auto refusal = checkIndices(section)) return refuse(std::move(*refusal));
  DynamicsOfGoal dynamics;
  std::vector<Dynamics> found;
  auto refusal = forEachPoint(section, [&](const PathPoint& point, int index) {
    auto wrong = dynamics.take(point, index);
    if (!wrong) wrong = checkPoint(point, index, tables);
    if (!wrong) found.push_back(dynamics.current());
    return wrong;
  });
  if (refusal) return refuse(std::move(*refusal));
  return found;
}

/// Whatever comes behind it: nothing blends with a tolerance of 0, nor with a move without a way.
bool endsAtRest(const PlannedPoint& point) {
  return !is(point.point.termination_type, Termination::Blend) || point.point.command_tolerance <= 0.0 ||
         point.motion->duration() == Duration::zero();
}

std::optional<PathRefusal> checkAgainst(const tables::DataTables* tables, const PathSection& section) {
  auto dynamics = dynamicsOf(section, tables);
  return dynamics ? std::nullopt : std::optional(std::move(dynamics.error()));
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
  Appending(const PathScene& scene, const PathPlan& plan, bool closed,
            const std::optional<Previous::Written>& written)
      : scene_(scene), plan_(plan), closed_(closed), previous_{plan.at(plan.duration()).position, written} {}

  [[nodiscard]] std::optional<PathRefusal> append(const PathPoint& point, int index, int goal,
                                                  const Dynamics& dynamics) {
    auto refusal = checkTarget(point, index);
    if (!refusal) refusal = references_.take(point, index);
    if (refusal) return refusal;
    auto target = targetOf(point, index, previous_, scene_);
    if (!target) return std::move(target.error());
    auto made = planPoint(point, index, *target, dynamics, previous_.joints, scene_);
    if (!made) return std::move(made.error());
    if (plan_.duration() + made->motion->duration() > kLongest) return tooLong(index, scene_.feedrate);
    auto refused = take(
        {goal, index, point, dynamics, scene_.feedrate, target->moved_frame, made->command, made->motion});
    previous_ = {made->motion->end().position, target->written};
    return refused;
  }

  [[nodiscard]] std::optional<PathRefusal> again(PlannedPoint point) {
    auto made = planAgain(point, previous_.joints, scene_);
    if (!made) return std::move(made.error());
    point.feedrate = scene_.feedrate;
    point.command = made->command;
    point.motion = made->motion;
    auto refused = take(std::move(point));
    previous_.joints = made->motion->end().position;
    return refused;
  }

  [[nodiscard]] const PathPlan& plan() const { return plan_; }
  [[nodiscard]] const std::optional<Previous::Written>& written() const { return previous_.written; }

 private:
  /// With the longest overlap that a PVT can say, too. A corner is never looked at again: without an overlap
  /// all that is in front of it is as it was when its last point was planned.
  std::optional<PathRefusal> take(PlannedPoint point) {
    const auto& points = plan_.points();
    const bool from_rest = points.empty() || closed_;
    Duration overlap = from_rest ? Duration::zero() : overlapBetween(points.back(), point, scene_);
    while (overlap > Duration::zero() && !canPass(point, overlap)) overlap = shorterOverlap(overlap);
    if (overlap == Duration::zero()) {
      PathPlan alone(previous_.joints);
      alone.append(point, Duration::zero());
      if (auto refusal = checkAsPvt(alone, 0, 0, scene_.arm)) return refusal;
    }
    plan_.append(std::move(point), overlap);
    closed_ = false;
    return std::nullopt;
  }
  [[nodiscard]] bool canPass(const PlannedPoint& point, Duration overlap) const {
    // The cubics of the last two points are other ones with it; they follow from those of two more
    // (pvt_knots.h).
    const std::size_t count = plan_.points().size();
    std::size_t first = count - 1;
    while (first > 0 && count - first < 4 && plan_.points()[first - 1].overlap > Duration::zero()) --first;
    PathPlan tail = plan_.part(first, count);
    tail.append(point, overlap);
    return !checkAsPvt(tail, 0, std::max(first, count - std::min<std::size_t>(count, 2)) - first, scene_.arm);
  }

  const PathScene& scene_;
  PathPlan plan_;
  bool closed_;
  Previous previous_;
  References references_;
};

struct PathPlanner::Written {
  std::optional<Previous::Written> last;
};

PathPlanner::PathPlanner(PathScene scene)
    : scene_(std::make_shared<const PathScene>(std::move(scene))), plan_(scene_->start) {}

std::optional<PathRefusal> PathPlanner::append(const PathSection& section) {
  const auto dynamics = dynamicsOf(section, &scene_->tables);
  if (!dynamics) return dynamics.error();
  Appending appending(*scene_, plan_, closed_, written_ ? written_->last : std::nullopt);
  auto next = dynamics->begin();
  auto refusal = forEachPoint(section, [&](const PathPoint& point, int index) {
    return appending.append(point, index, section.goal, *next++);
  });
  if (refusal) return refusal;
  plan_ = appending.plan();
  closed_ = false;
  written_ = std::make_shared<const Written>(Written{appending.written()});
  return std::nullopt;
}

std::optional<PathRefusal> PathPlanner::appendAgain(const std::vector<PlannedPoint>& points,
                                                    const PathPlanner& before) {
  Appending appending(*scene_, plan_, closed_, std::nullopt);
  for (const PlannedPoint& point : points) {
    if (auto refusal = appending.again(point)) return refusal;
  }
  if (points.empty()) return std::nullopt;
  plan_ = appending.plan();
  closed_ = false;
  written_ = before.written_;
  return std::nullopt;
}

std::size_t PathPlanner::restedPoints() const {
  const auto& points = plan_.points();
  std::size_t count = points.size();
  if (count > 0 && !closed_ && !endsAtRest(points.back())) --count;
  while (count > 0 && count < points.size() && points[count - 1].overlap > Duration::zero()) --count;
  return count;
}

PathPlan PathPlanner::takeRested() {
  const std::size_t count = restedPoints();
  PathPlan rested = plan_.part(0, count);
  plan_ = plan_.part(count, plan_.points().size());
  return rested;
}

void PathPlanner::setScene(PathScene scene) {
  const auto matrix = [](const PathScene& one) {
    return one.world ? one.world->matrix() : Eigen::Matrix4d::Zero().eval();
  };
  const bool same_world = matrix(scene) == matrix(*scene_);
  if (!same_world && written_ && written_->last && isInWorld(*written_->last)) written_.reset();
  scene_ = std::make_shared<const PathScene>(std::move(scene));
}

}  // namespace cobot_command::path
