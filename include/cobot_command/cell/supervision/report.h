// The report of a robot to the supervisor. It is complete each time, so a lost, duplicate or late report only
// costs time (doc/cell.md).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/automata/problem.h"

namespace cobot_command::cell {

/// An event in the program of one robot. The robot numbers its events: 1, 2, 3 ...
struct NumberedEvent {
  enum class Kind : std::uint8_t {
    Wanted,    ///< a go or a booking that it waits for
    Happened,  ///< a release, or the arrival at a station
    Withdrawn  ///< the unused go or booking with the previous number is taken back; it counts as never
               ///< granted
  };
  std::uint64_t number = 0;
  Kind kind = Kind::Wanted;
  automata::EventIndex event = 0;

  bool operator==(const NumberedEvent& other) const {
    return number == other.number && kind == other.kind && event == other.event;
  }
  bool operator!=(const NumberedEvent& other) const { return !(*this == other); }
};

enum class RobotCondition : std::uint8_t {
  Ok,
  Paused,   ///< it continues automatically later
  Manual,   ///< people move it
  Stopped,  ///< its program no longer runs: a cancel, a stop, a lost connection
  Error,
  OffPath,  ///< its joints are not on the path of the sent frames
  Unlinked  ///< nothing can be sent to it: no connection to its controller, or no Listen node
};
[[nodiscard]] const char* toString(RobotCondition condition);

struct RobotReport {
  std::string robot;
  std::string hash;            ///< the digest of its artifact
  std::uint64_t session = 0;   ///< random number, created at the start of the robot's node
  std::uint64_t instance = 0;  ///< of the supervisor that it has accepted; 0: none yet
  std::uint64_t number = 0;    ///< report number in the session; an older report after a newer one is ignored
  std::vector<NumberedEvent> events;  ///< since the last acknowledged one, in order
  std::string place;                  ///< name, for display
  std::array<double, 6> joints{};     ///< measured [rad]
  double status_age = 0.0;            ///< [s]
  RobotCondition condition = RobotCondition::Ok;
  bool moving = false;
  std::vector<std::uint32_t> touched_zones;  ///< by its bodies at their current position, ascending
  std::string text;                          ///< for display
};

/// Limit of each text in a report [bytes].
inline constexpr std::size_t kLongestText = 256;

/// Why the report is invalid: numbers that are not finite or far out of range, texts and lists that are too
/// long.
[[nodiscard]] std::optional<std::string> malformed(const RobotReport& report);

}  // namespace cobot_command::cell
