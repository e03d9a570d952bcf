#include "paths/feedrate_desk.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/common/units.h"

namespace cobot_command::command {
namespace {

constexpr const char* kWaits = "paths wait until resume_path, or a feedrate above 0";

FeedrateAnswer refusal(int error_id, std::string message) {
  FeedrateAnswer answer;
  answer.error_id = error_id;
  answer.message = std::move(message);
  return answer;
}

std::optional<FeedrateAnswer> objectionTo(double percent, bool restarts, const blocks::PathPace& pace) {
  constexpr double kLeast = kPercent * path::kLowestFeedrate;
  constexpr double kMost = kPercent * path::kHighestFeedrate;
  if (percent != 0 && !(percent >= kLeast && percent <= kMost)) {
    return refusal(blocks::own_error::kFeedrateRange,
                   fmt::format("the feedrate is {} %, allowed: 0 to {}, and at least {:.6g} if it is above "
                               "0: choose one in this range",
                               percent, kMost, kLeast));
  }
  const double highest = kPercent * (restarts ? pace.highest_of_all : pace.highest);
  if (percent <= highest * (1 + 1e-9)) return std::nullopt;
  return refusal(blocks::own_error::kJointSpeed,
                 fmt::format("at {:.6g} % a joint would exceed its rated speed on a loaded path; highest "
                             "possible feedrate: {:.1f} %",
                             percent, std::floor(10 * highest) / 10));
}

}  // namespace

void FeedrateDesk::set(const FeedrateRequest& request, const FeedrateReply& reply, Instant now) {
  const blocks::PathPace pace = core_.turn.pace();
  const double percent = request.percent.value_or(kPercent * core_.desk.controls().feedrate);
  const bool restarts = request.restart && pace.can_restart && percent != 0;
  auto refused = objectionTo(percent, restarts, pace);
  if (!refused && restarts && !core_.robot.joints()) {
    refused =
        refusal(blocks::own_error::kStartUnknown, core_.robot.whyNoJoints() + "; or set it without restart");
  }
  if (refused) {
    refused->effective = kPercent * core_.desk.served().effective(pace.running);
    reply(*refused);
    return;
  }
  Waiting waiting{reply, {}};
  waiting.answer.success = true;
  if (percent == 0) {
    stop(pace, std::move(waiting), now);
  } else if (restarts) {
    restart(pace, percent / kPercent, std::move(waiting), now);
  } else {
    letGo(pace, percent / kPercent, std::move(waiting), now);
  }
}

void FeedrateDesk::stop(const blocks::PathPace& pace, Waiting waiting, Instant now) {
  ++requests_;
  core_.desk.stop(true);
  waiting.answer.message = pace.running ? "the path is stopped: resume_path continues it" : kWaits;
  if (core_.pause.isPausedByOthers()) waiting.answer.message = kWaits;
  if (!pace.running && !core_.pause.isPausing() && !core_.pause.isPausedByOthers()) {
    waiting.reply(waiting.answer);
    return;
  }
  core_.pause.hold(
      PauseDesk::Holder::Path,
      [waiting](const PauseDesk::Answer& answer) { answerTo(waiting, answer, /*replaces=*/false); }, now);
}

void FeedrateDesk::letGo(const blocks::PathPace& pace, double feedrate, Waiting waiting, Instant now) {
  const bool is_same = feedrate == core_.desk.controls().feedrate;
  core_.desk.setFeedrate(feedrate);
  const double asked = core_.desk.served().feedrate;
  waiting.answer.effective = kPercent * pace.running.value_or(asked);
  waiting.answer.from_point = waiting.restarts ? pace.active_point : is_same ? -1 : pace.next_point;
  if (waiting.restarts) {
    waiting.answer.message =
        "the path is stopped, and continues from the position of the robot when it has been planned";
  } else if (pace.running && *pace.running != asked) {
    waiting.answer.message =
        fmt::format("motions at the controller continue at {:.6g} %", waiting.answer.effective);
  }
  const auto done = [waiting, request = ++requests_, this](const PauseDesk::Answer& answer) {
    const bool is_meant_still = request == requests_;
    if (answer.done && is_meant_still) core_.desk.stop(false);
    answerTo(waiting, answer, /*replaces=*/true);
  };
  core_.pause.letGo(PauseDesk::Holder::Path, done, now);
}

/// In front of a Resume(): what was taken back does not go on.
void FeedrateDesk::restart(const blocks::PathPace& pace, double feedrate, Waiting waiting, Instant now) {
  core_.turn.restart();
  core_.forecast.forgetPath();
  core_.window.cancel("its feedrate has changed", now);
  waiting.restarts = true;
  letGo(pace, feedrate, std::move(waiting), now);
}

/// `replaces`: what holds the robot all the same is told in place of what was to be told, and not behind it.
void FeedrateDesk::answerTo(const Waiting& waiting, const PauseDesk::Answer& answer, bool replaces) {
  if (!answer.done) {
    waiting.reply(refusal(answer.error_id, answer.message));
    return;
  }
  FeedrateAnswer given = waiting.answer;
  if (!answer.message.empty()) {
    given.message = replaces ? answer.message : fmt::format("{}; {}", given.message, answer.message);
  }
  waiting.reply(given);
}

}  // namespace cobot_command::command
