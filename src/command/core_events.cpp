// Events: handed to the links, and what the links make of them handed to the runs.

#include "core_impl.h"
#include <fmt/format.h>

#include "cobot_command/common/deadline.h"

namespace cobot_command::command {
namespace {

/// A raw script may, unless it was planned and has no motion.
bool mayMove(const CommandOrder& order) {
  return order.moves && !(order.plan && order.plan->motions.empty());
}

}  // namespace

CommandCore::Impl::Impl(std::optional<arm::ArmModel> arm, const link::LinkSettings& settings,
                        blocks::FrameFinder frame_finder, NewestGoal newest, Planning planning)
    : settings_(settings),
      frame_finder_(std::move(frame_finder)),
      newest_(std::move(newest)),
      links_(settings_, actions_),
      tags_(settings_.first_tag),
      forecast_(arm ? std::make_shared<const arm::ArmModel>(*std::move(arm)) : nullptr, robot_, actions_),
      planning_(planning),
      plans_(settings_.planning_budget, actions_),
      board_(actions_),
      connect_(settings_, script_, status_, robot_, board_),
      stop_(settings_, script_, tags_, robot_, forecast_.arm()) {}

void CommandCore::Impl::opened(link::ConnectionId id, Instant now) {
  links_.opened(id, now);
  settle(now);
}

void CommandCore::Impl::openFailed(link::ConnectionId id, const link::OpenFailure& failure, Instant now) {
  links_.openFailed(id, failure, now);
  settle(now);
}

void CommandCore::Impl::received(link::ConnectionId id, std::string_view bytes, Instant now) {
  links_.received(id, bytes);
  settle(now);
}

void CommandCore::Impl::closed(link::ConnectionId id, const std::string& reason, Instant now) {
  links_.closed(id, reason, now);
  settle(now);
}

void CommandCore::Impl::advance(Instant now) {
  links_.advance(now);
  settle(now);
  if (on_wire_) on_wire_->advance(now);
  for (CommandRun& run : direct_) run.advance(now);
  if (run_) run_->advance(now);
  stop_.advance(now);
  connect_.advance(now);
  endOverduePlans(now);
  settle(now);
}

std::optional<Instant> CommandCore::Impl::nextDeadline() const {
  std::optional<Instant> next = earlier(links_.nextDeadline(), connect_.nextDeadline());
  next = earlier(next, earlier(stop_.nextDeadline(), plans_.nextDeadline()));
  if (on_wire_) next = earlier(next, on_wire_->nextDeadline());
  if (run_) next = earlier(next, run_->nextDeadline());
  for (const CommandRun& run : direct_) next = earlier(next, run.nextDeadline());
  return next;
}

std::vector<Action> CommandCore::Impl::takeActions() {
  std::vector<Action> actions;
  actions.swap(actions_);
  return actions;
}

/// Handles everything that follows from an event, until nothing more does.
void CommandCore::Impl::settle(Instant now) {
  for (bool more = true; more;) {
    more = false;
    while (const auto output = script_.next(now)) {
      std::visit([&](const auto& event) { handle(event, now); }, *output);
      finish(now);
    }
    while (const auto status = status_.next(now)) handle(*status, now);
    if (robot_.status() && !status_.streaming()) {
      robot_.forget();
      robotChanged(now);
      finish(now);
      connect_.statusChanged(now);
    }
    tellOfClosedConnection(now);
    watchOrphan(now);
    watchStrangers(now);
    finish(now);
    dispatch(now);
    if (connect_.disconnecting() && !run_ && !stop_.busy() && direct_.empty()) {
      connect_.motionsEnded(now);
      more = true;
    }
    if (kept_ && !kept_no_more_ && !connect_.busy() && life_ == Life::Working) {
      connect_.keep(*kept_, now);
      more = true;
    }
  }
  if (!on_wire_ && !forecast_.loose().mayMove() && !stop_.busy()) forecast_.queueDone();
  plans_.proceed(now);
  tellPlaces();
  publishFrames();
  publishStatus();
}

/// Whatever ended it: that of a connection which never was more than that, for a stop or a pause to be tried
/// on, is no LinkLost. Nor is one that was closed on purpose.
void CommandCore::Impl::tellOfClosedConnection(Instant now) {
  if (script_.connected()) return;
  if (stop_.busy()) stop_.linkLost(script_.diagnosis());
  for (CommandRun& run : direct_) run.linkLost(script_.diagnosis(), now);
  finish(now);
  forecast_.disconnected();
}

/// A motion of before this connection: whoever commands now has to know of it, and must not queue behind it.
void CommandCore::Impl::watchOrphan(Instant now) {
  const bool elsewhere = script_.established() && script_.state() != link::ScriptLinkState::Ready;
  if (!script_.connected()) orphan_.fire(robot::OrphanEvent::LinkGone);
  if (elsewhere) orphan_.fire(robot::OrphanEvent::Elsewhere);
  if (connect_.ready()) orphan_.fire(robot::OrphanEvent::Ready);
  if (connect_.ready() && left_moving_ && connect_.isSameController(*left_moving_)) left_moving_.reset();
  orphan_.see(robot_);
  if (!orphan_.takeFound()) return;
  log(Severity::Warning,
      fmt::format("{}{}", orphan_.text(), settings_.stop_orphaned_motion ? ": it is stopped" : ""));
  if (settings_.stop_orphaned_motion && !stop_.busy()) askForStop(now);
}

void CommandCore::Impl::watchStrangers(Instant now) {
  if (!script_.connected()) strangers_.forget();
  const bool ours =
      !connect_.ready() || on_wire_ || forecast_.loose().mayMove() || stop_.busy() || orphan_.mayMove();
  strangers_.see(robot_, ours, now);
}

void CommandCore::Impl::finish(Instant now) {
  finishStops(now);
  finishCommand(now);
  finishRun(now);
}

void CommandCore::Impl::handle(const link::LinkChanged& /*event*/, Instant now) {
  connect_.linkChanged(now);
}

void CommandCore::Impl::handle(const link::LinkLost& event, Instant now) {
  log(Severity::Warning, "link lost: " + event.reason);
  const bool moved = forecast_.loose().mayMove() || (on_wire_ && mayMove(on_wire_->order()));
  if (moved) left_moving_ = connect_.target();
  dropWaiting("the link was lost: " + event.reason);
  if (on_wire_) on_wire_->linkLost(event.reason, now);
  for (CommandRun& run : direct_) run.linkLost(event.reason, now);
  const auto patience = robot_.status() ? std::optional(settings_.evidence_timeout) : std::nullopt;
  if (run_) run_->linkLost(event.reason, patience, now);
  stop_.linkLost(event.reason);
  tags_.renewEpoch();
  finish(now);
  connect_.linkLost(
      moved ? fmt::format("{}; {}", event.reason, robot::LooseMotion::kMayStillMove) : event.reason, now);
}

void CommandCore::Impl::handle(const link::ScriptAnswered& event, Instant now) {
  stop_.answered(event, now);
  for (CommandRun& run : direct_) run.answered(event, now);
  if (!on_wire_) return;
  const bool before = on_wire_->accepted();
  on_wire_->answered(event, now);
  if (!before && on_wire_->accepted()) forecast_.accepted(on_wire_->order(), now);
}

void CommandCore::Impl::handle(const link::TagReported& event, Instant now) {
  const bool awaited = on_wire_ && on_wire_->order().tag == event.tag && tags_.isOpen(event.tag);
  if (!awaited) {
    if (event.asked) return;  // asked before the command ended
    if (tags_.isForeign(event.tag)) strangers_.tagReported(event.tag);
    const bool stale = !tags_.complete(event.tag);
    if (stale) log(Severity::Warning, fmt::format("report of tag {}, for which nothing waits", event.tag));
    return;
  }
  if (event.state == protocol::TagState::Complete) {
    const bool open = tags_.complete(event.tag);
    if (!open) return;
    forecast_.arrived(on_wire_->order(), now);
    on_wire_->tagCompleted(now);
  } else if (event.asked) {
    on_wire_->tagIncomplete(event.state, now);
  } else if (event.state == protocol::TagState::Incomplete) {
    on_wire_->tagFailed(now);
  }
}

void CommandCore::Impl::handle(const link::TagQueryFailed& event, Instant now) {
  if (on_wire_ && on_wire_->order().tag == event.tag) on_wire_->tagQueryFailed(event.reason, now);
}

void CommandCore::Impl::handle(const link::RobotStatus& status, Instant now) {
  robot_.update(status);
  actions_.emplace_back(RobotStatusReceived{status});
  robotChanged(now);
  finish(now);  // a lost link ends its motion first
  connect_.statusChanged(now);
}

void CommandCore::Impl::robotChanged(Instant now) {
  forecast_.robotChanged(settings_.evidence_timeout, now);
  if (on_wire_) on_wire_->robotChanged(now);
  for (CommandRun& run : direct_) run.robotChanged(now);
  if (run_) run_->robotChanged(robot_, now);
  stop_.robotChanged();
}

}  // namespace cobot_command::command
