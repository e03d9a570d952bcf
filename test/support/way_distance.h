// How far places are from a way.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include <Eigen/Core>

namespace cobot_command::testing {

/// The largest distance of these places from the line through those of the way, in their unit.
inline double mostOff(const std::vector<Eigen::Vector3d>& places, const std::vector<Eigen::Vector3d>& way) {
  double most = 0;
  for (const Eigen::Vector3d& place : places) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < way.size(); ++i) {
      const Eigen::Vector3d chord = way[i] - way[i - 1];
      const double along = chord.dot(place - way[i - 1]);
      const double share = chord.norm() > 0 ? std::clamp(along / chord.squaredNorm(), 0.0, 1.0) : 0.0;
      least = std::min(least, (way[i - 1] + share * chord - place).norm());
    }
    most = std::max(most, least);
  }
  return most;
}

}  // namespace cobot_command::testing
