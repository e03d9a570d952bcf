#include "stops/stop_run.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/common/deadline.h"
#include "cobot_command/script/script_command.h"

namespace cobot_command::command {

using Event = StopEvent;
using State = StopState;

namespace {

/// The status stream is a connection of its own: a frame that comes behind the controller's OK may have been
/// on its way before. So the first one proves nothing, nor what comes so soon behind it that they may have
/// waited together. Below the period of the stream, 15 ms.
constexpr Duration kApart = std::chrono::milliseconds(10);

/// Why a stop was not accepted, and whether the controller said that it drops nothing.
std::pair<std::string, StopEnd> refusalIn(const link::ScriptAnswered& answer) {
  if (std::holds_alternative<protocol::ScriptReply>(answer.answer)) {
    return {"the controller refused StopAndClearBuffer()", StopEnd::Refused};
  }
  if (const auto* error = std::get_if<protocol::CommunicationError>(&answer.answer)) {
    const bool refused = error->code == protocol::CommunicationErrorCode::NotListening;
    return {protocol::describe(*error), refused ? StopEnd::Refused : StopEnd::Failed};
  }
  return {"no reply to StopAndClearBuffer()", StopEnd::Failed};
}

}  // namespace

const char* StopRun::Result::words() const {
  if (end == StopEnd::Unseen) {
    return "the controller accepted the stop, but no status stream shows whether the robot is at standstill";
  }
  return end == StopEnd::AtTarget ? "the robot is at standstill at the target of the motion: nothing shows "
                                    "that the stop took effect"
                                  : "the robot was stopped";
}

void StopRun::ask(const std::optional<robot::Target>& target, Instant now) {
  if (!link_.connected()) return;
  // Whatever was queued before is dropped, and its tags mean nothing any more.
  tags_.renewEpoch();
  Stop stop;
  stop.result.number = ++last_;
  last_at_ = now;
  stop.result.target = target;
  stop.told = hasToBeTold();
  stop.script_id = link_.sendScript(script::toText(script::ScriptCommand(script::StopAndClearBuffer{})), now);
  stops_.push_back(std::move(stop));
}

void StopRun::answered(const link::ScriptAnswered& answer, Instant now) {
  const auto stop =
      std::find_if(stops_.begin(), stops_.end(), [&](const Stop& s) { return s.script_id == answer.id; });
  if (stop == stops_.end()) return;
  const auto* reply = std::get_if<protocol::ScriptReply>(&answer.answer);
  stop->deadline = now + settings_.stop_timeout;
  if (reply != nullptr && reply->accepted) {
    stop->accepted_at = now;
    fire(*stop, Event::Accepted);
  } else {
    auto [found, end] = refusalIn(answer);
    stop->result.end = end;
    stop->result.failure = blocks::Failure{blocks::own_error::kStopNotConfirmed, std::move(found), ""};
    fire(*stop, Event::Refused);
  }
  settle();
}

void StopRun::linkLost(const std::string& reason) {
  for (Stop& stop : stops_) giveUp(stop, {blocks::motion_error::kLinkDropped, reason, ""});
  settle();
}

void StopRun::robotChanged() {
  if (!robot_.status()) return;
  const Instant frame = robot_.status()->received;
  for (Stop& stop : stops_) {
    if (stop.state != State::Settling) continue;
    if (!stop.first_frame) stop.first_frame = frame;
    stop.stands = robot_.moving() == false && frame - *stop.first_frame >= kApart;
  }
  settle();
}

void StopRun::advance(Instant now) {
  for (Stop& stop : stops_) {
    if (stop.deadline && now >= *stop.deadline) judge(stop);
  }
  settle();
}

/// One frame alone is enough now, if it came late enough: a stream may be as slow as that.
void StopRun::judge(Stop& stop) {
  if (stop.state == State::Failing) {
    fire(stop, Event::GiveUp);
    return;
  }
  const bool stands = robot_.moving() == false;
  if (stands && robot_.status()->received - stop.accepted_at >= kApart) {
    stop.stands = true;
    return;
  }
  const char* found =
      robot_.moving() == true
          ? "the robot still moves after the accepted stop"
          : "the stop was accepted, but the status stream did not then show the robot at standstill";
  giveUp(stop, {blocks::own_error::kStopNotConfirmed, found, ""});
}

void StopRun::giveUp(Stop& stop, const blocks::Failure& failure) {
  stop.result.end = StopEnd::Failed;
  stop.result.failure = failure;
  fire(stop, Event::GiveUp);
}

bool StopRun::hasToBeTold() const {
  return robot_.tellsMotion() ||
         std::any_of(stops_.begin(), stops_.end(), [](const Stop& stop) { return stop.told; });
}

bool StopRun::isAt(const std::optional<robot::Target>& target) const {
  if (!target || !robot_.status()) return false;
  const auto gap = robot::gapTo(*target, *robot_.status(), arm_,
                                {settings_.position_tolerance, settings_.angle_tolerance});
  return gap && gap->closed;
}

StopEnd StopRun::howItStands(const Stop& stop) const {
  if (!stop.told) return StopEnd::Unseen;
  return isAt(stop.result.target) ? StopEnd::AtTarget : StopEnd::Stopped;
}

void StopRun::fire(Stop& stop, StopEvent event) {
  const auto row = findTransition<StopTable>(stop.state, event);
  if (!row) return;
  stop.state = row->to;
  switch (row->action) {
    case StopAction::None:
      return;
    case StopAction::AwaitStandstill:
      // Where there never was a stream that tells, the accepted stop is all that can be known.
      stop.told = stop.told || hasToBeTold();
      stop.stands = !stop.told;
      return;
    case StopAction::EndStopped:
      stop.result.end = howItStands(stop);
      return;
    case StopAction::EndFailed:
      return;
  }
}

void StopRun::settle() {
  std::optional<bool> told_by_later;  // one that stands; it is good for all before it
  bool later_may_stand = false;
  for (auto stop = stops_.rbegin(); stop != stops_.rend(); ++stop) {
    if (stop->stands && !told_by_later) told_by_later = stop->told;
    if (told_by_later) {
      stop->told = *told_by_later;
      fire(*stop, Event::Standing);
    } else if (!later_may_stand && stop->state == State::Failing) {
      fire(*stop, Event::GiveUp);
    }
    later_may_stand = later_may_stand || stop->state == State::Asked || stop->state == State::Settling;
  }
  const auto goes_on = [](const Stop& stop) { return stop.state != State::Ended; };
  for (const Stop& stop : stops_) {
    if (!goes_on(stop)) results_.push_back(stop.result);
  }
  stops_.erase(std::remove_if(stops_.begin(), stops_.end(), std::not_fn(goes_on)), stops_.end());
}

std::optional<Instant> StopRun::nextDeadline() const {
  std::optional<Instant> next;
  for (const Stop& stop : stops_) {
    next = earlier(next, stop.deadline);
  }
  return next;
}

std::optional<StopRun::Result> StopRun::takeResult() {
  if (results_.empty()) return std::nullopt;
  Result result = std::move(results_.front());
  results_.pop_front();
  return result;
}

}  // namespace cobot_command::command
