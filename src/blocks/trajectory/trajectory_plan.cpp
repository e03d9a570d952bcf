#include "trajectory/trajectory_plan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/refusal_failure.h"
#include "cobot_command/common/units.h"
#include "cobot_command/motion/planner.h"
#include "cobot_command/path/pvt_block.h"
#include "cobot_command/planning/script_planner.h"

namespace cobot_command::blocks {
namespace {

using Points = std::vector<TrajectoryPoint>;
using Segments = std::vector<motion::PvtJointPoint>;

/// Where none is given: far more than an arm that follows is off, far less than one that goes elsewhere.
constexpr double kPathTolerance = degToRad(5.0);
/// Times that are a multiple of the least segment are so within their rounding [s].
constexpr double kTimeRounding = 1e-6;

arm::JointVector jointsOf(const std::vector<double>& values) {
  return Eigen::Map<const arm::JointVector>(values.data());
}

arm::JointVector tolerances(const SixValues& given, double usual) {
  arm::JointVector allowed;
  std::transform(given.begin(), given.end(), allowed.data(), [usual](double value) {
    if (value < 0) return std::numeric_limits<double>::infinity();
    return value > 0 ? value : usual;
  });
  return allowed;
}

/// Those that were given; else as near as anybody knows where an arm stands.
arm::JointVector startTolerances(const SixValues& given) {
  arm::JointVector allowed;
  std::transform(given.begin(), given.end(), allowed.data(),
                 [](double value) { return value > 0 ? value : planning::kStartTolerance; });
  return allowed;
}

/// The joint that is off by more than is allowed, and that by the most of it.
std::optional<Eigen::Index> jointOff(const arm::JointVector& gap, const arm::JointVector& allowed) {
  Eigen::Index joint = 0;
  const double most = gap.cwiseAbs().cwiseQuotient(allowed).maxCoeff(&joint);
  return most > 1.0 ? std::optional(joint) : std::nullopt;
}

Failure blaming(Failure failure, int index, int joint) {
  TrajectoryReport report;
  report.error_index = index;
  report.error_joint = joint;
  failure.detail = Detail(std::move(report));
  return failure;
}

/// A first point with time 0 says where the trajectory believes that the robot stands.
std::optional<Failure> checkStart(const FollowJointTrajectoryGoal& goal, const arm::JointVector& start) {
  const TrajectoryPoint& first = goal.points.front();
  if (first.time > 0) return std::nullopt;
  const arm::JointVector gap = jointsOf(first.positions) - start;
  const arm::JointVector allowed = startTolerances(goal.path_tolerance);
  const auto joint = jointOff(gap, allowed);
  if (!joint) return std::nullopt;
  return blaming(
      {own_error::kNotAtStart,
       fmt::format("J{} is at {:.3f} deg, and point 0, with time 0, at {:.3f} deg; allowed: {:.3f} "
                   "deg between them",
                   *joint + 1, radToDeg(start[*joint]),
                   radToDeg(first.positions[static_cast<std::size_t>(*joint)]), radToDeg(allowed[*joint])),
       ""},
      0, static_cast<int>(*joint));
}

/// Indices of the points that are far enough apart, and of the last one.
std::vector<std::size_t> keptPoints(const Points& points) {
  const auto is_near = [](double from, double to) { return to - from < kLeastTime - kTimeRounding; };
  std::vector<std::size_t> kept;
  const auto end = [&] { return kept.empty() ? 0.0 : points[kept.back()].time; };
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (!is_near(end(), points[i].time)) kept.push_back(i);
  }
  while (!kept.empty() && is_near(end(), points.back().time)) kept.pop_back();
  kept.push_back(points.size() - 1);
  return kept;
}

Segments segmentsOf(const Points& points, const arm::JointVector& start) {
  Segments segments;
  double end = 0.0;
  for (const std::size_t i : keptPoints(points)) {
    const TrajectoryPoint& point = points[i];
    motion::PvtJointPoint segment;
    segment.position = jointsOf(point.positions);
    segment.velocity = point.velocities.empty() ? arm::JointVector::Zero() : jointsOf(point.velocities);
    segment.duration = point.time - end;
    end = point.time;
    segments.push_back(segment);
  }
  if (points.back().velocities.empty()) deriveVelocities(start, segments);
  segments.back().velocity.setZero();  // within rounding it is
  return segments;
}

/// The first point that is not passed before that time.
int pointAt(const Points& points, double time) {
  const auto found =
      std::lower_bound(points.begin(), points.end(), time,
                       [](const TrajectoryPoint& point, double at) { return point.time < at; });
  return static_cast<int>(std::min(found, points.end() - 1) - points.begin());
}

/// With the point that the first offending place leads to.
Failure refusedOnTheWay(const motion::Refusal& refusal, const Points& points) {
  const int index = pointAt(points, refusal.at * points.back().time);
  Failure failure = toFailure(refusal);
  failure.found = fmt::format("on the path to point {}: {}", index, failure.found);
  return blaming(std::move(failure), index, refusal.joint);
}

/// What is left out lies on the way all the same.
std::optional<Failure> checkLeftOut(const Points& points, const TrajectoryPlan& plan) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].time <= 0) continue;
    const arm::JointVector gap =
        plan.motion->at(fromSeconds(points[i].time)).position - jointsOf(points[i].positions);
    const auto joint = jointOff(gap, plan.path_tolerance);
    if (!joint) continue;
    return blaming({own_error::kTrajectoryInvalid,
                    fmt::format("point {} is less than {} ms from its neighbours, and without it J{} would "
                                "pass {:.3f} deg away; allowed: {:.3f} deg",
                                i, motion::kLeastSegment.count() / 1000000, *joint + 1,
                                radToDeg(std::abs(gap[*joint])), radToDeg(plan.path_tolerance[*joint])),
                    "Give points at least 25 ms apart"},
                   static_cast<int>(i), static_cast<int>(*joint));
  }
  return std::nullopt;
}

