#include "paths/feedrate_desk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/blocks/goal.h"

namespace cobot_command::command {
namespace {

constexpr double kPercent = 100.0;

FeedrateAnswer refusal(int error_id, std::string message) {
  FeedrateAnswer answer;
  answer.error_id = error_id;
  answer.message = std::move(message);
  return answer;
}

std::optional<FeedrateAnswer> objectionTo(double percent, const blocks::PathPace& pace) {
  constexpr double kMost = kPercent * path::kHighestFeedrate;
  if (!(percent >= 0 && percent <= kMost)) {
    return refusal(
        feedrate_error::kRange,
        fmt::format("the feedrate is {} %, allowed: 0 to {}: choose one in this range", percent, kMost));
  }
  const double highest = kPercent * pace.highest;
  if (percent <= highest * (1 + 1e-9)) return std::nullopt;
  return refusal(
      feedrate_error::kJointSpeed,
      fmt::format("at {:.6g} % a joint would be faster than its rated speed on a path that is loaded; "
                  "highest that fits: {:.1f} %",
                  percent, std::floor(10 * highest) / 10));
}

}  // namespace

void FeedrateDesk::set(const FeedrateRequest& request, const FeedrateReply& reply, Instant now) {
  const blocks::PathPace pace = turn_.pace();
  const double percent = request.percent.value_or(kPercent * desk_.controls().feedrate);
  if (const auto refused = objectionTo(percent, pace)) {
    reply(*refused);
    return;
  }
  Waiting waiting{0, reply, {}};
  waiting.answer.success = true;
  if (percent == 0) {
    stop(pace, std::move(waiting), now);
  } else {
    letGo(pace, percent / kPercent, std::move(waiting), now);
  }
}

void FeedrateDesk::stop(const blocks::PathPace& pace, Waiting waiting, Instant now) {
  desk_.stop(true);
  const bool has_motion = pace.running && !asked_;
  waiting.answer.message = pace.running ? "the path is stopped on its way: resume_path lets it go on"
                                        : "paths wait until resume_path, or a feedrate above 0";
  if (has_motion) {
    asked_ = true;
    send(script::Pause{}, std::move(waiting), now);
  } else {
    waiting.reply(waiting.answer);
  }
}

void FeedrateDesk::letGo(const blocks::PathPace& pace, double feedrate, Waiting waiting, Instant now) {
  const bool is_same = feedrate == desk_.controls().feedrate;
  desk_.setFeedrate(feedrate);
  waiting.answer.effective = kPercent * pace.running.value_or(feedrate);
  waiting.answer.from_point = is_same ? -1 : pace.next_point;
  if (pace.running && *pace.running != feedrate) {
    waiting.answer.message =
        fmt::format("what the controller has goes on at {:.6g} %", waiting.answer.effective);
  }
  if (asked_) {
    asked_ = false;
    send(script::Resume{}, std::move(waiting), now);
    return;
  }
  desk_.stop(false);
  waiting.reply(waiting.answer);
}

void FeedrateDesk::send(script::ScriptCommand command, Waiting waiting, Instant now) {
  const bool pauses = std::holds_alternative<script::Pause>(command);
  last_ += pauses == (last_ % 2 == 0) ? 1 : 2;
  waiting.key = last_;
  waiting_.push_back(std::move(waiting));
  blocks::Order order = blocks::settingOrder(std::move(command));
  order.stops_unanswered = pauses;
  blocks::Command sent;
  sent.key = last_;
  sent.block = blocks::kBlock<blocks::ProgramControlGoal>;
  sent.order = [order](const arm::Pose& /*base*/) { return order; };
  window_.sendBeside(sent, 0, now);
}

void FeedrateDesk::ended(const CommandWindow::Ended& ended) {
  const auto found = std::find_if(waiting_.begin(), waiting_.end(),
                                  [&](const Waiting& waiting) { return waiting.key == ended.key; });
  if (found == waiting_.end()) return;
  const Waiting waiting = std::move(*found);
  waiting_.erase(found);
  const bool pauses = ended.key % 2 == 1;
  if (ended.outcome.ending == blocks::Ending::Done) {
    if (ended.key == last_) setPaused(pauses);
    waiting.reply(waiting.answer);
    return;
  }
  if (ended.key == last_) asked_ = !pauses;
  waiting.reply(refusal(
      ended.outcome.error_id,
      fmt::format("{} was not taken: {}", pauses ? "Pause()" : "Resume()", ended.outcome.error_description)));
}

void FeedrateDesk::setPaused(bool paused) {
  asked_ = paused;
  paused_ = paused;
  seen_ = false;
  robot_.pausedByUs(paused);
  if (!paused) desk_.stop(false);
}

void FeedrateDesk::robotChanged() {
  if (!paused_ || !robot_.tellsPause()) return;
  if (robot_.paused()) {
    seen_ = true;
  } else if (seen_) {
    setPaused(false);
    actions_.emplace_back(LogMessage{Severity::Warning,
                                     "the project goes on, though the path was stopped: somebody let it go"});
  }
}

/// Its commands end by themselves. Whether the project is paused behind the next link nobody knows here;
/// paths wait all the same.
void FeedrateDesk::linkLost() {
  asked_ = false;
  paused_ = false;
  robot_.pausedByUs(false);
}

}  // namespace cobot_command::command
