// Speed, acceleration and jerk of each point of a goal: what it does not say is as in the point of its kind
// before it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "cobot_command/motion/command.h"
#include "cobot_command/path/path_plan.h"
#include "cobot_command/path/path_refusal.h"

namespace cobot_command::path {

/// Of one goal: each goal states its own anew. PTP and all others are two kinds, as their units are.
class DynamicsOfGoal {
 public:
  /// The next point: 1013, 1014 or 1015 when it cannot be. One whose interpolation is none counts for nobody.
  [[nodiscard]] std::optional<PathRefusal> take(const PathPoint& point, int index);
  /// Of the point that was taken last.
  [[nodiscard]] const Dynamics& current() const { return *kinds_[last_]; }

 private:
  std::array<std::optional<Dynamics>, 2> kinds_;
  std::size_t last_ = 0;
};

/// `feedrate` [1]: as much faster as time runs.
[[nodiscard]] motion::Rates jointRates(const Dynamics& dynamics, double feedrate);
[[nodiscard]] motion::PathRates pathRates(const Dynamics& dynamics, int profile_type, double feedrate);
[[nodiscard]] motion::RampShape rampShape(const Dynamics& dynamics, int profile_type);

}  // namespace cobot_command::path
