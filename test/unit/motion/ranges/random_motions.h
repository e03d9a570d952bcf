// Motions of every kind at random, for promises that have to hold of all of them.
#pragma once

#include <functional>
#include <random>
#include <vector>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/motion/trajectory.h"

namespace cobot_command::motion {

class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}

  [[nodiscard]] double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  [[nodiscard]] bool coin() { return between(0.0, 1.0) < 0.5; }
  /// Each order of size as often as the next one; both above 0.
  [[nodiscard]] double ofAnySize(double low, double high);
  /// Of length 1.
  [[nodiscard]] Eigen::Vector3d direction();
  [[nodiscard]] arm::JointVector joints(double most);

 private:
  std::mt19937_64 engine_;
};

struct MotionKind {
  const char* name;
  /// nullptr where what was thrown cannot be made: throw again.
  std::function<TrajectoryPtr(const arm::ArmModel&, Dice&)> make;
};

/// All that can be planned, velocities, chains and blends of all, and lines 3 mm beside singularities.
[[nodiscard]] const std::vector<MotionKind>& motionKinds();

}  // namespace cobot_command::motion
