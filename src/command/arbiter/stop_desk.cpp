#include "arbiter/stop_desk.h"

#include <utility>

#include <fmt/format.h>

namespace cobot_command::command {

void StopDesk::ask(Instant now) {
  run_.ask(window_.moves() ? window_.target() : parts_.forecast.loose().target(), now);
}

void StopDesk::askIfMoving(Instant now) {
  if (parts_.forecast.loose().mayMove() && !busy()) ask(now);
}

std::optional<StopRun::Result> StopDesk::takeResult(Instant now) {
  auto result = run_.takeResult();
  if (!result) return result;
  if (result->failed()) {
    failed(*result, now);
  } else {
    confirmed(*result);
  }
  goals_.ended(*result);
  return result;
}

void StopDesk::confirmed(const StopRun::Result& result) {
  parts_.forecast.stopped();
  orphan_.fire(robot::OrphanEvent::Stopped);
  // Who executes the stop block answers for the robot; a cancel, or a stop of the layer's own, does not.
  if (goals_.asked(result)) parts_.robot.acknowledgeError();
}

/// Who asked may be gone by now: so it is told to everybody, and the next reason to stop sends a stop again.
void StopDesk::failed(const StopRun::Result& result, Instant now) {
  if (result.end != StopEnd::Refused) parts_.forecast.queueMayBeEmptied();
  parts_.forecast.stopFailed(result.failure.found, result.target, now);
  warn(fmt::format("a stop was not confirmed, {}: {}", robot::LooseMotion::kMayStillMove,
                   result.failure.found));
}

bool StopDesk::mayMoveOtherwise() const {
  const robot::RobotWatch& robot = parts_.robot;
  const bool seen_to_stand = robot.moving() == false && !robot.held();  // what is held may have to go on
  return parts_.forecast.loose().mayMove() || orphan_.mayMove() || !seen_to_stand;
}

bool StopDesk::holdsBack() const {
  return orphan_.mayMove() || parts_.forecast.loose().holdsBack();
}

std::string StopDesk::heldBackBy() const {
  return orphan_.mayMove() ? orphan_.text() : parts_.forecast.loose().text();
}

void StopDesk::watchOrphan(Instant now) {
  const link::ScriptLink& script = parts_.script;
  const bool elsewhere = script.established() && script.state() != link::ScriptLinkState::Ready;
  if (!script.connected()) orphan_.fire(robot::OrphanEvent::LinkGone);
  if (elsewhere) orphan_.fire(robot::OrphanEvent::Elsewhere);
  if (parts_.keeper.run().ready()) orphan_.fire(robot::OrphanEvent::Ready);
  orphan_.see(parts_.robot);
  if (!orphan_.takeFound()) return;
  const bool stops = parts_.settings.stop_orphaned_motion;
  warn(fmt::format("{}{}", orphan_.text(), stops ? ": it is stopped" : ""));
  if (stops && !busy()) ask(now);
}

void StopDesk::warn(std::string text) {
  parts_.actions.emplace_back(LogMessage{Severity::Warning, std::move(text)});
}

}  // namespace cobot_command::command
