// Events: handed to the links, and what the links make of them handed to the arbiter.

#include <utility>

#include "core_impl.h"
#include <fmt/format.h>

#include "cobot_command/blocks/list/goal_rules.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/common/deadline.h"
#include "cobot_command/common/overloaded.h"

namespace cobot_command::command {
namespace {

constexpr const char* kShuttingDown = "the command layer is shutting down";

}  // namespace

CommandCore::Impl::Impl(std::optional<arm::ArmModel> arm, const link::LinkSettings& settings, CorePorts ports,
                        Planning planning)
    : settings_(settings),
      links_(settings_, actions_, std::move(ports.traced)),
      tags_(settings_.first_tag),
      messages_(arm ? arm->name() : std::string(), robot_, actions_),
      tables_(arm ? tables::payloadOf(*arm) : tables::Payload(), actions_),
      paths_(speed_, actions_),
      board_(actions_),
      keeper_(settings_, links_, robot_, board_),
      forecast_(arm ? std::make_shared<const arm::ArmModel>(*std::move(arm)) : nullptr, robot_,
                tables_.store(), speed_, actions_),
      limits_(forecast_, robot_, actions_),
      sync_({links_.script(), settings_, tables_, messages_, limits_, actions_}),
      exchange_({settings_, links_, robot_, keeper_, board_, messages_, hold_, sync_, guard_}),
      permit_(exchange_, sync_, guard_),
      arbiter_({settings_, links_.script(), tags_, robot_, tables_.store(), speed_, paths_, jog_, keeper_,
                exchange_, sync_, guard_, permit_, hold_, forecast_, board_, actions_},
               std::move(ports), planning),
      status_({links_, tags_, robot_, strangers_, board_, keeper_, forecast_, arbiter_}, actions_),
      group_({robot_, keeper_, exchange_, sync_, guard_, arbiter_, messages_}, actions_) {}

// --- Goals.

void CommandCore::Impl::submit(blocks::GoalId id, const blocks::Goal& goal, Instant now) {
  const blocks::Block block = blocks::blockOf(goal);
  if (life_ == Life::Retiring && !blocks::GoalRules(goal).traits().halts) {
    board_.abortAsItComes(block, id, kShuttingDown);
  } else if (life_ == Life::Over) {
    board_.reject(block, id, blocks::toRejection(block, {{blocks::own_error::kShutDown, "", ""}}));
  } else {
    const auto filled = defaults_.filled(goal);
    arbiter_.take(id, filled ? *filled : goal, now);
  }
  settle(now);
}

void CommandCore::Impl::cancel(blocks::GoalId id, Instant now, std::optional<blocks::GoalId> newest) {
  arbiter_.cancel(id, now, newest);
  settle(now);
}

FinishReport CommandCore::Impl::finish(blocks::FinishAfter after, Instant now,
                                       std::optional<blocks::GoalId> newest) {
  FinishReport found = arbiter_.finish(after, now, newest);
  settle(now);
  return found;
}

void CommandCore::Impl::keepConnected(const blocks::ConnectGoal& target, Instant now) {
  keeper_.keep(target);
  settle(now);
}

void CommandCore::Impl::retire(Instant now) {
  if (life_ != Life::Working) return;
  life_ = Life::Retiring;
  sync_.end();
  guard_.end();
  keeper_.keepNoMore();
  arbiter_.retire(kShuttingDown, now);
  settle(now);
}

bool CommandCore::Impl::retired() const {
  return life_ != Life::Working && arbiter_.idle();
}

void CommandCore::Impl::shutDown(Instant now) {
  const std::string why = arbiter_.stops().busy() ? fmt::format(
                                                        "{}; the robot was sent a stop command, and did not "
                                                        "confirm it in the available time: it may still move",
                                                        kShuttingDown)
                                                  : kShuttingDown;
  life_ = Life::Over;
  keeper_.keepNoMore();
  arbiter_.shutDown(why, now);
  exchange_.shutDown(why, now);
  keeper_.run().abandon(why, now);
  settle(now);
}

void CommandCore::Impl::planned(PlanJobId id, PlanAnswer answer, Instant now) {
  arbiter_.planned(id, std::move(answer));
  settle(now);
}

// --- Connections and time.

void CommandCore::Impl::useSettings(const link::LinkSettings& settings, Instant now) {
  exchange_.useSettings(settings, now);
  settle(now);
}

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
  arbiter_.advance(now);
  exchange_.advance(now);
  sync_.advance(now);
  keeper_.run().advance(now);
  settle(now);
}

