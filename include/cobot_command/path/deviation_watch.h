// Measures the deviation of the arm from its plan with the status stream. It is not documented how a real
// controller interpolates a PVT between its points.
#pragma once

#include <array>
#include <cstddef>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"
#include "cobot_command/path/path_plan.h"

namespace cobot_command::path {

struct Deviation {
  double joint = 0;  ///< largest error of any joint at its planned time, lag included [rad]
  double path = 0;   ///< largest distance of the moved frame from the curve, at any time [m]
  double lag = 0;    ///< the delay with which the plan fits best, 0..0.5 [s]; 0 without motion
};

/// Watches one path, from its start to its end.
class DeviationWatch {
 public:
  DeviationWatch(arm::ArmModel arm, PathPlan plan);

  /// Adds measured joints [rad]; `time` is the time since the start of the path. Ignored if a value is not
  /// finite.
  void add(Duration time, const arm::JointVector& joints);

  [[nodiscard]] Deviation deviation() const;
  /// Distance of the last sample from the planned curve [m].
  [[nodiscard]] double offThePath() const { return last_; }

 private:
  /// Number of tested delays, and their spacing. The first delay is one step ahead of the plan.
  static constexpr std::size_t kDelays = 27;
  static constexpr Duration kDelay = std::chrono::milliseconds(20);
  [[nodiscard]] static Duration delay(std::size_t i) { return kDelay * (static_cast<Duration::rep>(i) - 1); }

  [[nodiscard]] Eigen::Vector3d placeOf(const arm::JointVector& joints, std::size_t point) const;
  [[nodiscard]] double distanceAt(Duration time, const arm::JointVector& joints) const;
  [[nodiscard]] double nearest(Duration time, const arm::JointVector& joints) const;
  [[nodiscard]] double nearestAround(Duration time, double least, const arm::JointVector& joints) const;

  arm::ArmModel arm_;
  PathPlan plan_;
  double joint_ = 0;
  double path_ = 0;
  double last_ = 0;
  std::array<double, kDelays> squares_{};  ///< sums over all samples, for each delay
};

}  // namespace cobot_command::path
