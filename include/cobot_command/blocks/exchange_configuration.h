// ExchangeConfiguration of SRCI (doc/srci.md): sets how this interface behaves, and reports its properties.
// The interface is enabled while its goal is active.
//
// Names and numbers are those of SRCI. Times are in ms, the unit of SRCI.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cobot_command/blocks/shared/block_parts.h"

namespace cobot_command::blocks {

/// The kinds of data that both sides have.
struct DataSets {
  bool tools = false;
  bool frames = false;
  bool loads = false;
  bool work_areas = false;
  bool software_limits = false;
  bool default_dynamics = false;
  bool reference_dynamics = false;

  friend bool operator==(const DataSets& a, const DataSets& b);
};

/// Reaction to enabled data that is out of sync.
enum class SyncReaction : int { None = 0, NoEnable = 1, InterruptWhenEmpty = 2, InterruptAtOnce = 3 };

enum class ExchangeMode : int { SequencePrimary = 0, Parallel = 2 };  ///< both have the same meaning here

/// ParCmd.
struct ExchangeSettings {
  /// command::Severity; messages of this severity and above are kept and published, 0: none.
  int log_level = 0;
  bool wait_at_blending_zone = false;           ///< refused when true
  bool allow_sec_seq_while_subprogram = false;  ///< without effect
  bool allow_dynamic_blending = false;
  int delay_time = 0;              ///< [ms], 0..65535: the first motion waits this long for the next ones
  int wait_for_nr_of_cmd = 0;      ///< 0..64: or until this number of motions is queued; 0: ignored
  int life_sign_time_out = 0;      ///< [ms], 10..65535
  int sync_delay = 0;              ///< [ms], 0..65535: time from a difference to the reaction
  int sync_reaction = 0;           ///< SyncReaction
  DataSets data_in_sync = {};      ///< the caller's own copies are up to date
  DataSets data_enable_sync = {};  ///< the data that is compared
};

struct ExchangeConfigurationGoal {
  static constexpr const char* kName = "exchange_configuration";
  [[nodiscard]] static ErrorTable errors();

  std::string name;   ///< at most 20 printable characters; checked, without effect
  int exec_mode = 0;  ///< ExchangeMode
  int priority = 0;   ///< 0..4, without effect: there is nothing to prioritise
  ExchangeSettings settings;
};

enum class RiState : int { NotInitialized = 0, Initialized = 1, Synchronized = 2 };

/// OutCmd: the properties of the interface; all 0 before it is enabled.
struct ExchangeOutCmd {
  int length_acr = 0;  ///< number of commands that can be queued or running at once
  int highest_tool_index = 0;
  int highest_frame_index = 0;
  int highest_load_index = 0;
  int highest_work_area_index = 0;
  DataSets data_in_sync = {};  ///< the controller's part, without the caller's flags
  int change_index_tool = 0;   ///< last changed on the controller; 0: none
  int change_index_frame = 0;
  int change_index_load = 0;
  int change_index_work_area = 0;
  bool tells_motion_state = false;  ///< it reports accelerating, decelerating, constant velocity

  friend bool operator==(const ExchangeOutCmd& a, const ExchangeOutCmd& b);
};

/// Detail of the outcome and of the progress.
struct ExchangeReport {
  bool enabled = false;             ///< the settings apply
  bool busy = false;                ///< the interface is being enabled or disabled
  bool command_buffered = false;    ///< the core has accepted the command
  bool parameter_accepted = false;  ///< the present values apply
  std::string error_add_txt;        ///< at most 40 bytes
  int warning_id = 0;               ///< the last warning whose cause still exists
  int info_id = 0;
  ExchangeOutCmd out_cmd;
  int par_seq = 0;  ///< number of the settings that apply: 1, increased by each update
  RiState ri_state = RiState::NotInitialized;
  std::vector<std::string> unsupported;     ///< functions and data that a TM controller does not offer
  std::vector<std::string> without_effect;  ///< requested settings that have no effect
  std::vector<std::string> local_sets;  ///< data sets that the controller does not have, or does not stream
  double life_sign_worst_gap = 0;       ///< [ms] longest time between two frames of the controller

  /// True: all fields are equal, except for the gap, which grows with every late frame, and `unsupported`.
  [[nodiscard]] bool tellsTheSame(const ExchangeReport& other) const;
};

/// SRCI numbers of errors.
namespace exchange_error {
inline constexpr int kInvalidStep = 1;
inline constexpr int kTimedOut = 6;
inline constexpr int kParCmd = 8;
inline constexpr int kSyncMode = 10;
inline constexpr int kLifeSignLost = 0x80A5;
inline constexpr int kNotEnabled = 0x8612;        ///< of update_configuration; no goal reports it
inline constexpr int kMandatoryStopped = 0x8A02;  ///< of a message; no goal reports it
inline constexpr int kConnectionLost = 0x8AAD;    ///< also of messages
inline constexpr int kLifeSignTimeOut = 0x8D14;
inline constexpr int kLogLevel = 0x8D18;
inline constexpr int kSyncReaction = 0x8D33;
inline constexpr int kNumberOfCommands = 0x8D39;
inline constexpr int kWaitAtBlending = 0x8E21;
inline constexpr int kExecutionMode = 0x8F10;
inline constexpr int kOnlyOneInstance = 0x8F12;
}  // namespace exchange_error

/// SRCI numbers of warnings and infos. SRCI has no own warnings for loads: those of tools are used.
namespace exchange_note {
inline constexpr int kToolsDiffer = 0x6014;   ///< and they are not enabled
inline constexpr int kFramesDiffer = 0x6020;  ///< and they are not enabled
inline constexpr int kLoadsDiffer = 0x6026;   ///< and they are not enabled
inline constexpr int kToolsConflict = 0x7013;
inline constexpr int kFramesConflict = 0x7019;
inline constexpr int kToolsUnreachable = 0x7044;
inline constexpr int kFramesUnreachable = 0x7045;
inline constexpr int kQueueUsage = 0x7A01;
}  // namespace exchange_note

/// Name in SRCI of an error, warning or info of this block; "" for any other number.
[[nodiscard]] const char* srciNameOf(int id);

[[nodiscard]] GoalTraits traitsOf(const ExchangeConfigurationGoal& goal);
/// In order of precedence, which is the order of the inputs in SRCI.
[[nodiscard]] std::vector<Failure> check(const ExchangeConfigurationGoal& goal);
[[nodiscard]] std::vector<Failure> check(const ExchangeSettings& settings);

[[nodiscard]] std::vector<std::string> withoutEffect(const ExchangeConfigurationGoal& goal);

}  // namespace cobot_command::blocks
