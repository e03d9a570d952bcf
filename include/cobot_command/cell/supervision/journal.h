// The journal of the events that a supervisor has carried out, for its restart (doc/cell.md).
//
// A record is a line: a checksum, and the record as JSON. A torn last line was never published, and is
// dropped. To bound the journal, a snapshot replaces all records before it.
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

/// The supervisor was started with this artifact.
struct Started {
  std::uint64_t instance = 0;
  std::uint64_t epoch = 0;
  std::string hash;
};
/// This session of a robot is accepted from now on. Its numbers start after `acknowledged`.
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
/// An operator has stated its place.
struct Recovered {
  std::string robot;
  std::string place;
  std::string person;
};
/// An operator has taken it out of the cell, with all its zones.
struct TakenOut {
  std::string robot;
  std::string person;
};
/// Nothing is granted from now on, for that reason; or grants continue.
struct Held {
  bool on = false;
  std::string reason;
};
/// No robot starts from home from now on; or robots start again.
struct Finishing {
  bool on = false;
};
/// The accumulated result of all records before it.
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

/// Hash of the artifact; nullptr: the record has none.
[[nodiscard]] const std::string* hashOf(const Record& record);
/// True if the record implies that a robot was admitted.
[[nodiscard]] bool tellsOfRobots(const Record& record);

[[nodiscard]] std::string toLine(const Record& record);

struct Damage {
  std::size_t line = 0;  ///< from 1
  std::string message;
};
/// All records of a journal. The last `torn` bytes belong to an incomplete record.
struct Contents {
  std::vector<Record> records;
  std::size_t torn = 0;
};
[[nodiscard]] Result<Contents, Damage> read(std::string_view bytes);

/// Writes a line durably, so that it survives a power loss; false: not written, and the line is void.
using Append = std::function<bool(const std::string& line)>;
/// Replaces the whole journal by that line, so that at any time either all old records or the line exist;
/// false: not replaced, and the journal is unchanged or can no longer be appended to.
using Replace = std::function<bool(const std::string& line)>;

}  // namespace cobot_command::cell::journal
