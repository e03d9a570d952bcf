#include "arbiter/admission.h"

#include <utility>

#include <fmt/format.h>

#include "cobot_command/blocks/list/goal_rules.h"
#include "cobot_command/blocks/shared/error_catalogue.h"
#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::command {
namespace {

/// Nothing is known that speaks against it; it is only not known enough.
bool couldNotBePlanned(blocks::Block block, const blocks::Outcome& found) {
  const int id = generalErrorId(block, found.error_id);
  return id == blocks::own_error::kStartUnknown || id == blocks::own_error::kNoModel ||
         id == blocks::own_error::kBaseUnknown;
}

}  // namespace

bool Admission::beginNext(Instant now) {
  if (!desks_.window.empty() || desks_.queue.empty()) return false;
  if (occupancy_.isHeldBack(desks_.queue.front())) {
    // What was planned of it is planned anew when it goes on, with all the time that a plan has.
    if (desks_.queue.plansTheNext()) sender_.forget();
    desks_.queue.forgetTurn();
    return false;
  }
  return !parts_.hold.holdsBack(desks_.queue.front().id, desks_.queue.motions()) && admitNext(now);
}

bool Admission::joinNext(Instant now) {
  return !desks_.queue.empty() && under_way_.run->chain() != nullptr &&
         under_way_.run->chain()->isJoinedBy(blockOf(desks_.queue.front().goal)) &&
         !occupancy_.isHeldBack(desks_.queue.front()) && admitNext(now);
}

bool Admission::admitNext(Instant now) {
  Waiting& first = desks_.queue.front();
  const std::vector<blocks::Failure> failures = occupancy_.objectionsTo(first);
  if (failures.empty() && occupancy_.hasToAwaitRest(first)) {
    sender_.askForRest();
    return true;
  }
  if (failures.empty() && isBeingPlanned(first, now)) return false;
  Waiting next = desks_.queue.take();
  if (failures.empty()) {
    admit(std::move(next), now);
  } else {
    refuseTurn(next, toRejection(blockOf(next.goal), failures));
  }
  return true;
}

bool Admission::isBeingPlanned(Waiting& first, Instant now) {
  using Turn = Waiting::Turn;
  const blocks::GoalRules rules(first.goal);
  if (const auto command = rules.command()) {
    first.turn = Turn::PlansCommand;
    return sender_.look(*command, first.id, now) == NextCommand::State::Planning;
  }
  if (rules.isPlanned() && first.turn == Turn::NotYet) {
    first.turn = Turn::PlansWhole;
    first.told_place = 0;  // what it waits for is another thing now
    if (auto use = rules.uses()) first.hold = parts_.tables.hold(*std::move(use));
    desks_.plans.planTheNext(under_way_.run ? under_way_.run->chain()->end() : blocks::Detail(), now);
  }
  return rules.isPlanned() && !first.found;
}

void Admission::admit(Waiting next, Instant now) {
  const blocks::Outcome found = next.found.value_or(blocks::Outcome());
  const blocks::GoalRules rules(next.goal);
  const bool may_do_without = !rules.traits().needs_plan && couldNotBePlanned(blockOf(next.goal), found);
  if (found.ending == blocks::Ending::Rejected && !may_do_without) {
    refuseTurn(next, found);
  } else if (under_way_.run) {
    join(std::move(next), found, now);
  } else {
    begin(next, found, now);
  }
}

/// One whose plan is of a chain that has gone on since is the next one again.
void Admission::join(Waiting next, const blocks::Outcome& found, Instant now) {
  const blocks::GoalId id = next.id;
  if (under_way_.run->chain()->join(id, found, now)) {
    parts_.board.accept(under_way_.run->block(), id, 0);
    under_way_.holds[id] = next.hold;
    return;
  }
  next.found.reset();
  next.turn = Waiting::Turn::NotYet;
  desks_.queue.putBack(std::move(next));
}

void Admission::begin(const Waiting& next, const blocks::Outcome& found, Instant now) {
  desks_.queue.forgetPlan(next.id);  // what was to be foreseen is there
  auto run = blocks::GoalRules(next.goal).run(next.id, found, now);
  if (run->isOneCommand()) {
    beginCommand(next, std::move(run), now);
  } else {
    parts_.board.accept(run->block(), next.id, 0);
    under_way_.holds[next.id] = next.hold;
    under_way_.run = std::move(run);
    desks_.paths.serve(*under_way_.run, now);
    under_way_.run->robotChanged(parts_.robot, now);
  }
}

void Admission::beginCommand(const Waiting& next, std::unique_ptr<blocks::Run> run, Instant now) {
  const blocks::Command command = *run->next();
  if (const auto failure = sender_.prepare(command, now)) {
    refuseTurn(next, toRejection(run->block(), {*failure}));
    return;
  }
  parts_.board.accept(run->block(), next.id, sender_.acknowledgedId());
  under_way_.run = std::move(run);
  under_way_.run->commandStarted(command.key);
  desks_.stops.commanded();
  sender_.send(command, next.id, true, now);
}

/// What waits behind it stands on where it would have left the robot. When it has not waited itself, it is
/// refused as it comes, like a goal that is wrong by itself, and takes none with it, also not those that came
/// while it was planned.
void Admission::refuseTurn(const Waiting& next, blocks::Outcome refusal) {
  const blocks::Block block = blocks::blockOf(next.goal);
  desks_.queue.forgetPlan(next.id);
  sender_.forget();
  if (next.told_place > 0) {
    desks_.queue.dropAll(fmt::format("the command before it, {}, was refused", toString(block)));
  }
  parts_.board.end(block, next.id, std::move(refusal));
}

}  // namespace cobot_command::command
