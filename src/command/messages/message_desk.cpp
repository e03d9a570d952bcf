#include "messages/message_desk.h"

#include <cctype>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/command/waiting_goals.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/link/stream_items.h"

namespace cobot_command::command {
namespace {

constexpr const char* kRobot = "robot";
constexpr const char* kQueue = "queue";
constexpr const char* kStatusStream = "status_stream";
constexpr const char* kArm = "robot_model";

Message emergencyStop() {
  return {0,
          {},
          Severity::Warning,
          MessageType::Arm,
          blocks::own_error::kEmergencyStop,
          kRobot,
          "emergency stop",
          "release it, and start the project again if necessary"};
}

Message queueNearlyFull() {
  return {0,
          {},
          Severity::Warning,
          MessageType::Interface,
          blocks::exchange_note::kQueueUsage,
          kQueue,
          "the queue of commands is 80 % full",
          "send no more until some are done: further ones are refused when it is full (16#216)"};
}

/// The controller has taken the script all the same.
Message scriptWarning(blocks::Block block, const blocks::Remarks& remarks) {
  return {0,
          {},
          Severity::Warning,
          MessageType::Command,
          0,
          toString(block),
          remarks.textOfWarnings(),
          "check these lines: the controller has executed them, but another version might not"};
}

Message itemsMissing(const std::vector<link::StreamItem>& missing) {
  return {0,
          {},
          Severity::Warning,
          MessageType::Interface,
          0,
          kStatusStream,
          fmt::format("the status stream does not have {}", describe(missing)),
          link::remedyForMissingItems()};
}

/// "TM5-900" for "tm5-900", "TM5X-900" and "TM5M-900": without camera, or with another supply, the arm is the
/// same.
std::string kinematicsOf(const std::string& model) {
  std::string name;
  for (const char letter : model) {
    const auto capital = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
    const bool is_variant = name.size() > 2 && (capital == 'X' || capital == 'M');
    if (!is_variant) name += capital;
  }
  return name;
}

Message anotherArm(const std::string& controller, const std::string& own) {
  return {0,
          {},
          Severity::Warning,
          MessageType::Interface,
          0,
          kArm,
          fmt::format("the controller moves a {}, but this node plans for a {}: poses are reached elsewhere",
                      foreignText(controller, kQuoteLimit), own),
          "stop, set ~robot_model to the model of the arm, and restart the node"};
}

}  // namespace

void MessageDesk::look(Instant now) {
  now_ = now;
  for (; looked_at_ < actions_.size(); ++looked_at_) {
    std::visit([this](const auto& action) { take(action); }, actions_[looked_at_]);
    quieten(actions_[looked_at_]);
  }
  for (Message& message : std::exchange(raised_, {})) {
    actions_.emplace_back(MessageRaised{std::move(message)});
  }
  tellPending();
  looked_at_ = actions_.size();
}

void MessageDesk::quieten(Action& action) const {
  auto* const log = std::get_if<LogMessage>(&action);
  if (log != nullptr && !board_.keeps(log->severity)) log->severity = Severity::Off;
}

void MessageDesk::take(const GoalEnded& end) {
  tellEnd(end.block, end.outcome, now_);
}

void MessageDesk::tellEnd(blocks::Block block, const blocks::Outcome& outcome, Instant now) {
  now_ = now;
  if (!outcome.remarks.warned_lines.empty()) raise(scriptWarning(block, outcome.remarks));
  if (outcome.error_id == 0) return;
  raise({0,
         {},
         Severity::Error,
         MessageType::Command,
         outcome.error_id,
         toString(block),
         outcome.error_description,
         outcome.remedy});
}

void MessageDesk::take(const LogMessage& message) {
  raise({0,
         {},
         message.severity,
         MessageType::Interface,
         message.code,
         "connection",
         message.text,
         message.remedy});
}

void MessageDesk::take(const StatusChanged& changed) {
  show(changed.status.queue_depth >= kManyCommands, queueNearlyFull());
}

void MessageDesk::take(const RobotStatusReceived& received) {
  // What was received, not what is known: an emergency stop closes the link, and what is known goes with it.
  const link::RobotStatus& status = received.status;
  show(status.emergency_stop.value_or(false), emergencyStop());
  tellMissingItems(status);
  tellAnotherArm(status);
  if (!status.error.value_or(false)) return;
  raise({0,
         {},
         Severity::Error,
         MessageType::Controller,
         status.error_code.value_or(0),
         kRobot,
         robot::errorText(status),
         "clear it at the robot stick or in TMflow, then reset"});
}

void MessageDesk::tellMissingItems(const link::RobotStatus& status) {
  const auto missing = link::missingItems(status);
  if (missing.empty()) {
    board_.end(kStatusStream, 0);
  } else {
    show(true, itemsMissing(missing));
  }
}

void MessageDesk::tellAnotherArm(const link::RobotStatus& status) {
  const std::string controller = status.identity.robot_model.value_or("");
  if (controller.empty() || arm_.empty() || kinematicsOf(controller) == kinematicsOf(arm_)) {
    board_.end(kArm, 0);
  } else {
    show(true, anotherArm(controller, arm_));
  }
}

void MessageDesk::raise(Message message, bool lasts) {
  message.time = now_;
  if (auto raised = board_.raise(std::move(message), lasts)) raised_.push_back(*std::move(raised));
}

void MessageDesk::show(bool is_so, const Message& warning) {
  if (is_so && board_.isPending(warning)) return;
  board_.end(warning.origin, warning.code);
  if (is_so) raise(warning, true);
}

void MessageDesk::tellPending() {
  auto pending = board_.pending();
  if (pending == told_pending_) return;
  told_pending_ = pending;
  actions_.emplace_back(PendingChanged{std::move(pending)});
}

ResetAnswer MessageDesk::reset() {
  const bool in_error = robot_.showsError();
  ResetAnswer answer;
  answer.acknowledged =
      static_cast<int>(in_error ? board_.acknowledge({MessageType::Controller}) : board_.acknowledge());
  answer.success = !in_error;
  answer.pending = board_.pending();
  answer.message = in_error ? fmt::format(
                                  "the controller shows {}: clear it at the robot stick or in TMflow, then "
                                  "reset again",
                                  robot_.errorText())
                            : fmt::format("{} acknowledged", answer.acknowledged);
  tellPending();
  return answer;
}

}  // namespace cobot_command::command
