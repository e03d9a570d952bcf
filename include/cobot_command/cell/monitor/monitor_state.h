// What the monitor of a cell tells: what is to be done, and how far robots and mechanisms are from each
// other.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cobot_command/cell/bodies/capsule.h"
#include "cobot_command/common/time.h"

namespace cobot_command::cell {

/// Two things that were closer than the margin, or may have been, from `start` to `end`.
struct Breach {
  std::string first;
  std::string second;
  std::string first_body;  ///< at the least distance
  std::string second_body;
  Instant start;
  double least = 0;     ///< that the distance may have been: as measured, less its uncertainty [m]
  double distance = 0;  ///< as measured, then [m]
  Instant least_at;
  std::optional<Instant> end;  ///< not yet, where there is none
};

/// All robots and mechanisms of the cell have to stop now, whatever they do.
struct StopAll {
  std::string why;  ///< a sentence
};
/// For people.
struct Warning {
  std::string text;  ///< a sentence
};
struct BreachEnded {
  Breach breach;
};
using MonitorAction = std::variant<StopAll, Warning, BreachEnded>;

/// Of two robots or mechanisms, or a robot and an obstacle.
struct PairStatus {
  std::string first;
  std::string second;
  bool known = false;  ///< both were heard; else nothing below counts
  /// Between the bodies as they were measured; negative where they reach into each other [m].
  double distance = 0;
  /// So much closer they may be by now [m].
  double uncertainty = 0;
  /// False: they are far from each other, and `distance` is only known to be no less than is said.
  bool exact = true;
  std::string first_body;  ///< of `distance`; empty where that is not exact
  std::string second_body;
  double least = 0;  ///< the least `distance` ever [m]
  Instant least_at;
  std::string least_first_body;
  std::string least_second_body;
  bool breached = false;  ///< closer than the margin, or maybe
};

/// What was not used, for diagnostics.
struct MonitorCounts {
  std::uint64_t malformed = 0;      ///< not finite, or nothing that an arm or a mechanism does
  std::uint64_t unknown = 0;        ///< of no robot or mechanism that is watched
  std::uint64_t old = 0;            ///< not measured later than what is known
  std::uint64_t lost_breaches = 0;  ///< records that were dropped for newer ones
};

struct MonitorStatus {
  bool latched = false;   ///< all were stopped, and are to stand until reset
  std::string diagnosis;  ///< a sentence, always
  std::vector<PairStatus> pairs;
  MonitorCounts counts;
};

/// What one thing is taken to consist of, where it was measured; empty before that.
struct SeenBodies {
  std::string name;                     ///< of the robot, mechanism or obstacle
  Capsules capsules;                    ///< in the world [m]
  std::vector<std::string> body_names;  ///< of each, as pairs have them
};

/// Whether it was done, and a sentence.
struct ResetAnswer {
  bool success = false;
  std::string message;
};

}  // namespace cobot_command::cell
