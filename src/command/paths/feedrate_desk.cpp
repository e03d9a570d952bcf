#include "paths/feedrate_desk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/blocks/goal.h"
#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::command {
namespace {

constexpr double kPercent = 100.0;

FeedrateAnswer refusal(int error_id, std::string message) {
  FeedrateAnswer answer;
  answer.error_id = error_id;
  answer.message = std::move(message);
  return answer;
}

std::optional<FeedrateAnswer> objectionTo(double percent, bool restarts, const blocks::PathPace& pace) {
  constexpr double kMost = kPercent * path::kHighestFeedrate;
  if (!(percent >= 0 && percent <= kMost)) {
    return refusal(
        blocks::own_error::kFeedrateRange,
        fmt::format("the feedrate is {} %, allowed: 0 to {}: choose one in this range", percent, kMost));
  }
  const double highest = kPercent * (restarts ? pace.highest_of_all : pace.highest);
  if (percent <= highest * (1 + 1e-9)) return std::nullopt;
  return refusal(
      blocks::own_error::kJointSpeed,
      fmt::format("at {:.6g} % a joint would be faster than its rated speed on a path that is loaded; "
                  "highest that fits: {:.1f} %",
                  percent, std::floor(10 * highest) / 10));
}

}  // namespace

void FeedrateDesk::set(const FeedrateRequest& request, const FeedrateReply& reply, Instant now) {
  const blocks::PathPace pace = core_.turn.pace();
  const double percent = request.percent.value_or(kPercent * core_.desk.controls().feedrate);
  const bool restarts = request.restart && pace.can_restart && percent != 0;
  auto refused = objectionTo(percent, restarts, pace);
  if (!refused && restarts && !core_.robot.joints()) {
    refused = refusal(blocks::own_error::kStartUnknown,
                      "the status stream does not tell where the robot stands: set it without restart");
  }
  if (refused) {
    refused->effective = kPercent * core_.desk.controls().effective(pace.running);
    reply(*refused);
    return;
  }
  Waiting waiting{0, reply, {}};
  waiting.answer.success = true;
  if (percent == 0) {
    stop(pace, std::move(waiting), now);
  } else if (restarts) {
    restart(pace, percent / kPercent, std::move(waiting), now);
  } else {
    letGo(pace, percent / kPercent, std::move(waiting), now);
  }
}

/// A project that somebody else has paused is left to him: what stands needs no pause, and would be let go
/// with it.
void FeedrateDesk::stop(const blocks::PathPace& pace, Waiting waiting, Instant now) {
  core_.desk.stop(true);
  waiting.answer.message = pace.running ? "the path is stopped on its way: resume_path lets it go on"
                                        : "paths wait until resume_path, or a feedrate above 0";
  const bool stands = core_.robot.tellsPause() && core_.robot.paused();
  if (hold_ == Hold::Pausing) {
    waiting.key = last_;
    waiting_.push_back(std::move(waiting));
  } else if (stands && hold_ == Hold::None) {
    waiting.answer.message = "paths wait until resume_path, or a feedrate above 0; " + heldByOthers();
    waiting.reply(waiting.answer);
  } else if (!pace.running || hold_ == Hold::Paused) {
    waiting.reply(waiting.answer);
  } else {
    send(Hold::Pausing, std::move(waiting), now);
  }
}

void FeedrateDesk::letGo(const blocks::PathPace& pace, double feedrate, Waiting waiting, Instant now) {
  const bool is_same = feedrate == core_.desk.controls().feedrate;
  core_.desk.setFeedrate(feedrate);
  waiting.answer.effective = kPercent * pace.running.value_or(feedrate);
  waiting.answer.from_point = waiting.restarts ? pace.active_point : is_same ? -1 : pace.next_point;
  if (waiting.restarts) {
    waiting.answer.message =
        "the path is stopped, and goes on from where the robot stands when it is planned";
  } else if (pace.running && *pace.running != feedrate) {
    waiting.answer.message =
        fmt::format("what the controller has goes on at {:.6g} %", waiting.answer.effective);
  }
  if (hold_ == Hold::Resuming) {
    waiting.key = last_;
    waiting_.push_back(std::move(waiting));
  } else if (hold_ == Hold::None || others_pause_) {
    changeTo(Hold::None);
    core_.desk.stop(false);
    if (const std::string held = heldByOthers(); !held.empty()) waiting.answer.message = held;
    waiting.reply(waiting.answer);
  } else {
    send(Hold::Resuming, std::move(waiting), now);
  }
}

