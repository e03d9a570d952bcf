// ExchangeConfiguration of SRCI (doc/srci.md): how this interface shall behave, and what it has. Enabled for
// as long as its goal lives.
//
// Words and numbers are those of SRCI, times in its unit, ms.
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

/// What happens when enabled data are out of sync.
enum class SyncReaction : int { None = 0, NoEnable = 1, InterruptWhenEmpty = 2, InterruptAtOnce = 3 };

enum class ExchangeMode : int { SequencePrimary = 0, Parallel = 2 };  ///< the same here

/// ParCmd.
struct ExchangeSettings {
  int log_level = 0;  ///< command::Severity; messages of this severity and above are kept and told, 0: none
  bool wait_at_blending_zone = false;           ///< refused when true
  bool allow_sec_seq_while_subprogram = false;  ///< without effect
  bool allow_dynamic_blending = false;
  int delay_time = 0;              ///< [ms], 0..65535: so long the first motion waits for the next ones
  int wait_for_nr_of_cmd = 0;      ///< 0..64: or until so many motions wait; 0: not looked at
  int life_sign_time_out = 0;      ///< [ms], 10..65535
  int sync_delay = 0;              ///< [ms], 0..65535: from a difference to the reaction
  int sync_reaction = 0;           ///< SyncReaction
  DataSets data_in_sync = {};      ///< the caller's own copies are up to date
  DataSets data_enable_sync = {};  ///< what is compared
};

struct ExchangeConfigurationGoal {
  static constexpr const char* kName = "exchange_configuration";
  [[nodiscard]] static ErrorTable errors();

  std::string name;   ///< of the command, for messages; at most 20 printable characters
  int exec_mode = 0;  ///< ExchangeMode
  int priority = 0;   ///< 0..4, without effect: there is nothing to order
  ExchangeSettings settings;
};

enum class RiState : int { NotInitialized = 0, Initialized = 1, Synchronized = 2 };

/// OutCmd: what there is; all 0 before it is enabled.
struct ExchangeOutCmd {
  int length_acr = 0;  ///< commands that can be held at once
  int highest_tool_index = 0;
  int highest_frame_index = 0;
  int highest_load_index = 0;
  int highest_work_area_index = 0;
  DataSets data_in_sync = {};  ///< the controller's half, without the caller's flags
  int change_index_tool = 0;   ///< changed last on the controller; 0: none
  int change_index_frame = 0;
  int change_index_load = 0;
  int change_index_work_area = 0;
  bool tells_motion_state = false;  ///< accelerating, decelerating, constant velocity

  friend bool operator==(const ExchangeOutCmd& a, const ExchangeOutCmd& b);
};

/// Detail of its end and its progress.
struct ExchangeReport {
  bool enabled = false;             ///< the settings rule
  bool busy = false;                ///< enabling or disabling
  bool command_buffered = false;    ///< taken by the core
  bool parameter_accepted = false;  ///< the values of now rule
  std::string error_add_txt;        ///< at most 40 bytes
  int warning_id = 0;               ///< the last one whose cause is there
  int info_id = 0;
  ExchangeOutCmd out_cmd;
  int par_seq = 0;  ///< of the settings that rule: 1, and one more with each update
  RiState ri_state = RiState::NotInitialized;
  std::vector<std::string> unsupported;     ///< what a TM controller cannot do or tell
  std::vector<std::string> without_effect;  ///< what was asked for, and changes nothing
  std::vector<std::string> local_sets;      ///< of which the controller has no counterpart, or streams none
  double life_sign_worst_gap = 0;           ///< [ms] between two frames of the controller

  /// But for the gap, which grows with every late frame.
  [[nodiscard]] bool tellsTheSame(const ExchangeReport& other) const;
};

/// Numbers of SRCI.
namespace exchange_error {
inline constexpr int kInvalidStep = 1;
inline constexpr int kTimedOut = 6;
inline constexpr int kParCmd = 8;
inline constexpr int kSyncMode = 10;
inline constexpr int kLifeSignLost = 0x80A5;
inline constexpr int kNotEnabled = 0x8612;        ///< of the update, no goal has it
inline constexpr int kMandatoryStopped = 0x8A02;  ///< of a message, no goal has it
inline constexpr int kConnectionLost = 0x8AAD;    ///< of messages, too
inline constexpr int kLifeSignTimeOut = 0x8D14;
inline constexpr int kLogLevel = 0x8D18;
inline constexpr int kSyncReaction = 0x8D33;
inline constexpr int kNumberOfCommands = 0x8D39;
inline constexpr int kWaitAtBlending = 0x8E21;
inline constexpr int kExecutionMode = 0x8F10;
inline constexpr int kOnlyOneInstance = 0x8F12;
}  // namespace exchange_error

/// Warnings and infos, the same. SRCI has no warnings of loads of their own: those are of tools.
namespace exchange_note {
inline constexpr int kToolsDiffer = 0x6014;   ///< and are not enabled
inline constexpr int kFramesDiffer = 0x6020;  ///< the same
inline constexpr int kLoadsDiffer = 0x6026;   ///< the same
inline constexpr int kToolsConflict = 0x7013;
inline constexpr int kFramesConflict = 0x7019;
inline constexpr int kToolsUnreachable = 0x7044;
inline constexpr int kFramesUnreachable = 0x7045;
inline constexpr int kQueueUsage = 0x7A01;
}  // namespace exchange_note

/// Of an error, warning or info of this block, as SRCI has it; "" of any other.
[[nodiscard]] const char* srciNameOf(int id);

[[nodiscard]] GoalTraits traitsOf(const ExchangeConfigurationGoal& goal);
/// In the order in which they decide, which is that of SRCI's inputs.
[[nodiscard]] std::vector<Failure> check(const ExchangeConfigurationGoal& goal);
[[nodiscard]] std::vector<Failure> check(const ExchangeSettings& settings);

[[nodiscard]] std::vector<std::string> withoutEffect(const ExchangeConfigurationGoal& goal);

}  // namespace cobot_command::blocks
