#include "runs/command_window.h"

#include <algorithm>
#include <iterator>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/common/deadline.h"

namespace cobot_command::command {
namespace {

/// A raw script may, unless it was planned, has no motion, and sets nothing in motion that goes on.
bool mayMoveBy(const CommandOrder& order) {
  const bool known_to_stand = order.plan && order.plan->motions.empty() && order.stands_at_end &&
                              !order.lets_go && !order.is_open_ended;
  return order.moves && !known_to_stand;
}

bool leavesNodeBy(const CommandOrder& order) {
  return order.exits_node || order.exits_afterwards || order.has_exit;
}

/// How the ScriptExit() behind a motion ended, with what is to be told of the motion.
blocks::Outcome withMotion(const blocks::Outcome& exit, const blocks::Outcome& motion) {
  blocks::Outcome outcome = motion;
  outcome.ending = exit.ending;
  outcome.error_id = exit.error_id;
  outcome.remedy = exit.remedy;
  outcome.remarks.add(exit.remarks);
  if (exit.ending != blocks::Ending::Done) {
    outcome.error_description =
        exit.error_description + " (the motion was done, but the Listen node was not left)";
  }
  return outcome;
}

}  // namespace

// --- In.

std::optional<blocks::Failure> CommandWindow::prepare(CommandOrder& order, const blocks::GoalTraits& traits,
                                                      Instant now) {
  order.exits_node = traits.exits_node && !traits.awaits_motion;
  order.exits_afterwards = traits.exits_node && traits.awaits_motion;
  if (auto closed = objectionTo(order, traits, now)) return closed;
  // A tag is opened last, for what will be sent.
  if (traits.awaits_motion && !openTags(order, traits.command_id)) {
    return blocks::Failure{blocks::own_error::kNoFreeTag, "", ""};
  }
  order.command_id_ack = traits.command_id != 0 ? traits.command_id : order.tag.value_or(0);
  addMarks(order);
  addLastLines(order);
  return std::nullopt;
}

bool CommandWindow::openTags(CommandOrder& order, int command_id) {
  for (std::size_t i = 0; i < order.marks.size(); ++i) {
    const auto tag = context_.tags.open();
    if (!tag) break;
    order.mark_tags.push_back(*tag);
  }
  if (order.mark_tags.size() == order.marks.size()) order.tag = context_.tags.open(command_id);
  if (order.tag) return true;
  for (const int tag : std::exchange(order.mark_tags, {})) context_.tags.abandon(tag);
  return false;
}

std::optional<blocks::Failure> CommandWindow::objectionTo(const CommandOrder& order,
                                                          const blocks::GoalTraits& traits,
                                                          Instant now) const {
  if (!gate_ || !(mayMoveBy(order) || leavesNodeBy(order) || traits.asks_permit)) return std::nullopt;
  Departure departure;
  departure.block = order.block;
  departure.lines = order.lines;
  departure.asks_permit = traits.asks_permit;
  departure.planned = (order.plan.has_value() && !order.is_open_ended) || !mayMoveBy(order);
  departure.leaves_node = leavesNodeBy(order);
  if (order.plan) {
    departure.motions = order.plan->motions;
    departure.start = order.start;
    departure.tcp = order.plan->tcp;
    departure.base = order.plan->end.start.base;
  }
  return gate_(departure, now);
}

void CommandWindow::send(CommandOrder order, Instant now) {
  forecast_.sent(order, now);
  ordered_.emplace_back(std::move(order), context_, now);
}

void CommandWindow::sendBeside(const blocks::Command& command, blocks::GoalId goal, Instant now) {
  CommandOrder order;
  static_cast<blocks::Order&>(order) = command.order(arm::Pose::Identity());
  order.block = command.block;
  order.goal = goal;
  order.key = command.key;
  order.command_id_ack = command.traits.command_id;
  order.beside = true;
  beside_.emplace_back(std::move(order), context_, now);
}

void CommandWindow::leaveNode(Ended done, Instant now) {
  CommandOrder exit;
  exit.block = done.block;
  exit.goal = done.goal;
  exit.key = done.key;
  exit.command_id_ack = done.command_id_ack;
  exit.commands.emplace();
  exit.exits_node = true;
  addLastLines(exit);
  ordered_.emplace_back(std::move(exit), context_, now, std::move(done.outcome));
}

// --- What is there.

std::optional<Origin> CommandWindow::end(Instant now) const {
  if (ordered_.empty()) return std::nullopt;
  const CommandRun& last = ordered_.back().run;
  if (!last.order().plan || last.stopping()) return std::nullopt;
  Origin end = last.order().plan->end;
  end.arrival = last.order().plan->arrival + last.waited(now);
  return end;
}

bool CommandWindow::goesOn() const {
  return std::all_of(ordered_.begin(), ordered_.end(),
                     [](const Sent& sent) { return sent.run.accepted() && sent.run.underWay(); });
}

bool CommandWindow::mayMove() const {
  return std::any_of(ordered_.begin(), ordered_.end(),
                     [](const Sent& sent) { return mayMoveBy(sent.run.order()); });
}

bool CommandWindow::moves() const {
  return std::any_of(ordered_.begin(), ordered_.end(),
                     [](const Sent& sent) { return sent.run.order().moves; });
}

std::optional<double> CommandWindow::speedShare() const {
  const auto first =
      std::find_if(ordered_.begin(), ordered_.end(), [](const Sent& sent) { return sent.run.order().moves; });
  return first == ordered_.end() ? std::nullopt : std::optional(first->run.order().speed_share);
}

bool CommandWindow::stopsWithACancel() const {
  return std::any_of(ordered_.begin(), ordered_.end(),
                     [](const Sent& sent) { return sent.run.order().moves && sent.run.mayBeCancelled(); });
}

std::optional<robot::Target> CommandWindow::target() const {
  const auto last = std::find_if(ordered_.rbegin(), ordered_.rend(),
                                 [](const Sent& sent) { return sent.run.order().moves; });
  return last == ordered_.rend() ? std::nullopt : last->run.order().target;
}

// --- Events.

/// The last one first: the stop of them all is on the way to its target.
void CommandWindow::cancel(const std::string& why, Instant now) {
  for (auto sent = ordered_.rbegin(); sent != ordered_.rend(); ++sent) sent->run.cancel(why, now);
}

void CommandWindow::abandon(const std::string& why, Instant now) {
  for (Sent& sent : ordered_) sent.run.abandon(why, now);
}

void CommandWindow::abandonBeside(const std::string& why, Instant now) {
  for (CommandRun& run : beside_) run.abandon(why, now);
}

void CommandWindow::answered(const link::ScriptAnswered& event, Instant now) {
  for (CommandRun& run : beside_) run.answered(event, now);
  for (Sent& sent : ordered_) {
    const bool before = sent.run.accepted();
    sent.run.answered(event, now);
    if (!before && sent.run.accepted()) forecast_.accepted(sent.run.order(), now);
  }
}

bool CommandWindow::tagReported(const link::TagReported& event, Instant now) {
  const auto sent = std::find_if(ordered_.begin(), ordered_.end(), [&](const Sent& s) {
    return s.run.order().tag == event.tag || s.run.order().hasMark(event.tag);
  });
  if (sent == ordered_.end() || !context_.tags.isOpen(event.tag)) return false;
  // Tags complete in the order of the queue: this one is the report of somebody else's.
  const bool is_early = std::any_of(ordered_.begin(), sent, [this](const Sent& s) {
    return s.run.order().tag && context_.tags.isOpen(*s.run.order().tag);
  });
  if (is_early && event.state == protocol::TagState::Complete) return false;
  if (event.state == protocol::TagState::Complete) {
    complete(sent, event.tag, now);
  } else if (sent->run.order().tag != event.tag) {
    return true;  // a mark is nobody's end: what becomes of the command, its own tag tells
  } else if (event.asked) {
    sent->run.tagIncomplete(event.state, now);
  } else if (event.state == protocol::TagState::Incomplete) {
    sent->run.tagFailed(now);
  }
  return true;
}

void CommandWindow::complete(std::list<Sent>::iterator sent, int tag, Instant now) {
  if (!context_.tags.complete(tag)) return;
  CommandRun& run = sent->run;
  if (run.order().tag != tag) {
    passed_.emplace_back(run.order().key, run.passMark(tag));
    return;
  }
  forecast_.arrived(run.order(), now);
  run.tagCompleted(std::next(sent) != ordered_.end(), now);
}

void CommandWindow::tagQueryFailed(const link::TagQueryFailed& event, Instant now) {
  for (Sent& sent : ordered_) {
    if (sent.run.order().tag == event.tag) sent.run.tagQueryFailed(event.reason, now);
  }
}

void CommandWindow::stopEnded(const StopRun::Result& result, Instant now) {
  for (Sent& sent : ordered_) sent.run.stopEnded(result, now);
}

void CommandWindow::linkLost(const std::string& reason, Instant now) {
  for (Sent& sent : ordered_) sent.run.linkLost(reason, now);
}

void CommandWindow::besideLinkLost(const std::string& reason, Instant now) {
  for (CommandRun& run : beside_) run.linkLost(reason, now);
}

void CommandWindow::robotChanged(Instant now) {
  for (Sent& sent : ordered_) {
    sent.run.robotChanged(now);
    const CommandOrder& order = sent.run.order();
    if (!sent.run.underWay() || !order.plan) continue;
    const auto origin = sent.pace.see(order, context_.robot, sent.run.waited(now) - order.plan->start_delay);
    if (!origin) continue;
    const auto take = [this, goal = order.goal, key = order.key](std::optional<PlanAnswer> answer) {
      const bool is_planned = answer && answer->command && answer->command->plan && *answer->command->plan;
      if (!is_planned) return;  // it is made all the same, as it was planned
      for (Sent& then : ordered_) {
        if (then.run.order().goal != goal || then.run.order().key != key) continue;
        then.run.retime(answer->command->origin, **answer->command->plan);
      }
    };
    desk_.ask({order.block, order.goal, PlanDesk::Purpose::Send, forecast_.workFor(order, *origin), take},
              now);
  }
  for (CommandRun& run : beside_) run.robotChanged(now);
}

void CommandWindow::advance(Instant now) {
  for (Sent& sent : ordered_) sent.run.advance(now);
  for (CommandRun& run : beside_) run.advance(now);
}

std::optional<Instant> CommandWindow::nextDeadline() const {
  std::optional<Instant> next;
  for (const Sent& sent : ordered_) next = earlier(next, sent.run.nextDeadline());
  for (const CommandRun& run : beside_) next = earlier(next, run.nextDeadline());
  return next;
}

// --- Out.

std::vector<std::pair<blocks::CommandKey, blocks::Progress>> CommandWindow::takeProgress() {
  std::vector<std::pair<blocks::CommandKey, blocks::Progress>> all;
  for (Sent& sent : ordered_) {
    for (blocks::Progress& progress : sent.run.takeProgress()) {
      all.emplace_back(sent.run.order().key, std::move(progress));
    }
  }
  return all;
}

CommandWindow::Ended CommandWindow::endOf(const CommandRun& run) {
  const CommandOrder& order = run.order();
  Ended ended;
  ended.block = order.block;
  ended.goal = order.goal;
  ended.key = order.key;
  ended.command_id_ack = order.command_id_ack;
  ended.outcome = run.outcome();
  ended.has_tag = order.tag.has_value();
  ended.leaves_node = order.exits_afterwards && run.outcome().ending == blocks::Ending::Done;
  ended.stops_unanswered = order.stops_unanswered;
  return ended;
}

void CommandWindow::takeAlong(std::list<Sent>::iterator failed, Instant now) {
  const auto first = failed->run.asksForStop() ? ordered_.begin() : std::next(failed);
  for (auto sent = ordered_.end(); sent != first;) {
    --sent;
    if (sent != failed) sent->run.cancel("a command sent with it failed", now);
  }
}

std::optional<CommandWindow::Ended> CommandWindow::takeEnded(Instant now) {
  const auto first =
      std::find_if(ordered_.begin(), ordered_.end(), [](const Sent& sent) { return sent.run.ended(); });
  if (first == ordered_.end()) return std::nullopt;
  Ended ended = endOf(first->run);
  if (first->motion_in_front) ended.outcome = withMotion(ended.outcome, *first->motion_in_front);
  if (ended.outcome.ending == blocks::Ending::Aborted) {
    takeAlong(first, now);
    forecast_.forgetPath();
  }
  ordered_.erase(first);
  return ended;
}

std::vector<CommandWindow::Ended> CommandWindow::takeEndedBeside() {
  std::vector<Ended> ended;
  for (const CommandRun& run : beside_) {
    if (run.ended()) ended.push_back(endOf(run));
  }
  beside_.remove_if([](const CommandRun& run) { return run.ended(); });
  return ended;
}

}  // namespace cobot_command::command
