// What the controller's answers mean for a running command.

#include <algorithm>

#include "runs/command_run.h"
#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::command {
namespace {

using Event = CommandRunEvent;
using State = CommandRunState;

bool hasLine(const std::vector<std::string>& script, int line) {
  return line >= 1 && line <= static_cast<int>(script.size());
}

/// "line 1: PTP(...); line 3: QueueTag(...)" for the lines that the controller named, as errors or warnings;
/// of a long list the first ones. What it names beside the script is its own fault, and told as that.
std::string namedLines(const std::vector<std::string>& script, std::vector<int> lines) {
  constexpr std::size_t kMaxNamed = 8;
  if (lines.empty()) return "no line was named";
  std::sort(lines.begin(), lines.end());
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  const auto ours =
      std::stable_partition(lines.begin(), lines.end(), [&](int line) { return hasLine(script, line); });
  const auto named = static_cast<std::size_t>(ours - lines.begin());
  std::string text;
  for (std::size_t i = 0; i < std::min(named, kMaxNamed); ++i) {
    text += fmt::format("{}line {}: {}", i == 0 ? "" : "; ", lines[i],
                        foreignText(script[static_cast<std::size_t>(lines[i]) - 1]));
  }
  if (named > kMaxNamed) text += fmt::format("; and {} more lines", named - kMaxNamed);
  if (ours == lines.end()) return text;
  return fmt::format("{}{}the controller named {} that the script of {} lines does not have, such as line {}",
                     text, text.empty() ? "" : "; ",
                     lines.end() - ours == 1 ? "one" : fmt::format("{} lines", lines.end() - ours),
                     script.size(), *ours);
}

blocks::Failure rejectedBy(const protocol::ScriptReply& reply, const std::vector<std::string>& script) {
  blocks::Failure failure{blocks::motion_error::kRejected, namedLines(script, reply.lines), ""};
  for (const int line : reply.lines) {
    if (hasLine(script, line)) failure.refused_lines.push_back(script[static_cast<std::size_t>(line) - 1]);
  }
  return failure;
}

/// The controller takes no script at all.
bool saysNotListening(const protocol::CommunicationError& error) {
  return error.code == protocol::CommunicationErrorCode::NotListening;
}

blocks::Failure failureOf(const protocol::CommunicationError& error) {
  return {saysNotListening(error) ? blocks::own_error::kNotListening : blocks::own_error::kCommunication,
          protocol::describe(error), ""};
}

}  // namespace

void CommandRun::answered(const link::ScriptAnswered& answer, Instant now) {
  if (answer.id != script_id_) return;
  if (std::holds_alternative<link::NoReply>(answer.answer)) {
    if (state_ != State::Sent) return;  // cancelled meanwhile: now the stop is what counts
    fail({blocks::motion_error::kReceiveReply,
          fmt::format("no reply to script {} within {} s", answer.id,
                      toSeconds(order_.reply_timeout.value_or(context_.settings.reply_timeout))),
          ""},
         order_.beside ? Robot::LeaveIt : Robot::Stop, now);
    return;
  }
  if (const auto* error = std::get_if<protocol::CommunicationError>(&answer.answer)) {
    // Without an id it may be meant for another frame, and the controller may have the script.
    const bool may_move = order_.moves && !saysNotListening(*error);
    if (state_ == State::Sent) fail(failureOf(*error), may_move ? Robot::Stop : Robot::LeaveIt, now);
    return;
  }
  const auto& reply = std::get<protocol::ScriptReply>(answer.answer);
  if (reply.accepted) {
    accepted_at_ = now;
    if (!reply.lines.empty()) remarks_.warned_lines.push_back(namedLines(order_.lines, reply.lines));
    if (order_.exits_node || order_.has_exit) context_.link.exitAccepted(now);
    fire(!order_.tag ? Event::AcceptedLast : tag_seen_at_ ? Event::AcceptedBehindTag : Event::Accepted, now);
  } else if (state_ == State::Sent) {
    fail(rejectedBy(reply, order_.lines), Robot::LeaveIt, now);
  }
}

void CommandRun::tagFailed(Instant now) {
  fail({blocks::motion_error::kMotionFailed, fmt::format("tag {} was reported false", *order_.tag), ""},
       Robot::Stop, now, Event::Unexplained);
}

void CommandRun::tagIncomplete(protocol::TagState state, Instant now) {
  if (state_ != State::Confirming) return;
  if (clock_.askedEarly()) {
    // "false": the controller has the motion still, whatever it waits for.
    const bool dropped = state == protocol::TagState::Unknown;
    if (dropped && evidence_.stalled()) {
      fail({blocks::own_error::kStoppedElsewhere, evidence_.stallText(*order_.tag), ""}, Robot::Stop, now);
    } else {
      fire(Event::StillGoing, now);
    }
    return;
  }
  if (state == protocol::TagState::Unknown) {
    fail({blocks::own_error::kTagLost, fmt::format("the controller does not know tag {}", *order_.tag), ""},
         Robot::Stop, now);
    return;
  }
  // A frame from before the first question does not show what became of the motion since: this process may
  // have had no time to read the newer ones. The answer to a later question often comes before the next
  // frame.
  const auto& shown = context_.robot.status();
  const bool is_old = shown && shown->received < *asked_at_;
  const auto moving = context_.robot.moving();
  if (is_old || order_.is_open_ended || context_.robot.held() || moving == true ||
      (moving == false && !evidence_.rests()) || (!moving && clock_.patient(now))) {
    fire(Event::StillGoing, now);
  } else if (!moving) {
    fail({blocks::own_error::kTagLost, fmt::format("tag {} is still not complete", *order_.tag), ""},
         Robot::Stop, now);
  } else {
    fail({blocks::motion_error::kMotionFailed,
          fmt::format("the robot is at standstill, tag {} is not complete", *order_.tag), ""},
         Robot::Stop, now);
  }
}

void CommandRun::tagQueryFailed(const std::string& reason, Instant now) {
  if (state_ != State::Confirming) return;
  if (clock_.askedEarly()) {  // it was a question before its time
    fire(Event::StillGoing, now);
    return;
  }
  fail({blocks::motion_error::kReceiveTag, fmt::format("tag {} was queried: {}", *order_.tag, reason), ""},
       Robot::Stop, now);
}

}  // namespace cobot_command::command