Order orderOf(Segments segments) {
  path::PvtBlock block;
  block.points = std::move(segments);
  return motionOrder(path::scriptOf(block, {}));
}

/// So that no cubic goes beyond the two points that it is between (Fritsch and Carlson): a joint that turns
/// round at a point rests there, and any other is at most three times as fast as on either side.
void keepWithin(arm::JointVector& velocity, const arm::JointVector& in, const arm::JointVector& out) {
  for (Eigen::Index joint = 0; joint < velocity.size(); ++joint) {
    const bool turns = in[joint] * out[joint] <= 0;
    const double most = turns ? 0.0 : 3.0 * std::min(std::abs(in[joint]), std::abs(out[joint]));
    velocity[joint] = std::clamp(velocity[joint], -most, most);
  }
}

}  // namespace

void deriveVelocities(const arm::JointVector& start, Segments& points) {
  const arm::JointVector* before = &start;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double in = points[i].duration;
    const double out = points[i + 1].duration;
    const arm::JointVector slope_in = (points[i].position - *before) / in;
    const arm::JointVector slope_out = (points[i + 1].position - points[i].position) / out;
    points[i].velocity = (slope_in * out + slope_out * in) / (in + out);
    keepWithin(points[i].velocity, slope_in, slope_out);
    before = &points[i].position;
  }
  points.back().velocity.setZero();
}

Result<std::shared_ptr<const TrajectoryPlan>, Failure> planTrajectory(const FollowJointTrajectoryGoal& goal,
                                                                      const PlanningScene& scene) {
  auto plan = std::make_shared<TrajectoryPlan>();
  plan->path_tolerance = tolerances(goal.path_tolerance, kPathTolerance);
  plan->goal_tolerance = tolerances(goal.goal_tolerance, scene.angle_tolerance);
  const Points& points = goal.points;
  const arm::JointVector& start = *scene.start->joints;
  if (auto elsewhere = checkStart(goal, start)) return refuse(*std::move(elsewhere));
  if (points.back().time <= 0) return std::shared_ptr<const TrajectoryPlan>(std::move(plan));

  Segments segments = segmentsOf(points, start);
  if (const auto most = static_cast<std::size_t>(scene.path.block_points); segments.size() > most) {
    return refuse(Failure{own_error::kTrajectoryInvalid,
                          fmt::format("{} points remain that are 25 ms apart or more; allowed: {} in one PVT",
                                      segments.size(), most),
                          "Give fewer points, or send the trajectory in parts"});
  }
  // At the full project speed: a slower one only takes longer.
  auto planned = motion::plan(*scene.arm, start, motion::Pvt{segments}, motion::Setting());
  if (!planned) return refuse(refusedOnTheWay(planned.error(), points));
  plan->motion = *std::move(planned);
  if (auto far_off = checkLeftOut(points, *plan)) return refuse(*std::move(far_off));
  plan->order = orderOf(std::move(segments));
  return std::shared_ptr<const TrajectoryPlan>(std::move(plan));
}

}  // namespace cobot_command::blocks
