// What a supervisor has carried out, so that it knows after a restart (cell.md, M30).
//
// A record is a line: a checksum, and the record as JSON. A torn last line was never told to anyone, and is
// dropped. So that a journal does not grow for ever, a snapshot takes the place of all records before it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cobot_command/cell/supervision/report.h"
#include "cobot_command/common/result.h"

namespace cobot_command::cell::journal {

/// The supervisor has started, with this artifact.
struct Started {
  std::uint64_t instance = 0;
  std::uint64_t epoch = 0;
  std::string hash;
};
/// From now on that session of a robot is listened to; its numbers begin behind `acknowledged`.
struct Joined {
  std::string robot;
  std::uint64_t session = 0;
  std::uint64_t acknowledged = 0;
};
struct CarriedOut {
  std::string robot;
  std::uint64_t session = 0;
  NumberedEvent event;
};
/// A person has said where it is.
struct Recovered {
  std::string robot;
  std::string place;
  std::string person;
};
/// A person has taken it out of the cell, with all zones that it had.
struct TakenOut {
  std::string robot;
  std::string person;
};
/// Nothing is granted from now on, for that reason; or everything again.
struct Held {
  bool on = false;
  std::string reason;
};
/// No robot sets out from home from now on; or all again.
struct Finishing {
  bool on = false;
};
/// What all records before it come to.
struct Snapshot {
  struct Robot {
    std::string robot;
    std::uint64_t session = 0;
    std::uint64_t acknowledged = 0;
    std::vector<NumberedEvent> recent;
    bool is_out = false;
    std::uint32_t joins = 0;
  };

  std::uint64_t instance = 0;
  std::uint64_t epoch = 0;
  std::string hash;
  std::vector<Robot> robots;                 ///< in the order of the cell, here and below
  std::vector<automata::StateIndex> states;  ///< of each automaton
  std::optional<std::string> held;
  bool is_finishing = false;
  std::uint64_t events = 0;
};
using Record = std::variant<Started, Joined, CarriedOut, Recovered, TakenOut, Held, Finishing, Snapshot>;

/// Of the artifact; nullptr: the record names none.
[[nodiscard]] const std::string* hashOf(const Record& record);
/// Somebody had been let in by then.
[[nodiscard]] bool tellsOfRobots(const Record& record);

[[nodiscard]] std::string toLine(const Record& record);

struct Damage {
  std::size_t line = 0;  ///< from 1
  std::string message;
};
/// All records of a journal; `torn` bytes at its end are of one that was not written wholly.
struct Contents {
  std::vector<Record> records;
  std::size_t torn = 0;
};
[[nodiscard]] Result<Contents, Damage> read(std::string_view bytes);

/// Writes a line so that it is there after a loss of power; false: it could not, and nothing of it counts.
using Append = std::function<bool(const std::string& line)>;
/// Has that line take the place of all that was written, so that at any moment either all of that is there or
/// the line; false: it could not, and the journal is what it was, or cannot be appended to any more.
using Replace = std::function<bool(const std::string& line)>;

}  // namespace cobot_command::cell::journal
