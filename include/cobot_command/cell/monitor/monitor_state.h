// Output of the monitor of a cell: actions, and the distances between robots and mechanisms.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cobot_command/cell/bodies/capsule.h"
#include "cobot_command/common/time.h"

namespace cobot_command::cell {

/// Two objects that were, or may have been, closer than the margin from `start` to `end`.
struct Breach {
  std::string first;
  std::string second;
  std::string first_body;  ///< at the smallest distance
  std::string second_body;
  Instant start;
  double least = 0;     ///< smallest possible distance: as measured, minus its uncertainty [m]
  double distance = 0;  ///< as measured at that time [m]
  Instant least_at;
  std::optional<Instant> end;  ///< std::nullopt: not ended yet
};

/// All robots and mechanisms of the cell must stop immediately.
struct StopAll {
  std::string why;  ///< a sentence
};
/// A message for the operator.
struct Warning {
  std::string text;  ///< a sentence
};
struct BreachEnded {
  Breach breach;
};
using MonitorAction = std::variant<StopAll, Warning, BreachEnded>;

/// A pair of robots or mechanisms, or a robot and an obstacle.
struct PairStatus {
  std::string first;
  std::string second;
  bool known = false;  ///< data of both was received; otherwise nothing below is valid
  /// Between the bodies as measured; negative if they overlap [m].
  double distance = 0;
  /// How much closer they may be now [m].
  double uncertainty = 0;
  /// False: they are far apart, and `distance` is a lower bound.
  bool exact = true;
  std::string first_body;  ///< of `distance`; empty if that is not exact
  std::string second_body;
  double least = 0;  ///< the smallest `distance` ever [m]
  Instant least_at;
  std::string least_first_body;
  std::string least_second_body;
  bool breached = false;  ///< closer than the margin, or possibly
};

/// Unused data, for diagnostics.
struct MonitorCounts {
  std::uint64_t malformed = 0;      ///< not finite, or impossible for an arm or a mechanism
  std::uint64_t unknown = 0;        ///< of a robot or mechanism that is not monitored
  std::uint64_t old = 0;            ///< not newer than the known data
  std::uint64_t lost_breaches = 0;  ///< records dropped in favour of newer ones
};

struct MonitorStatus {
  bool latched = false;   ///< all were stopped, and must remain stopped until the reset
  std::string diagnosis;  ///< always a sentence
  std::vector<PairStatus> pairs;
  MonitorCounts counts;
};

/// The assumed bodies of one object, at its measured position; empty before the first measurement.
struct SeenBodies {
  std::string name;                     ///< of the robot, mechanism or obstacle
  Capsules capsules;                    ///< in the world [m]
  std::vector<std::string> body_names;  ///< of each capsule, as in pairs
};

/// Whether the reset was done, and a sentence.
struct ResetAnswer {
  bool success = false;
  std::string message;
};

}  // namespace cobot_command::cell
