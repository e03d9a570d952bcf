// What the tasks say: pure, of a view.

#include <string>

#include <fmt/format.h>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/link/stream_items.h"
#include "cobot_command/link/tag_ledger.h"
#include "cobot_command/ros/command/diagnostics.h"

namespace cobot_command::ros_adapter {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;
using LinkState = command::CommandStatus::LinkState;

bool isConnected(const DiagnosticsView& view) {
  return view.command.link == LinkState::NotListening || view.command.link == LinkState::Ready;
}

/// The last connect goal ended with an error: nobody wanted the link to end.
const command::BlockOutputs* failedConnect(const command::CommandStatus& status) {
  for (const command::BlockOutputs& outputs : status.blocks) {
    if (outputs.block == blocks::kBlock<blocks::ConnectGoal> && outputs.error) return &outputs;
  }
  return nullptr;
}

std::string orElse(const std::string& text, const char* otherwise) {
  return text.empty() ? otherwise : text;
}

const char* toWord(const std::optional<bool>& value) {
  if (!value) return "unknown";
  return *value ? "yes" : "no";
}

const char* toMode(const std::optional<int>& mode) {
  switch (mode.value_or(0)) {
    case 1:
      return "automatic";
    case 2:
      return "manual";
    default:
      return "unknown";
  }
}

}  // namespace

void describeLink(DiagnosticStatusWrapper& status, const DiagnosticsView& view) {
  const command::CommandStatus& command = view.command;
  const command::BlockOutputs* failed = failedConnect(command);
  if (isConnected(view)) {
    status.summary(DiagnosticStatus::OK,
                   forPeople(fmt::format("connected to {}:{}", command.host, command.port)));
  } else if (command.link == LinkState::Disconnected && failed != nullptr) {
    status.summary(DiagnosticStatus::ERROR,
                   forPeople(failed->error_description) + "; send a connect goal when the cause is fixed");
  } else if (command.link == LinkState::Disconnected) {
    status.summary(DiagnosticStatus::WARN, "not connected; send a connect goal");
  } else {
    status.summary(DiagnosticStatus::WARN, orElse(forPeople(command.diagnosis), "connecting"));
  }
  status.add("state", command::toString(command.link));
  status.add("controller",
             command.host.empty() ? "none" : fmt::format("{}:{}", forPeople(command.host), command.port));
  status.add("late replies", command.late_replies);
  status.add("faulty frames", command.decode_faults);
}

void describeListenNode(DiagnosticStatusWrapper& status, const DiagnosticsView& view) {
  if (view.command.link == LinkState::Ready) {
    status.summary(DiagnosticStatus::OK, "the robot's flow is in the Listen node: commands are accepted");
  } else if (view.command.link == LinkState::NotListening) {
    status.summary(
        DiagnosticStatus::WARN,
        orElse(forPeople(view.command.diagnosis),
               "the robot's flow is not in the Listen node: commands are refused; let the project enter it"));
  } else {
    status.summary(DiagnosticStatus::STALE, "unknown: not connected");
  }
  status.add("entry message", orElse(forPeople(view.command.listen_node), "none"));
}

void describeQueue(DiagnosticStatusWrapper& status, const DiagnosticsView& view) {
  constexpr int kTags = link::TagLedger::kLast - link::TagLedger::kFirst + 1;
  const auto& tags = view.command.open_tags;
  if (tags.size() >= static_cast<std::size_t>(kTags)) {
    status.summary(DiagnosticStatus::WARN,
                   "every queue tag is in use; wait until a motion has ended, or stop");
  } else {
    status.summary(DiagnosticStatus::OK,
                   view.command.queue_depth == 0
                       ? std::string("no command is running")
                       : fmt::format("{} commands running, {} waiting", view.command.commands_under_way,
                                     view.command.commands_waiting));
  }
  status.add("commands", view.command.queue_depth);
  status.add("commands under way", view.command.commands_under_way);
  status.add("commands waiting", view.command.commands_waiting);
  status.add("queue tags in use", fmt::format("{}", fmt::join(tags, " ")));
}

