// What a robot tells the supervisor: all of it each time, so that a report that is lost, doubled or late
// changes nothing but time (cell.md, M29).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/automata/problem.h"

namespace cobot_command::cell {

/// Of the program of one robot, by the number that the robot gives them: 1, 2, 3 ...
struct NumberedEvent {
  enum class Kind : std::uint8_t {
    Wanted,    ///< a go or a booking that it waits for
    Happened,  ///< a release, or that it has reached a station
    Withdrawn  ///< the go or booking of the number before, which nothing was done with: it counts as never
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
  Paused,   ///< it goes on by itself, later
  Manual,   ///< people move it
  Stopped,  ///< its program does not run any more: a cancel, a stop, a lost link
  Error,
  OffPath,  ///< its joints are not where the sent frames lead
  Unlinked  ///< nothing can be sent to it: there is no link to its controller, or no Listen node
};
[[nodiscard]] const char* toString(RobotCondition condition);

struct RobotReport {
  std::string robot;
  std::string hash;            ///< the digest of its artifact
  std::uint64_t session = 0;   ///< drawn at the start of the robot's node
  std::uint64_t instance = 0;  ///< of the supervisor that it knows; 0: none yet
  std::uint64_t number = 0;    ///< of reports of the session: an older one behind a newer tells nothing
  std::vector<NumberedEvent> events;  ///< since the last one that was acknowledged, in their order
  std::string place;                  ///< by name, for people
  std::array<double, 6> joints{};     ///< measured [rad]
  double status_age = 0.0;            ///< [s]
  RobotCondition condition = RobotCondition::Ok;
  bool moving = false;
  std::vector<std::uint32_t> touched_zones;  ///< by its bodies where they are, ascending
  std::string text;                          ///< for people
};

/// Of each text in a report [bytes].
inline constexpr std::size_t kLongestText = 256;

/// Why it is nothing that a robot could mean: numbers that are not finite or far out of range, texts and
/// lists too long.
[[nodiscard]] std::optional<std::string> malformed(const RobotReport& report);

}  // namespace cobot_command::cell
