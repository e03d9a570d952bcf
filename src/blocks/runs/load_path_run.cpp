#include "runs/load_path_run.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "runs/loaded_path.h"
#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_catalogue.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/robot_failure.h"

namespace cobot_command::blocks {
namespace {

constexpr Block kThis = kBlock<LoadPathGoal>;
/// A controller reads some 750 kB of the longest block before it answers.
constexpr std::size_t kLongBlock = 500;
constexpr Duration kLongReply = std::chrono::seconds(10);

Order orderOf(const path::PvtBlock& block) {
  Order order;
  order.commands = path::scriptOf(block, {});
  for (const script::ScriptCommand& command : *order.commands) order.lines.push_back(script::toText(command));
  order.moves = true;
  return order;
}

}  // namespace

LoadPathRun::LoadPathRun(GoalId id, const LoadPathGoal& goal, const Outcome& planned, Instant now)
    : Run(kThis, id),
      traits_(traitsOf(goal)),
      report_(planned.detail.as<PathReport>()),
      planned_(planned.planned),
      started_at_(now) {
  assert(report_.loaded != nullptr);
  traits_.awaits_motion = true;
  for (std::size_t first = 0; first < plan().points().size();) {
    const std::size_t last = path::endOfBlock(plan(), first);
    path::PvtBlock block = path::sampleBlock(plan(), first, last);
    if (!block.points.empty()) pieces_.push_back({std::move(block), pieces_.size()});
    first = last + 1;
  }
  if (pieces_.empty()) endAs({}, now);
}

const path::PathPlan& LoadPathRun::plan() const {
  return report_.loaded->plan;
}

std::optional<Command> LoadPathRun::next() const {
  if (under_way_ || outcome() || isLoaded()) return std::nullopt;
  const Piece& piece = pieces_[sent_];
  Command command;
  command.key = piece.key;
  command.block = kThis;
  command.traits = traits_;
  if (piece.block.points.size() > kLongBlock) command.traits.reply_timeout = kLongReply;
  command.order = [block = piece.block](const arm::Pose& /*base*/) { return orderOf(block); };
  return command;
}

void LoadPathRun::commandStarted(CommandKey /*key*/) {
  under_way_ = true;
  ++sent_;
}

void LoadPathRun::commandProgressed(CommandKey key, const Progress& progress, Instant /*now*/) {
  const path::PvtBlock& block = pieces_[key].block;
  const Duration length = plan().points()[block.last].end() - block.start;
  const Duration time = block.start + fromSeconds(toSeconds(length) * progress.fraction);
  const Duration whole = plan().duration();
  PathPlace place = placeAt(time);
  place.active = progress.phase == Phase::Active || progress.phase == Phase::Held;
  if (place.active) active_ = place.active_path_point;
  Progress mine = progress;
  mine.planned = planned_;
  mine.fraction = whole > Duration::zero() ? toSeconds(time) / toSeconds(whole) : 1.0;
  if (planned_) mine.remaining = fromSeconds(toSeconds(*planned_) * (1.0 - mine.fraction));
  mine.detail = Detail(place);
  report(std::move(mine));
}

PathPlace LoadPathRun::placeAt(Duration time) const {
  const std::size_t point = plan().placeAt(time).point;
  const auto all = static_cast<int>(plan().points().size());
  const int sent = sent_ == 0 ? 0 : static_cast<int>(pieces_[sent_ - 1].block.last) + 1;
  PathPlace place;
  place.loaded = isLoaded();
  place.method_id = report_.method_id;
  place.active_path_point = indexOf(point);
  const int move_id = plan().points()[point].point.move_id;
  place.active_move_id = move_id != 0 ? move_id : report_.method_id;
  place.done_path_points = static_cast<int>(point);
  place.pending_path_points = all - std::max(sent, place.done_path_points + 1);
  place.queued_path_points = all - place.pending_path_points - place.done_path_points - 1;
  return place;
}

int LoadPathRun::indexOf(std::size_t point) const {
  return point < plan().points().size() ? plan().points()[point].index : -1;
}

void LoadPathRun::commandEnded(CommandKey /*key*/, const Outcome& outcome, Instant now) {
  under_way_ = false;
  if (outcome.ending == Ending::CommandAborted) {
    endCancelled(outcome.error_description, now);
  } else if (outcome.ending != Ending::Done) {
    report_.error_index = active_;
    endAs(outcome, now);
  } else if (isLoaded()) {
    endAs(outcome, now);
  }
}

/// The controller's way of its points is planned once more when they are sent; what it may find then has no
/// row of its own.
void LoadPathRun::commandRefused(CommandKey /*key*/, const Failure& failure, Instant now) {
  const bool has_row = findError(kThis, ownErrorId(kThis, failure.error_id)) != nullptr;
  fail(has_row ? failure : Failure{own_error::kNotPlannable, "as a PVT: " + failure.found, ""}, now);
}

void LoadPathRun::cancel(const std::string& why, Instant now) {
  if (!under_way_ && !outcome()) endCancelled(why + "; no motion was under way", now);
}

void LoadPathRun::endCancelled(const std::string& why, Instant now) {
  if (!taken_away_ || isLoaded()) {
    endAs(commandAborted(why), now);
    return;
  }
  interrupted_ = true;
  report_.error_index = indexOf(pieces_[sent_].block.first);
  endAs(toOutcome(kThis, Ending::Aborted, {load_path_error::kInterrupted, why, ""}), now);
}

void LoadPathRun::linkLost(const std::string& reason, std::optional<Duration> /*patience*/, Instant now) {
  if (!under_way_ && !outcome()) fail({motion_error::kLinkDropped, reason, ""}, now);
}

void LoadPathRun::robotChanged(const robot::RobotWatch& robot, Instant now) {
  if (under_way_ || outcome()) return;
  if (robot.emergencyStop()) {
    fail(emergencyStop(), now);
  } else if (robot.inError()) {
    fail(robotError(robot), now);
  }
}

void LoadPathRun::fail(const Failure& failure, Instant now) {
  report_.error_index = active_;
  endAs(toOutcome(kThis, Ending::Aborted, failure), now);
}

void LoadPathRun::endAs(Outcome outcome, Instant now) {
  outcome.planned = planned_;
  outcome.actual = now - started_at_;
  report_.loaded.reset();
  outcome.detail = Detail(report_);
  end(std::move(outcome));
}

}  // namespace cobot_command::blocks