void describeRobot(DiagnosticStatusWrapper& status, const DiagnosticsView& view) {
  if (!view.command.status_stream) {
    status.summary(DiagnosticStatus::STALE, "unknown: no status stream");
    return;
  }
  const link::RobotStatus& robot = view.robot;
  if (robot.emergency_stop.value_or(false)) {
    status.summary(DiagnosticStatus::ERROR,
                   "emergency stop; release it at the robot, then start the project again");
  } else if (robot.error.value_or(false)) {
    status.summary(DiagnosticStatus::ERROR,
                   fmt::format("the controller is in error: {} {}; execute stop, then the next motion clears "
                               "it; if not, clear it at the robot",
                               robot.error_code.value_or(0), forPeople(robot.error_text.value_or(""))));
  } else if (robot.safeguard.value_or(false)) {
    status.summary(DiagnosticStatus::WARN,
                   "a safeguard has paused the robot; it continues when the safeguard is released");
  } else if (robot.project_paused.value_or(false)) {
    status.summary(DiagnosticStatus::WARN, "paused; it continues after program_control RESUME");
  } else if (!robot.project_running.value_or(true)) {
    status.summary(DiagnosticStatus::WARN, "no project is running; start it at the robot");
  } else if (const auto missing = link::missingForReady(robot); !missing.empty()) {
    status.summary(
        DiagnosticStatus::WARN,
        forPeople(fmt::format("ready to move according to the status stream, but the stream lacks {}: {}",
                              link::describe(missing), link::remedyForMissingItems())));
  } else {
    status.summary(DiagnosticStatus::OK, "ready to move");
  }
  status.add("mode", toMode(robot.operating_mode));
  status.add("emergency stop", toWord(robot.emergency_stop));
  status.add("safeguard", toWord(robot.safeguard));
  status.add("error code", robot.error_code.value_or(0));
  status.add("error text", forPeople(robot.error_text.value_or("")));
  status.add("project running", toWord(robot.project_running));
  status.add("project paused", toWord(robot.project_paused));
  status.add("project speed [%]",
             robot.project_speed_percent ? std::to_string(*robot.project_speed_percent) : "unknown");
}

void describeStatusStream(DiagnosticStatusWrapper& status, const DiagnosticsView& view) {
  if (view.command.status_stream && !view.command.status_diagnosis.empty()) {
    status.summary(DiagnosticStatus::WARN, forPeople(view.command.status_diagnosis));
  } else if (view.command.status_stream) {
    status.summary(DiagnosticStatus::OK, fmt::format("{:.0f} frames a second", view.status_rate));
  } else if (!view.status_wanted) {
    status.summary(DiagnosticStatus::OK, "switched off: status_port is 0");
  } else if (view.command.link == LinkState::Disconnected) {
    status.summary(DiagnosticStatus::STALE, "unknown: not connected");
  } else {
    status.summary(DiagnosticStatus::WARN,
                   orElse(forPeople(view.command.status_diagnosis), "no status stream"));
  }
  status.add("rate [Hz]", fmt::format("{:.1f}", view.status_rate));
  status.add("age [s]", view.status_age ? fmt::format("{:.3f}", *view.status_age) : "none received yet");
}

/// Nobody needs it to move the robot, so that it is no warning where it is not enabled.
void describeExchange(DiagnosticStatusWrapper& status, const DiagnosticsView& view) {
  switch (view.group.ri_state) {
    case blocks::RiState::NotInitialized:
      status.summary(DiagnosticStatus::OK, "not enabled");
      break;
    case blocks::RiState::Initialized:
      status.summary(view.group.out_of_sync.empty() ? DiagnosticStatus::OK : DiagnosticStatus::WARN,
                     orElse(forPeople(view.group.out_of_sync), "enabled, nothing is compared"));
      break;
    case blocks::RiState::Synchronized:
      status.summary(DiagnosticStatus::OK, "enabled and in sync");
      break;
  }
  status.add("Enabled", view.group.ri_state != blocks::RiState::NotInitialized);
  status.add("Out of sync", orElse(forPeople(view.group.out_of_sync), "nothing"));
}

}  // namespace cobot_command::ros_adapter
