#include "cobot_command/blocks/shared/joint_path.h"

#include <algorithm>
#include <cstddef>

#include "cobot_command/planning/sampling.h"

namespace cobot_command::blocks {
namespace {

constexpr std::size_t kMaxPoints = 100;
constexpr Duration kPointDistance = std::chrono::milliseconds(20);

std::array<double, 6> toArray(const arm::JointVector& joints) {
  std::array<double, 6> values{};
  std::copy_n(joints.data(), values.size(), values.begin());
  return values;
}

}  // namespace

std::vector<JointPathPoint> jointPath(const motion::Trajectory& motion, Duration until) {
  const auto distances = static_cast<std::size_t>(std::min(motion.duration(), until) / kPointDistance);
  std::vector<JointPathPoint> path;
  for (const planning::JointPoint& point :
       planning::jointPath(motion, std::min(distances + 2, kMaxPoints), until)) {
    path.push_back({point.time, toArray(point.position), toArray(point.velocity)});
  }
  return path;
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