std::optional<Instant> CommandCore::Impl::nextDeadline() const {
  const auto of_exchange = earlier(exchange_.nextDeadline(), sync_.nextDeadline());
  const auto of_goals = earlier(of_exchange, arbiter_.nextDeadline());
  return earlier(links_.nextDeadline(), earlier(keeper_.run().nextDeadline(), of_goals));
}

std::vector<Action> CommandCore::Impl::takeActions() {
  messages_.actionsTaken();
  return std::exchange(actions_, {});
}

// --- What follows.

void CommandCore::Impl::settle(Instant now) {
  do {
    takeEvents(now);
    tellOfClosedConnection(now);
    keeper_.lookForTheRobotLeft();
    arbiter_.watchOrphan(now);
    watchStrangers(now);
    sync_.look(now);
    exchange_.look(now);
    arbiter_.settle(now);
    if (life_ == Life::Working) arbiter_.dispatch(now);
  } while (changeConnection(now));
  arbiter_.proceed(now);
  status_.tell();
  exchange_.seeQueue(status_.queueDepth());
  messages_.look(now);
  group_.tell();
}

void CommandCore::Impl::takeEvents(Instant now) {
  while (const auto output = links_.script().next(now)) {
    std::visit(Overloaded{[this](const protocol::ListenData& data) { static_cast<void>(sync_.take(data)); },
                          [&](const auto& event) { handle(event, now); }},
               *output);
    arbiter_.settle(now);
  }
  while (const auto status = links_.status().next(now)) handle(*status, now);
  if (robot_.status() && !links_.status().streaming()) {
    robot_.forget();
    robotChanged(now);
  }
}

/// Whatever ended it: that of a connection which never was more than that, for a stop or a pause to be tried
/// on, is no LinkLost. Nor is one that was closed on purpose.
void CommandCore::Impl::tellOfClosedConnection(Instant now) {
  if (links_.script().connected()) return;
  arbiter_.disconnected(links_.script().diagnosis(), now);
  forecast_.disconnected();
  if (!robot_.status()) limits_.forget();
}

bool CommandCore::Impl::changeConnection(Instant now) {
  const bool closes = keeper_.run().disconnecting() && arbiter_.idle();
  if (closes) keeper_.run().motionsEnded(now);
  const bool opens = life_ == Life::Working && keeper_.keepOn(now);
  return closes || opens;
}

void CommandCore::Impl::watchStrangers(Instant now) {
  if (!links_.script().connected()) strangers_.forget();
  strangers_.see(robot_, !keeper_.run().ready() || arbiter_.mayBeMovedByUs(), now);
}

void CommandCore::Impl::handle(const link::LinkChanged& /*event*/, Instant now) {
  keeper_.run().linkChanged(now);
}

void CommandCore::Impl::handle(const link::LinkLost& event, Instant now) {
  actions_.emplace_back(
      LogMessage{Severity::Error, "link lost: " + event.reason, blocks::exchange_error::kConnectionLost,
                 "see command_status; if the robot still moves, stop it, then connect again"});
  const bool moved = arbiter_.mayMove();
  if (moved) keeper_.leftMoving();
  exchange_.linkLost(event.reason, now);
  arbiter_.linkLost(event.reason, now);
  tags_.renewEpoch();
  arbiter_.settle(now);
  keeper_.run().linkLost(
      moved ? fmt::format("{}; {}", event.reason, robot::LooseMotion::kMayStillMove) : event.reason, now);
}

void CommandCore::Impl::handle(const link::ScriptAnswered& event, Instant now) {
  if (!sync_.take(event)) arbiter_.answered(event, now);
}

void CommandCore::Impl::handle(const link::TagReported& event, Instant now) {
  if (arbiter_.tagReported(event, now)) return;
  if (event.asked) return;  // asked before the command ended
  if (tags_.isForeign(event.tag)) strangers_.tagReported(event.tag);
  const bool stale = !tags_.complete(event.tag);
  if (stale) warn(fmt::format("report of tag {}, for which no command waits", event.tag));
}

void CommandCore::Impl::handle(const link::TagQueryFailed& event, Instant now) {
  arbiter_.tagQueryFailed(event, now);
}

void CommandCore::Impl::handle(const link::RobotStatus& status, Instant now) {
  robot_.update(status);
  limits_.see(status);
  actions_.emplace_back(RobotStatusReceived{status, robot_.moving()});
  robotChanged(now);
}

void CommandCore::Impl::robotChanged(Instant now) {
  forecast_.robotChanged(settings_.evidence_timeout, now);
  arbiter_.robotChanged(now);
  arbiter_.settle(now);  // a lost link ends its motion first
  keeper_.run().statusChanged(now);
}

void CommandCore::Impl::warn(std::string text) {
  actions_.emplace_back(LogMessage{Severity::Warning, std::move(text)});
}

}  // namespace cobot_command::command
