// The state that the supervisor publishes, complete each time.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/cell/model/cell_program.h"
#include "cobot_command/common/time.h"

namespace cobot_command::cell {

enum class SupervisorMode : std::uint8_t {
  Starting,  ///< until each robot has reported its position, and all positions are valid
  Ready,     ///< all robots are at home
  Running,
  Holding,   ///< nothing new is granted
  Recovery,  ///< after a restart with invalid positions, until each named robot was recovered
  Fault      ///< nothing is granted until the supervisor is restarted
};
[[nodiscard]] const char* toString(SupervisorMode mode);

enum class RobotState : std::uint8_t {
  Absent,  ///< it has not reported yet
  Ready,
  Moving,
  Waiting,
  Lost,  ///< silent for longer than the lease, or restarted
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
  WouldBlock,   ///< afterwards not all robots could reach home
  Aged,         ///< a robot that has waited for long has priority
  Quarantined,  ///< the zone is that of a lost robot, or a robot is in it without permission
  Holding,      ///< grants are on hold
  Scheduled     ///< according to the schedule it is another robot's turn on the zone
};
[[nodiscard]] const char* toString(WaitReason reason);

struct RobotStatus {
  std::string name;
  RobotState state = RobotState::Absent;
  std::uint64_t session = 0;       ///< accepted session
  std::uint64_t acknowledged = 0;  ///< the highest number that was carried out
  /// How often it was admitted or recovered. When it increases, the robot continues from `place`, whatever
  /// its place was before.
  std::uint32_t joins = 0;
  std::string place;
  WaitReason reason = WaitReason::None;
  std::vector<std::string> blocked_by;  ///< robots
  std::uint32_t place_in_queue = 0;     ///< 1: next; 0: it waits for nothing
  Duration waiting{};
  std::uint64_t report = 0;  ///< number of the last received report of this session; 0: none
  Duration report_age{};
  std::string text;  ///< a sentence if there is a problem
};

enum class ZoneState : std::uint8_t { Free, Held, Quarantined };
[[nodiscard]] const char* toString(ZoneState state);

struct ZoneStatus {
  std::string name;
  std::vector<std::string> users;
  ZoneState state = ZoneState::Free;
  std::string owner;
  Duration since{};  ///< duration of this state
  std::vector<std::string> waiting;
};

struct CellStatus {
  std::string cell;
  std::string hash;            ///< the digest of the artifact
  std::uint64_t instance = 0;  ///< random number, created with the journal
  std::uint64_t epoch = 0;     ///< increases with each start
  std::uint64_t events = 0;    ///< carried out since the start of the journal
  SupervisorMode mode = SupervisorMode::Starting;
  std::string policy;
  bool is_finishing = false;  ///< no robot begins another cycle
  std::vector<RobotStatus> robots;
  std::vector<ZoneStatus> zones;
  std::string diagnosis;  ///< a sentence if something blocks the cell
};

/// True if they are equal except for durations and received report numbers.
[[nodiscard]] bool areAlike(const CellStatus& one, const CellStatus& other);

}  // namespace cobot_command::cell
