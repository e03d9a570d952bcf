// What the supervisor tells everyone: all of it each time.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/cell/model/cell_program.h"
#include "cobot_command/common/time.h"

namespace cobot_command::cell {

enum class SupervisorMode : std::uint8_t {
  Starting,  ///< until each robot has told where it is, and that is where it has to be
  Ready,     ///< all stand at home
  Running,
  Holding,   ///< nothing new is granted
  Recovery,  ///< after a restart that does not fit, until each robot that is named was recovered
  Fault      ///< nothing is granted until the supervisor is started anew
};
[[nodiscard]] const char* toString(SupervisorMode mode);

enum class RobotState : std::uint8_t {
  Absent,  ///< it has not told anything yet
  Ready,
  Moving,
  Waiting,
  Lost,  ///< silent for longer than the lease, or started anew
  Manual,
  OffPath,
  Fault,
  Out  ///< taken out of the cell
};
[[nodiscard]] const char* toString(RobotState state);

/// Why a robot waits.
enum class WaitReason : std::uint8_t {
  None,
  ZoneHeld,
  WouldBlock,   ///< not all could come home behind it
  Aged,         ///< one that has waited for long goes first
  Quarantined,  ///< the zone is that of a robot that is lost, or stands in it unasked
  Holding,      ///< nothing is granted now
  Scheduled     ///< it is another's turn on the zone, by the schedule
};
[[nodiscard]] const char* toString(WaitReason reason);

struct RobotStatus {
  std::string name;
  RobotState state = RobotState::Absent;
  std::uint64_t session = 0;       ///< that is listened to
  std::uint64_t acknowledged = 0;  ///< the highest number that was carried out
  /// How often it was let in, or recovered: once more, and it goes on from `place`, whatever it was before.
  std::uint32_t joins = 0;
  std::string place;
  WaitReason reason = WaitReason::None;
  std::vector<std::string> blocked_by;  ///< robots
  std::uint32_t place_in_queue = 0;     ///< 1: next; 0: it waits for nothing
  Duration waiting{};
  std::uint64_t report = 0;  ///< number of the last one that was heard of this session; 0: none
  Duration report_age{};
  std::string text;  ///< a sentence, where something is wrong
};

enum class ZoneState : std::uint8_t { Free, Held, Quarantined };
[[nodiscard]] const char* toString(ZoneState state);

struct ZoneStatus {
  std::string name;
  std::vector<std::string> users;
  ZoneState state = ZoneState::Free;
  std::string owner;
  Duration since{};  ///< how long it has been so
  std::vector<std::string> waiting;
};

struct CellStatus {
  std::string cell;
  std::string hash;            ///< the digest of the artifact
  std::uint64_t instance = 0;  ///< drawn with the journal
  std::uint64_t epoch = 0;     ///< one more with each start
  std::uint64_t events = 0;    ///< carried out since the journal began
  SupervisorMode mode = SupervisorMode::Starting;
  std::string policy;
  bool is_finishing = false;  ///< no robot begins another cycle
  std::vector<RobotStatus> robots;
  std::vector<ZoneStatus> zones;
  std::string diagnosis;  ///< a sentence, where something keeps the cell
};

/// They tell the same, but for how long it has been so and what was heard last.
[[nodiscard]] bool areAlike(const CellStatus& one, const CellStatus& other);

}  // namespace cobot_command::cell