/// In front of a Resume(): what was taken back does not go on.
void FeedrateDesk::restart(const blocks::PathPace& pace, double feedrate, Waiting waiting, Instant now) {
  core_.turn.restart();
  core_.forecast.forgetPath();
  core_.window.cancel("its feedrate is another one", now);
  waiting.restarts = true;
  letGo(pace, feedrate, std::move(waiting), now);
}

void FeedrateDesk::send(Hold hold, Waiting waiting, Instant now) {
  if (const auto failures = core_.objections(); !failures.empty()) {
    waiting.reply(
        refusal(failures.front().error_id, "there is no connection over which the robot could be told"));
    return;
  }
  changeTo(hold);
  waiting.key = ++last_;
  waiting_.push_back(std::move(waiting));
  const bool pauses = hold == Hold::Pausing;
  blocks::Order order =
      blocks::settingOrder(pauses ? script::ScriptCommand(script::Pause{}) : script::Resume{});
  order.stops_unanswered = pauses;
  blocks::Command sent;
  sent.key = last_;
  sent.block = blocks::kBlock<blocks::ProgramControlGoal>;
  sent.order = [order](const arm::Pose& /*base*/) { return order; };
  core_.window.sendBeside(sent, 0, now);
}

void FeedrateDesk::ended(const CommandWindow::Ended& ended) {
  const bool is_done = ended.outcome.ending == blocks::Ending::Done;
  if (ended.key == last_ && hold_ == Hold::Pausing) {
    changeTo(is_done ? Hold::Paused : Hold::None);
  } else if (ended.key == last_ && hold_ == Hold::Resuming) {
    changeTo(is_done ? Hold::None : Hold::Paused);
    if (is_done) core_.desk.stop(false);
  }
  const auto mine = std::stable_partition(waiting_.begin(), waiting_.end(),
                                          [&](const Waiting& waiting) { return waiting.key != ended.key; });
  const std::vector<Waiting> answered(mine, waiting_.end());
  waiting_.erase(mine, waiting_.end());
  for (const Waiting& waiting : answered) {
    waiting.reply(is_done ? waiting.answer
                          : refusal(ended.outcome.error_id,
                                    "the controller has not taken it: " + ended.outcome.error_description));
  }
}

void FeedrateDesk::changeTo(Hold hold) {
  if (hold == Hold::Pausing) seen_ = false;
  if (hold == Hold::Pausing || hold == Hold::None) others_pause_ = false;
  hold_ = hold;
  const bool stands = hold == Hold::Paused || hold == Hold::Resuming;
  core_.robot.pausedByUs(stands);
  core_.desk.hold(stands);
}

std::string FeedrateDesk::heldByOthers() const {
  if (!core_.robot.held()) return "";
  if (!core_.robot.paused()) return "a safeguard holds the robot: it goes on when that is released";
  return "the project is paused, and not by stop_on_path on this link: program_control with RESUME, or the "
         "pendant, lets it go on";
}

/// An emergency stop, and a project that is stopped, end a pause, too; the path stays stopped then.
void FeedrateDesk::robotChanged() {
  if (hold_ == Hold::None || !core_.robot.tellsPause()) return;
  if (core_.robot.emergencyStop() || core_.robot.projectStopped()) {
    forget();
  } else if (core_.robot.paused()) {
    seen_ = true;
  } else if (seen_ && (hold_ == Hold::Paused || hold_ == Hold::Resuming)) {
    if (hold_ == Hold::Paused) {
      core_.actions.emplace_back(LogMessage{
          Severity::Warning, "the project goes on, though the path was stopped: somebody let it go"});
    }
    changeTo(Hold::None);
    core_.desk.stop(false);
  }
}

void FeedrateDesk::forget() {
  changeTo(Hold::None);
  ++last_;  // no answer that is still to come counts
}

}  // namespace cobot_command::command
