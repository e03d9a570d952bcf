// A PVT as it goes out: its text, read again as the controller does, and the cubics between its points.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "path_support.h"

#include "cobot_command/path/path_pieces.h"

namespace cobot_command::path {

/// From one point of the wire to the next one [deg, deg/s, s].
struct WireCubic {
  arm::JointVector from;
  arm::JointVector from_speed;
  arm::JointVector to;
  arm::JointVector to_speed;
  double duration = 0;

  [[nodiscard]] arm::JointVector placeAt(double time) const {
    const double x = time / duration;
    return from + (to - from) * (x * x * (3 - 2 * x)) +
           duration * x * (1 - x) * ((1 - x) * from_speed - x * to_speed);
  }
  [[nodiscard]] arm::JointVector speedAt(double time) const {
    const double x = time / duration;
    return from_speed +
           x * (accelerationAt(0) + 0.5 * x * (accelerationAt(1) - accelerationAt(0))) * duration;
  }
  /// At its begin (0) or its end (1), one of which is the highest, as it grows evenly between them.
  [[nodiscard]] arm::JointVector accelerationAt(int end) const {
    const arm::JointVector way = 6 * (to - from) / (duration * duration);
    return end == 0 ? (way - (4 * from_speed + 2 * to_speed) / duration).eval()
                    : ((2 * from_speed + 4 * to_speed) / duration - way).eval();
  }
  /// The fastest of each joint, sign and all.
  [[nodiscard]] arm::JointVector highestSpeed() const {
    arm::JointVector highest = from_speed.cwiseAbs().cwiseMax(to_speed.cwiseAbs());
    for (Eigen::Index i = 0; i < highest.size(); ++i) {
      const double first = accelerationAt(0)[i];
      const double turn = duration * first / (first - accelerationAt(1)[i]);
      if (turn > 0 && turn < duration) highest[i] = std::max(highest[i], std::abs(speedAt(turn)[i]));
    }
    return highest;
  }
};

/// The cubics of one PVT, from rest at `start` [rad].
inline std::vector<WireCubic> wireOf(const std::string& text, const arm::JointVector& start) {
  std::vector<WireCubic> cubics;
  arm::JointVector at = start.unaryExpr([](double radians) { return radToDeg(radians); });
  arm::JointVector speed = arm::JointVector::Zero();
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::string call = "PVTPoint(";
    if (line.compare(0, call.size(), call) != 0) continue;
    std::vector<double> numbers;
    std::istringstream values(line.substr(call.size()));
    for (std::string value; std::getline(values, value, ',');) numbers.push_back(std::stod(value));
    EXPECT_EQ(numbers.size(), 13U) << line;
    WireCubic cubic{at, speed, {}, {}, numbers.at(12)};
    for (Eigen::Index i = 0; i < 6; ++i) {
      cubic.to[i] = numbers[static_cast<std::size_t>(i)];
      cubic.to_speed[i] = numbers[static_cast<std::size_t>(6 + i)];
    }
    at = cubic.to;
    speed = cubic.to_speed;
    cubics.push_back(cubic);
  }
  return cubics;
}

}  // namespace cobot_command::path
