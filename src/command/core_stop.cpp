// The stop in the arbiter: what is asked to stop, and what its end means for everything else.

#include <algorithm>
#include <utility>

#include "core_impl.h"
#include <fmt/format.h>

namespace cobot_command::command {

void CommandCore::Impl::askForStop(Instant now) {
  stop_.ask(on_wire_ && on_wire_->order().moves ? on_wire_->order().target : forecast_.loose().target(), now);
}

void CommandCore::Impl::stopAll(const std::string& why, blocks::GoalId newest, Instant now) {
  const bool stops_by_itself = on_wire_ && on_wire_->order().moves && on_wire_->mayBeCancelled();
  if (!stops_by_itself) askForStop(now);
  abortAll(why, newest, now);
}

void CommandCore::Impl::stopIfMoving(Instant now) {
  if (forecast_.loose().mayMove() && !stop_.busy()) askForStop(now);
}

bool CommandCore::Impl::mayMoveOtherwise() const {
  const bool seen_to_stand = robot_.moving() == false && !robot_.held();  // what is held may have to go on
  return forecast_.loose().mayMove() || orphan_.mayMove() || !seen_to_stand;
}

std::string CommandCore::Impl::heldBackBy() const {
  return orphan_.mayMove() ? orphan_.text() : forecast_.loose().text();
}

void CommandCore::Impl::finishStops(Instant now) {
  while (const auto result = stop_.takeResult()) {
    if (result->failed()) {
      stopFailed(*result, now);
    } else {
      stopConfirmed(*result);
    }
    if (on_wire_) on_wire_->stopEnded(*result, now);
    endStopGoals(*result);
    if (result->failed()) dropUnstopped(result->failure.found);
  }
}

void CommandCore::Impl::endStopGoals(const StopRun::Result& result) {
  const auto wish = wishFor(result);
  if (wish == stop_goals_.end()) return;
  blocks::Outcome outcome;
  if (result.failed()) {
    outcome = blocks::toOutcome(kStop, blocks::Ending::Aborted, result.failure);
  } else if (result.end != StopEnd::Stopped) {
    outcome.error_description = result.words();
  }
  board_.end(kStop, wish->id, std::move(outcome));
  stop_goals_.erase(wish);
}

std::vector<CommandCore::Impl::StopWish>::const_iterator CommandCore::Impl::wishFor(
    const StopRun::Result& result) const {
  return std::find_if(stop_goals_.begin(), stop_goals_.end(),
                      [&](const StopWish& wish) { return wish.stop == result.number; });
}

void CommandCore::Impl::stopConfirmed(const StopRun::Result& result) {
  forecast_.stopped();
  orphan_.fire(robot::OrphanEvent::Stopped);
  // Who executes the stop block answers for the robot; a cancel, or a stop of the layer's own, does not.
  if (wishFor(result) != stop_goals_.end()) robot_.acknowledgeError();
}

/// Who asked may be gone by now: so it is told to everybody, and the next reason to stop sends a stop again.
void CommandCore::Impl::stopFailed(const StopRun::Result& result, Instant now) {
  if (result.end != StopEnd::Refused) forecast_.queueMayBeEmptied();
  forecast_.stopFailed(result.failure.found, result.target, now);
  log(Severity::Warning, fmt::format("a stop was not confirmed, {}: {}", robot::LooseMotion::kMayStillMove,
                                     result.failure.found));
}

}  // namespace cobot_command::command
