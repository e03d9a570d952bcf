// How far the arm is from its plan, by what the status stream shows of it: how a real controller makes a PVT
// between its points is told nowhere.
#pragma once

#include <array>
#include <cstddef>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"
#include "cobot_command/path/path_plan.h"

namespace cobot_command::path {

struct Deviation {
  double joint = 0;  ///< the largest of any joint from where it should be by then, its lag included [rad]
  double path =
      0;  ///< the largest distance of the moved frame from the planned curve, whenever it is there [m]
  double lag = 0;  ///< the delay by which the plan fits best, 0..0.5 [s]; 0 without motion
};

/// Of one path, from its start to its end.
class DeviationWatch {
 public:
  DeviationWatch(arm::ArmModel arm, PathPlan plan);

  /// The arm had these joints [rad], so long after the path began. Ignored where one is not finite.
  void add(Duration time, const arm::JointVector& joints);

  [[nodiscard]] Deviation deviation() const;
  /// Of the sample that came last, from the planned curve [m].
  [[nodiscard]] double offThePath() const { return last_; }

 private:
  /// Delays that are tried: so many, so far apart; the first is one ahead of the plan.
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
