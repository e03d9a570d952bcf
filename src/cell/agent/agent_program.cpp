// How an agent leads a program.
#include <algorithm>

#include "agent/agent_parts.h"
#include "agent/frame_gate.h"
#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::cell {

using blocks::Failure;
using Reason = blocks::ProgramStand::Reason;
namespace own_error = blocks::own_error;
namespace {

/// A path that is granted at once is found soon, and one that is not does not fill the journal.
constexpr Duration kTryAnotherAfter = std::chrono::milliseconds(500);

}  // namespace

std::optional<Failure> Agent::Parts::begin(const blocks::ProgramRequest& request, Instant now) {
  failure_.reset();
  itinerary_ = Itinerary(program());
  waits_ = {};
  if (const auto silent = states_.silence(now)) return Failure{own_error::kSupervisorSilent, *silent, ""};
  const RobotStatus* const mine = states_.mine();
  if (mine != nullptr && mine->session != 0 && mine->session != session_) {
    return Failure{own_error::kRecoveryNeeded,
                   "the supervisor has another session of this robot: " + mine->text, ""};
  }
  if (mine != nullptr && mine->state == RobotState::Out) {
    return Failure{own_error::kRecoveryNeeded, "it was taken out of the cell", ""};
  }
  if (readiness_.isHalted()) {
    const std::string why = readiness_.text();
    return Failure{own_error::kRecoveryNeeded,
                   fmt::format("it is {} at {}{}{}", toString(readiness_.condition(watch_)),
                               walk_.place().name, why.empty() ? "" : ": ", why),
                   ""};
  }
  const CellPlace& place = walk_.place();
  const auto under_way = place.station ? std::nullopt : std::optional(place.path);
  if (auto elsewhere = itinerary_.begin(request, place.station.value_or(0), under_way)) {
    return Failure{own_error::kProgramUnknown, *elsewhere, ""};
  }
  if (states_.isFinishing()) {
    return Failure{own_error::kNotPermitted, "the cell is finishing: no robot starts another cycle", ""};
  }
  is_running_ = true;
  is_busy_ = false;
  waits_since_ = now;
  waits_.beginCycle();
  settle(now);
  return std::nullopt;
}

void Agent::Parts::settle(Instant now) {
  goOn();
  findPermit(now);
  countWaiting(now);
}

void Agent::Parts::goOn() {
  if (!isJoined() || readiness_.isHalted() || walk_.waits() || !watch_.joints()) return;
  bool goes_on = true;
  while (goes_on && !walk_.waits()) {
    goes_on = walk_.place().station ? goOnAtStation() : goOnPath();
    has_news_ = has_news_ || goes_on;
  }
}

bool Agent::Parts::goOnAtStation() {
  if (!is_running_ || is_busy_ || failure_ || itinerary_.isOver()) return false;
  walk_.want(walk_.goOf(itinerary_.next(*walk_.place().station)));
  return true;
}

bool Agent::Parts::goOnPath() {
  if (!where_.tracker()) {
    where_.setOut(walk_.place().path);
    itinerary_.setOut();
  }
  const automata::EventIndex event = walk_.next();
  const CellEvent& meaning = walk_.meaning(event);
  if (meaning.kind == CellEvent::Kind::Reached) {
    const bool stands = !is_busy_ && !watch_.moving().value_or(true);
    if (!stands || !where_.isAtEndOfPath(*watch_.joints())) return false;
    walk_.happened(event);
    where_.leavePath();
    const int cycles = itinerary_.cyclesDone();
    itinerary_.reached(*walk_.place().station);
    if (itinerary_.cyclesDone() > cycles && !itinerary_.isOver()) waits_.beginCycle();
    return true;
  }
  const ZonePlace& place = where_.tracker()->path().places[walk_.place().behind];
  if (meaning.kind == CellEvent::Kind::Book) {
    if (!is_running_ || failure_ || !mayAskFor(place.frame)) return false;
    walk_.want(event);
    return true;
  }
  if (!where_.isReleased(meaning.zones.front(), place.piece)) return false;
  walk_.happened(event);
  return true;
}

/// When the frame could follow at once, and the corner before it is near; the robot stands already, where it
/// does not go over into it.
bool Agent::Parts::mayAskFor(std::size_t frame) const {
  if (is_busy_ || where_.tracker()->nextFrame() < frame) return false;
  return frame == 0 || where_.tracker()->remaining() <= artifact_->parameters.lookahead;
}

/// Where several paths lead on, whichever is granted first is taken.
void Agent::Parts::tryAnotherPath(Instant now) {
  const auto& station = walk_.place().station;
  const bool may_help = tried_another_at_ == std::nullopt || now >= *tried_another_at_ + kTryAnotherAfter;
  if (!may_help || !walk_.waits() || !station || !is_running_ || !itinerary_.hasOthers(*station)) return;
  tried_another_at_ = now;
  walk_.withdraw();
  itinerary_.tryAnother();
  has_news_ = true;
}

void Agent::Parts::undoUnused() {
  if (!walk_.unused() || walk_.meaning(*walk_.unused()).kind != CellEvent::Kind::Book) return;
  walk_.withdraw();
  permit_.reset();
  has_news_ = true;
}

