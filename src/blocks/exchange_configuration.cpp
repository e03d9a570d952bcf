#include "cobot_command/blocks/exchange_configuration.h"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::blocks {
namespace {

using namespace exchange_error;
using namespace exchange_note;

constexpr std::size_t kLongestName = 20;
constexpr int kLowestPriority = 4;
constexpr int kLogLevels[] = {0, 4, 5, 20, 28, 29};
constexpr int kMostHeld = 64;
constexpr int kShortestLifeSign = 10;
constexpr int kLongestTime = 65535;  // [ms]
constexpr int kReactions = 3;

auto asTuple(const DataSets& s) {
  return std::tie(s.tools, s.frames, s.loads, s.work_areas, s.software_limits, s.default_dynamics,
                  s.reference_dynamics);
}

auto asTuple(const ExchangeOutCmd& c) {
  return std::tie(c.length_acr, c.highest_tool_index, c.highest_frame_index, c.highest_load_index,
                  c.highest_work_area_index, c.data_in_sync, c.change_index_tool, c.change_index_frame,
                  c.change_index_load, c.change_index_work_area, c.tells_motion_state);
}

bool isPrintable(const std::string& name) {
  return std::all_of(name.begin(), name.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

bool isIn(int value, int least, int most) {
  return value >= least && value <= most;
}

std::vector<Failure> checkCommand(const ExchangeConfigurationGoal& goal) {
  std::vector<Failure> failures;
  if (goal.name.size() > kLongestName || !isPrintable(goal.name)) {
    failures.push_back({kParCmd,
                        fmt::format("name is '{}' ({} bytes), allowed: {} printable ASCII characters",
                                    foreignText(goal.name, kQuoteLimit), goal.name.size(), kLongestName),
                        ""});
  } else if (!isIn(goal.priority, 0, kLowestPriority)) {
    failures.push_back(
        {kParCmd, fmt::format("priority is {}, allowed: 0 to {}", goal.priority, kLowestPriority), ""});
  }
  if (goal.exec_mode != static_cast<int>(ExchangeMode::SequencePrimary) &&
      goal.exec_mode != static_cast<int>(ExchangeMode::Parallel)) {
    failures.push_back({kExecutionMode, fmt::format("exec_mode is {}", goal.exec_mode), ""});
  }
  return failures;
}

}  // namespace

bool operator==(const DataSets& a, const DataSets& b) {
  return asTuple(a) == asTuple(b);
}

bool operator==(const ExchangeOutCmd& a, const ExchangeOutCmd& b) {
  return asTuple(a) == asTuple(b);
}

bool ExchangeReport::tellsTheSame(const ExchangeReport& other) const {
  const auto tied = [](const ExchangeReport& r) {
    return std::tie(r.enabled, r.busy, r.command_buffered, r.parameter_accepted, r.error_add_txt,
                    r.warning_id, r.info_id, r.out_cmd, r.par_seq, r.ri_state, r.without_effect,
                    r.local_sets);
  };
  return tied(*this) == tied(other);
}

ErrorTable ExchangeConfigurationGoal::errors() {
  return ErrorTable()
      .row(kInvalidStep, "Invalid step", kExecuteAgain,
           "cannot occur: the states are a table; kept for clients that have steps of their own")
      .row(kTimedOut, "Timeout of the command", "Connect to the robot first, then send the goal again",
           "the link was not ready within 5 s; or the settings of the node could not be restored")
      .row(kParCmd, "Invalid name or priority",
           "Give at most 20 printable ASCII characters, and a priority of 0 to 4",
           "name is longer than 20 bytes or not printable, or priority is above 4")
      .row(kSyncMode, "Invalid mode of synchronisation", "Set ~sync/tools/start and the like to 0, 1 or 2",
           "cannot occur through ROS, because the node rejects such a parameter: a mode is unknown, or "
           "AUTOMATIC (3) at the start")
      .row(kLifeSignLost, "No life sign of the controller",
           "Check life_sign_worst_gap and choose a longer life_sign_time_out; check the wiring. If the robot "
           "still moves, stop it by other means, then connect again",
           "enabled, and no frame arrived from the controller for life_sign_time_out")
      .row(kConnectionLost, "Connection lost",
           "Connect again, then send a new goal: nothing is enabled automatically",
           "enabled, and the connection was closed by either side")
      .row(kLifeSignTimeOut, "Life sign timeout out of range",
           "Set 10 to 65535 ms; 300 ms suits most networks",
           "life_sign_time_out is below 10 ms or above 65535 ms")
      .row(kLogLevel, "Log level unknown",
           "Use 0 (off), 4 (debug), 5 (info), 20 (warning), 28 (error) or 29 (fatal)",
           "log_level is none of these")
      .row(kSyncReaction, "Reaction of synchronisation unknown", "Use 0 to 3", "sync_reaction is above 3")
      .row(kNumberOfCommands, "Number of commands to wait for out of range", "Set 0 to 64; 0 waits for none",
           "wait_for_nr_of_cmd is above 64, the size of the queue; or delay_time or sync_delay is outside 0 "
           "to 65535")
      .row(kWaitAtBlending, "Waiting at the blending zone is not supported",
           "Set wait_at_blending_zone to false",
           "wait_at_blending_zone is true: a TM controller has no command that stops where a blend would "
           "begin")
      .row(kExecutionMode, "Execution mode unknown",
           "Use 0 (SEQUENCE_PRIMARY) or 2 (PARALLEL), which mean the same", "exec_mode is neither 0 nor 2")
      .row(kOnlyOneInstance, "Only one instance is allowed",
           "Change the settings with update_configuration, or cancel the active goal",
           "another goal of this block has not ended")
      .shared({own_error::kShutDown});
}

const char* srciNameOf(int id) {
  struct Name {
    int id;
    const char* name;
  };
  static constexpr Name kNames[] = {
      {kInvalidStep, "INVALID_STEP"},
      {kTimedOut, "TIMEOUT_CMD"},
      {kParCmd, "INVALID_PAR_CMD"},
      {kSyncMode, "SYNC_MODE_INVALID"},
      {kLifeSignLost, "LIFESIGN_TIMEOUT"},
      {kNotEnabled, "COMMANDS_NOT_ENABLED"},
      {kConnectionLost, "CONNECTION_LOST"},
      {kLifeSignTimeOut, "LIFE_SIGN_TIMEOUT"},
      {kLogLevel, "LOG_LEVEL"},
      {kSyncReaction, "SYNC_REACTION"},
      {kNumberOfCommands, "WAIT_FOR_NR_OF_CMD"},
      {kWaitAtBlending, "WAIT_AT_BLENDING_POINT_NOT_SUPPORTED"},
      {kExecutionMode, "EXECUTION_MODE"},
      {kOnlyOneInstance, "ONLY_ONE_INSTANCE_ALLOWED"},
      // The library names these nowhere that is known here: the words are ours.
      {kQueueUsage, "ACR_USAGE_HIGH"},
      {kToolsConflict, "TOOL_CHANGED_ON_BOTH_SIDES"},
      {kFramesConflict, "FRAME_CHANGED_ON_BOTH_SIDES"},
      {kToolsUnreachable, "TOOL_NOT_READ_OR_WRITTEN"},
      {kFramesUnreachable, "FRAME_NOT_READ_OR_WRITTEN"},
      {kToolsDiffer, "TOOLS_NOT_IN_SYNC"},
      {kFramesDiffer, "FRAMES_NOT_IN_SYNC"},
      {kLoadsDiffer, "LOADS_NOT_IN_SYNC"},
  };
  const auto* const found =
      std::find_if(std::begin(kNames), std::end(kNames), [id](const Name& name) { return name.id == id; });
  return found == std::end(kNames) ? "" : found->name;
}

GoalTraits traitsOf(const ExchangeConfigurationGoal& /*goal*/) {
  GoalTraits traits;
  traits.way = Way::Configure;
  return traits;
}

std::vector<Failure> check(const ExchangeConfigurationGoal& goal) {
  std::vector<Failure> failures = checkCommand(goal);
  for (Failure& failure : check(goal.settings)) failures.push_back(std::move(failure));
  return failures;
}

std::vector<Failure> check(const ExchangeSettings& settings) {
  std::vector<Failure> failures;
  const auto require = [&failures](bool is_good, int id, std::string found) {
    if (!is_good) failures.push_back({id, std::move(found), ""});
  };
  const auto in_time = [](int time) { return isIn(time, 0, kLongestTime); };
  const bool is_level =
      std::find(std::begin(kLogLevels), std::end(kLogLevels), settings.log_level) != std::end(kLogLevels);
  require(is_level, kLogLevel, fmt::format("log_level is {}", settings.log_level));
  require(isIn(settings.wait_for_nr_of_cmd, 0, kMostHeld), kNumberOfCommands,
          fmt::format("wait_for_nr_of_cmd is {}", settings.wait_for_nr_of_cmd));
  require(in_time(settings.delay_time), kNumberOfCommands,
          fmt::format("delay_time is {} ms", settings.delay_time));
  require(in_time(settings.sync_delay), kNumberOfCommands,
          fmt::format("sync_delay is {} ms", settings.sync_delay));
  require(isIn(settings.life_sign_time_out, kShortestLifeSign, kLongestTime), kLifeSignTimeOut,
          fmt::format("life_sign_time_out is {} ms", settings.life_sign_time_out));
  require(isIn(settings.sync_reaction, 0, kReactions), kSyncReaction,
          fmt::format("sync_reaction is {}", settings.sync_reaction));
  require(!settings.wait_at_blending_zone, kWaitAtBlending, "wait_at_blending_zone is true");
  return failures;
}

std::vector<std::string> withoutEffect(const ExchangeConfigurationGoal& goal) {
  std::vector<std::string> names;
  if (goal.priority != 0) names.emplace_back("priority");
  if (goal.settings.allow_sec_seq_while_subprogram) names.emplace_back("allow_sec_seq_while_subprogram");
  return names;
}

}  // namespace cobot_command::blocks
