#include "cobot_command/motion/way_left.h"

#include <algorithm>
#include <chrono>

namespace cobot_command::motion {
namespace {

constexpr double kLeastHeight = 0.2e-3;  // [m]

}  // namespace

Duration timeOfShareLeft(const Trajectory& motion, Duration time, double share) {
  if (share >= 1.0) return motion.duration();
  const double begin = motion.progress(time);
  const double wanted = begin + share * (1.0 - begin);
  Duration before = time;
  Duration behind = motion.duration();
  while (behind - before > std::chrono::milliseconds(1)) {
    const Duration middle = before + (behind - before) / 2;
    (motion.progress(middle) < wanted ? before : behind) = middle;
  }
  return behind;
}

bool isNextToStraight(const Eigen::Vector3d& begin, const Eigen::Vector3d& middle,
                      const Eigen::Vector3d& end) {
  const Eigen::Vector3d chord = end - begin;
  const Eigen::Vector3d way = middle - begin;
  const double length = chord.norm();
  const double height = length > 0 ? way.cross(chord).norm() / length : way.norm();
  return std::max(height, way.norm() - length) < kLeastHeight;
}

}  // namespace cobot_command::motion
