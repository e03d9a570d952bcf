// The bodies of one thing, ready to be compared with those of others: where they are, and how far each may
// have moved since.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "cobot_command/cell/bodies/capsule.h"

namespace cobot_command::cell::monitor {

/// Around a whole capsule, or several.
struct Ball {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0;
};

struct BodySet {
  Capsules capsules;           ///< in the world [m]
  std::vector<char> fixed;     ///< of each: it never moves
  std::vector<double> growth;  ///< of each: so far it may have moved [m]
  double most_growth = 0;
  std::vector<Ball> balls;  ///< of each
  Ball hull;                ///< of all

  /// After the capsules have changed.
  void encloseAll();
  /// None has moved since.
  void standStill();
};

/// Of what never moves; at least one capsule.
[[nodiscard]] BodySet fixedSet(const Capsules& capsules);

/// How far two sets are from each other.
struct Gap {
  double distance = 0;    ///< least of all bodies [m]
  double lowest = 0;      ///< least that it may be by now, by the growth of both [m]
  bool exact = true;      ///< false: both are lower bounds, and there are no bodies
  std::size_t first = 0;  ///< of `distance`
  std::size_t second = 0;

  [[nodiscard]] double uncertainty() const;
};

/// Exact where they are, or may be, within `exact_within` [m] of each other. Two bodies of which neither ever
/// moves are no matter: infinitely far. `hint` is a pair that was close before; any one will do.
[[nodiscard]] Gap gapBetween(const BodySet& first, const BodySet& second, double exact_within,
                             const Gap& hint);

}  // namespace cobot_command::cell::monitor