void Agent::Parts::findPermit(Instant now) {
  permit_.reset();
  withheld_.clear();
  const bool may_go_on = is_running_ && !is_busy_ && !failure_ && !readiness_.isHalted() && isJoined();
  if (!may_go_on || walk_.place().station || !where_.tracker() || where_.tracker()->allSent()) return;
  const std::size_t frame = where_.tracker()->nextFrame();
  const auto& steps = program().paths[walk_.place().path].steps;
  for (std::size_t step = walk_.place().behind; step < steps.size(); ++step) {
    if (steps[step].books && where_.tracker()->path().places[step].frame <= frame) return;
  }
  const ArtifactFrame& made = where_.tracker()->path().frames[frame];
  // A supervisor that is silent, or holds the cell, may soon be heard again, or go on: the frame waits for
  // it.
  if (const auto silent = states_.objection(now)) withheld_ = *silent;
  if (const auto why = objectionOf(states_, isJoined())) withheld_ = *why;
  if (!withheld_.empty()) return;
  permit_ = Permit{frame, {made.lines, made.stands, made.output, made.input, made.dwell}};
}

void Agent::Parts::countWaiting(Instant now) {
  // Motion that nothing is asked for behind yet, and a pause, are no waiting. Who stands where it cannot go
  // on, as it is not measured behind a zone or at its station, waits for ever.
  const bool is_stuck = where_.tracker() && !permit_ && watch_.moving() == false;
  const bool is_kept = walk_.waits() || !withheld_.empty() || !isJoined() || is_stuck;
  const bool waits =
      is_running_ && !is_busy_ && !failure_ && !itinerary_.isOver() && is_kept && !watch_.held();
  if (waits && !waits_since_) waits_since_ = now;
  if (!waits && waits_since_) {
    waits_.add(now - *waits_since_);
    waits_since_.reset();
  }
  if (!waits_since_ || now - *waits_since_ < artifact_->parameters.wait_timeout) return;
  const auto silent = states_.objection(now);
  failure_ = silent ? Failure{own_error::kSupervisorSilent, *silent, ""}
                    : Failure{own_error::kPermitLate, stand(now).text, ""};
}

void Agent::Parts::sent(Instant now) {
  if (!permit_) return;
  walk_.use();
  where_.sent();
  is_busy_ = true;
  permit_.reset();
  settle(now);
}

void Agent::Parts::done(Instant now) {
  is_busy_ = false;
  where_.done();
  settle(now);
}

void Agent::Parts::finish() {
  itinerary_.finish();
}

std::vector<Duration> Agent::Parts::end(Instant now) {
  if (!is_running_) return {};
  const bool is_at_end =
      !where_.tracker() || (watch_.joints() && where_.tracker()->isAtEnd(*watch_.joints()));
  const bool is_left_over = where_.tracker() && (is_busy_ || !is_at_end);
  is_running_ = false;
  is_busy_ = false;
  permit_.reset();
  if (waits_since_) waits_.add(now - *waits_since_);
  waits_since_.reset();
  walk_.withdraw();
  if (walk_.place().station) where_.leavePath();
  if (is_left_over && !readiness_.isHalted()) readiness_.halt(Halt::Stopped);
  has_news_ = true;
  return waits_.take();
}

blocks::ProgramStand Agent::Parts::stand(Instant now) const {
  blocks::ProgramStand stand;
  const CellPlace& place = walk_.place();
  stand.place = place.name;
  if (!place.station) stand.path = program().paths[place.path].name;
  if (where_.tracker()) {
    const std::size_t frame = is_busy_ && where_.tracker()->nextFrame() > 0
                                  ? where_.tracker()->nextFrame() - 1
                                  : where_.tracker()->nextFrame();
    const auto& frames = where_.tracker()->path().frames;
    stand.step = static_cast<int>(frames[std::min(frame, frames.size() - 1)].step);
  }
  stand.cycles_done = itinerary_.cyclesDone();
  stand.cycle = stand.cycles_done + 1;
  stand.is_permitted = permit_.has_value();
  if (waits_since_) stand.waiting = now - *waits_since_;
  const RobotStatus* const mine = states_.mine();
  if (const auto silent = states_.objection(now)) {
    stand.text = *silent;
  } else if (!isJoined()) {
    stand.text =
        fmt::format("waiting until the supervisor admits {}{}{}", program().name,
                    mine != nullptr && !mine->text.empty() ? ": " : "", mine != nullptr ? mine->text : "");
  } else if (walk_.waits() && mine != nullptr) {
    tellWait(*mine, stand);
  } else if (!withheld_.empty()) {
    stand.text = fmt::format("waits at {}: {}", place.name, withheld_);
  } else if (waits_since_ && where_.tracker()) {
    stand.text = fmt::format("at standstill at {}, but the measured joints do not allow it to continue there",
                             place.name);
  }
  return stand;
}

void Agent::Parts::tellWait(const RobotStatus& mine, blocks::ProgramStand& stand) const {
  stand.reason = static_cast<Reason>(mine.reason);
  stand.blocked_by = mine.blocked_by;
  stand.place_in_queue = static_cast<int>(mine.place_in_queue);
  stand.text = fmt::format("waits at {}{}{}{}{}", walk_.place().name,
                           mine.reason == WaitReason::None ? "" : ": ", toString(mine.reason),
                           mine.blocked_by.empty() ? "" : " by ", fmt::join(mine.blocked_by, ", "));
}

std::optional<Instant> Agent::Parts::nextDeadline() const {
  if (!waits_since_ || failure_) return std::nullopt;
  return *waits_since_ + artifact_->parameters.wait_timeout;
}

}  // namespace cobot_command::cell
