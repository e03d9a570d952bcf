#include "cobot_command/blocks/shared/joint_path.h"

#include <algorithm>
#include <cstddef>

#include "cobot_command/path/path_plan.h"
#include "cobot_command/planning/sampling.h"

namespace cobot_command::blocks {
namespace {

constexpr std::size_t kMaxPoints = 100;
/// Of a whole path, which goes on for minutes.
constexpr std::size_t kMaxPathPoints = 5000;
constexpr Duration kPointDistance = std::chrono::milliseconds(20);

JointPathPoint toPoint(Duration time, const arm::JointVector& position, const arm::JointVector& velocity) {
  return {time, toArray(position), toArray(velocity)};
}

/// At the distance or less, but no more of them.
std::size_t countOf(Duration duration, std::size_t most) {
  return std::min(static_cast<std::size_t>(duration / kPointDistance) + 2, most);
}

}  // namespace

std::array<double, 6> toArray(const arm::JointVector& joints) {
  std::array<double, 6> values{};
  std::copy_n(joints.data(), values.size(), values.begin());
  return values;
}

std::vector<JointPathPoint> jointPath(const motion::Trajectory& motion, Duration until) {
  const std::size_t count = countOf(std::min(motion.duration(), until), kMaxPoints);
  std::vector<JointPathPoint> path;
  for (const planning::JointPoint& point : planning::jointPath(motion, count, until)) {
    path.push_back(toPoint(point.time, point.position, point.velocity));
  }
  return path;
}

std::vector<JointPathPoint> wholeJointPath(const path::PathPlan& plan) {
  std::vector<JointPathPoint> points;
  for (const Duration time :
       planning::evenTimes(plan.duration(), countOf(plan.duration(), kMaxPathPoints) - 1)) {
    const motion::JointState state = plan.at(time);
    points.push_back(toPoint(time, state.position, state.velocity));
  }
  return points;
}

std::vector<JointPathPoint> jointPath(const std::vector<motion::TrajectoryPtr>& motions) {
  std::vector<JointPathPoint> path;
  Duration start{};
  for (const motion::TrajectoryPtr& motion : motions) {
    if (!path.empty()) path.pop_back();  // it is the first point of the next one
    for (JointPathPoint point : jointPath(*motion)) {
      point.time += start;
      path.push_back(point);
    }
    start += motion->duration();
  }
  return path;
}

}  // namespace cobot_command::blocks
