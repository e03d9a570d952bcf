#include "stop_run.h"

#include <utility>

#include "cobot_command/blocks/error_ids.h"
#include "cobot_command/protocol/script_command.h"

namespace cobot_command::blocks {

using Event = StopEvent;

void StopRun::ask(Instant now) {
  if (link_.connected()) fire(Event::Ask, now);
}

void StopRun::answered(const link::ScriptAnswered& answer, Instant now) {
  if (answer.id != script_id_) return;
  const auto* reply = std::get_if<protocol::ScriptReply>(&answer.answer);
  if (reply != nullptr && reply->accepted) {
    fire(Event::Accepted, now);
    return;
  }
  std::string found = "the controller refused StopAndClearBuffer()";
  refused_ = reply != nullptr;
  if (const auto* error = std::get_if<protocol::CommunicationError>(&answer.answer)) {
    found = protocol::describe(*error);
    refused_ = error->code == protocol::CommunicationErrorCode::NotListening;
  } else if (reply == nullptr) {
    found = "no reply to StopAndClearBuffer()";
  }
  fail({own_error::kStopNotConfirmed, std::move(found), ""}, now);
}

void StopRun::linkLost(const std::string& reason, Instant now) {
  fail({motion_error::kLinkDropped, reason, ""}, now);
}

void StopRun::robotChanged(Instant now) {
  if (state_ == StopState::Settling && robot_.moving() == false) fire(Event::Standing, now);
}

void StopRun::advance(Instant now) {
  if (!deadline_ || now < *deadline_) return;
  fail({own_error::kStopNotConfirmed,
        robot_.moving() == true
            ? "the robot still moves after the accepted stop"
            : "the stop was accepted, but the status stream did not go on to show the robot standing",
        ""},
       now);
}

std::optional<StopRun::Result> StopRun::takeResult() {
  return std::exchange(result_, std::nullopt);
}

void StopRun::fail(Failure failure, Instant now) {
  failure_ = std::move(failure);
  fire(Event::Failed, now);
}

void StopRun::fire(Event event, Instant now) {
  const auto row = link::findTransition<StopTable>(state_, event);
  if (!row) return;
  state_ = row->to;
  switch (row->action) {
    case StopAction::None:
      return;
    case StopAction::Send:
      deadline_.reset();
      refused_ = false;
      told_ = robot_.tellsMotion();
      // Whatever was queued before is dropped, and its tags mean nothing any more.
      tags_.renewEpoch();
      script_id_ =
          link_.sendScript(protocol::toText(protocol::ScriptCommand(protocol::StopAndClearBuffer{})), now);
      return;
    case StopAction::AwaitStandstill:
      deadline_ = now + settings_.stop_timeout;
      // Where there never was a stream that tells, the accepted stop is all that can be known.
      told_ = told_ || robot_.tellsMotion();
      if (!told_) fire(Event::Standing, now);
      return;
    case StopAction::EndStopped:
      deadline_.reset();
      result_ = Result{std::nullopt, false, told_};
      return;
    case StopAction::EndFailed:
      deadline_.reset();
      result_ = Result{failure_, refused_, false};
      return;
  }
}

}  // namespace cobot_command::blocks
