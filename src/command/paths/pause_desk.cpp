#include "paths/pause_desk.h"

#include <algorithm>
#include <utility>

#include "cobot_command/blocks/list/goal.h"

namespace cobot_command::command {
namespace {

constexpr const char* nameOf(PauseDesk::Holder holder) {
  return holder == PauseDesk::Holder::Path ? "a stopped path pauses the robot"
                                           : "the speed override of 0 % pauses the robot";
}

}  // namespace

/// A project that somebody else has paused is left to him: what stands needs no pause, and would be let go
/// with it.
void PauseDesk::hold(Holder holder, const Reply& reply, Instant now) {
  if (isPausedByOthers()) {
    reply({true, 0, heldByOthers()});
    return;
  }
  if (leaving_ && *leaving_ != holder) holders_.erase(*leaving_);
  leaving_.reset();
  const State before = state_;
  holders_.insert(holder);
  if (before == State::Pausing) {
    join(reply);
  } else if (before == State::Paused) {
    tellStanding();
    reply({true, 0, ""});
  } else {
    send(State::Pausing, reply, now);
  }
}

void PauseDesk::letGo(Holder holder, const Reply& reply, Instant now) {
  const bool is_last = std::none_of(holders_.begin(), holders_.end(), [&](Holder h) { return h != holder; });
  if (!is_last) {
    holders_.erase(holder);
    tellStanding();
    reply({true, 0, nameOf(*holders_.begin())});
  } else if (state_ == State::Resuming) {
    join(reply);
  } else if (state_ == State::None || others_pause_) {
    changeTo(State::None);
    reply({true, 0, heldByOthers()});
  } else {
    leaving_ = holder;
    send(State::Resuming, reply, now);
  }
}

void PauseDesk::send(State state, const Reply& reply, Instant now) {
  if (const auto failures = core_.objections(); !failures.empty()) {
    if (state_ == State::None) holders_.clear();
    leaving_.reset();
    reply({false, failures.front().error_id, "there is no connection to the robot"});
    return;
  }
  changeTo(state);
  last_ = sendLine(state == State::Pausing, now);
  join(reply);
}

blocks::CommandKey PauseDesk::sendLine(bool pauses, Instant now) {
  blocks::Order order =
      blocks::settingOrder(pauses ? script::ScriptCommand(script::Pause{}) : script::Resume{});
  order.stops_unanswered = pauses;
  blocks::Command sent;
  sent.key = ++sent_;
  sent.block = blocks::kBlock<blocks::ProgramControlGoal>;
  sent.order = [order](const arm::Pose& /*base*/) { return order; };
  core_.window.sendBeside(sent, 0, now);
  return sent.key;
}

void PauseDesk::pauseForGood(Instant now) {
  if (others_pause_ || !core_.objections().empty()) return;
  if (state_ == State::Paused) {
    others_pause_ = true;  // the pause that there is stays, whoever lets go of it
    others_seen_ = seen_;
  } else {
    for_good_ = sendLine(true, now);
  }
}

/// As the controller has taken it: until then nobody knows.
void PauseDesk::goalEnded(bool pauses) {
  others_pause_ = pauses;
  others_seen_ = false;
  if (pauses) return;
  if (stands()) letGoByOthers();
  core_.resumed();
}

void PauseDesk::endedForGood(const CommandWindow::Ended& ended) {
  for_good_.reset();
  if (ended.outcome.ending == blocks::Ending::Done) {
    goalEnded(true);
  } else {
    core_.actions.emplace_back(LogMessage{
        Severity::Warning, "the controller has not accepted a pause: " + ended.outcome.error_description});
  }
}

void PauseDesk::ended(const CommandWindow::Ended& ended) {
  const bool is_done = ended.outcome.ending == blocks::Ending::Done;
  if (ended.goal != 0) {
    const auto found = of_goals_.find(ended.goal);
    if (found == of_goals_.end()) return;
    const bool pauses = found->second;
    of_goals_.erase(found);
    if (is_done) goalEnded(pauses);
    return;
  }
  if (for_good_ == ended.key) {
    endedForGood(ended);
    return;
  }
  if (ended.key == last_ && state_ == State::Pausing) {
    changeTo(is_done ? State::Paused : State::None);
  } else if (ended.key == last_ && state_ == State::Resuming) {
    changeTo(is_done ? State::None : State::Paused);
  }
  const auto mine = std::stable_partition(waiting_.begin(), waiting_.end(),
                                          [&](const Waiting& waiting) { return waiting.key != ended.key; });
  const std::vector<Waiting> answered(mine, waiting_.end());
  waiting_.erase(mine, waiting_.end());
  Answer answer{is_done, 0, ""};
  if (!is_done) {
    answer = {false, ended.outcome.error_id,
              "the controller has not accepted it: " + ended.outcome.error_description};
  }
  for (const Waiting& waiting : answered) waiting.reply(answer);
}

void PauseDesk::changeTo(State state) {
  if (state == State::Pausing) seen_ = false;
  if (state != State::Resuming) leaving_.reset();
  if (state == State::None) holders_.clear();
  state_ = state;
  core_.robot.pausedByUs(stands());
  tellStanding();
}

void PauseDesk::tellStanding() {
  core_.paths.hold(stands() && isHeldBy(Holder::Path));
}

bool PauseDesk::isPausedByOthers() const {
  const bool is_seen = core_.robot.tellsPause() && core_.robot.paused();
  return state_ == State::None && (others_pause_ || is_seen);
}

std::string PauseDesk::heldByOthers() const {
  if (!core_.robot.held() && !others_pause_) return "";
  if (!core_.robot.paused() && !others_pause_) {
    return "a safeguard stops the robot: it continues when the safeguard is released";
  }
  return "the project is paused: program_control with RESUME, or the pendant, continues it";
}

/// An emergency stop, and a project that is stopped, end a pause, too; what was to be held stays so.
void PauseDesk::robotChanged() {
  if (!core_.robot.tellsPause()) return;
  if (core_.robot.emergencyStop() || core_.robot.projectStopped()) {
    if (state_ != State::None || others_pause_) forget();
  } else if (core_.robot.paused()) {
    seen_ = state_ != State::None;
    others_seen_ = others_pause_;
  } else {
    if (others_seen_) others_pause_ = others_seen_ = false;
    if (seen_ && stands()) letGoByOthers();
  }
}

void PauseDesk::letGoByOthers() {
  const bool was_path = isHeldBy(Holder::Path);
  if (state_ == State::Paused) {
    core_.actions.emplace_back(LogMessage{
        Severity::Warning, was_path ? "the project continues although the path was stopped: another client "
                                      "or the pendant has resumed it"
                                    : "the project continues although the speed override is 0 %: another "
                                      "client or the pendant has resumed it; nothing more is sent"});
  }
  changeTo(State::None);
  if (was_path) core_.paths.stop(false);
}

void PauseDesk::forget() {
  changeTo(State::None);
  others_pause_ = others_seen_ = false;
  of_goals_.clear();
  for_good_.reset();
  last_ = ++sent_;  // no answer that is still to come counts
}

}  // namespace cobot_command::command
