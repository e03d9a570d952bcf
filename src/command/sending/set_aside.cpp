#include "sending/set_aside.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/error_catalogue.h"
#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::command {
namespace {

constexpr double kSameMass = 0.001;  // [kg]

bool isSame(const std::optional<arm::Pose>& a, const std::string& name_of_a,
            const std::optional<arm::Pose>& b, const std::string& name_of_b) {
  if (a && b) return arm::isSamePose(*a, *b);
  return name_of_a == name_of_b && (!name_of_a.empty() || (!a && !b));
}

std::string nameOf(const std::string& name) {
  return name.empty() ? "given by value" : name;
}

constexpr const char* kInterrupted = "interrupted: continue resumes it from where the robot was interrupted";

}  // namespace

std::optional<Duration> tellReports(blocks::Run& run, std::map<blocks::GoalId, tables::Hold>& holds,
                                    OutputBoard& board, std::vector<Action>& actions) {
  blocks::RunReports& reports = run.reports();
  std::optional<Duration> remaining;
  for (auto& [goal, progress] : reports.takeProgress()) {
    if (goal == run.goal()) remaining = progress.remaining;
    board.progress(run.block(), goal, std::move(progress));
  }
  for (auto& news : reports.takeNews()) actions.emplace_back(RunTold{run.block(), std::move(news)});
  for (auto& [goal, outcome] : reports.takeEnded()) {
    holds.erase(goal);
    board.end(run.block(), goal, std::move(outcome));
  }
  return remaining;
}

std::optional<blocks::Failure> differenceIn(const Setup& then, const Setup& now) {
  namespace id = blocks::return_error;
  const robot::ActiveFrames& a = then.frames;
  const robot::ActiveFrames& b = now.frames;
  if (!isSame(a.tcp, a.tcp_name, b.tcp, b.tcp_name)) {
    return blocks::Failure{id::kToolDiffers,
                           fmt::format("the TCP was {}, and is {}", nameOf(a.tcp_name), nameOf(b.tcp_name)),
                           ""};
  }
  if (a.tool_mass && b.tool_mass && std::abs(*a.tool_mass - *b.tool_mass) > kSameMass) {
    return blocks::Failure{
        id::kLoadDiffers,
        fmt::format("the tool had {:.3f} kg, and has {:.3f} kg", *a.tool_mass, *b.tool_mass), ""};
  }
  if (now.load && std::abs(then.load.value_or(0) - *now.load) > kSameMass) {
    return blocks::Failure{
        id::kLoadDiffers,
        fmt::format("the load was {:.3f} kg, and is {:.3f} kg", then.load.value_or(0), *now.load), ""};
  }
  if (!isSame(a.base, a.base_name, b.base, b.base_name)) {
    return blocks::Failure{
        id::kFrameDiffers,
        fmt::format("the base was {}, and is {}", nameOf(a.base_name), nameOf(b.base_name)), ""};
  }
  return std::nullopt;
}

// --- Interrupted, and going on.

void SetAside::put(Aside aside, PrimaryPosition position, Instant now) {
  aside_ = std::move(aside);
  position_ = std::move(position);
  allowing_ = 0;
  allowed_.reset();
  if (aside_.run) {
    aside_.run->setAside(now);
    blocks::Progress progress;
    progress.remaining = tellReports(*aside_.run, aside_.holds, board_, actions_);
    progress.phase = blocks::Phase::Held;
    progress.text = kInterrupted;
    board_.progress(aside_.run->block(), aside_.run->goal(), std::move(progress));
  }
  int place = 0;
  for (Waiting& waiting : aside_.waiting) tell(waiting, ++place);
}

void SetAside::tell(Waiting& waiting, int place) {
  waiting.told_place = place;
  blocks::Progress progress;
  progress.phase = blocks::Phase::Queued;
  progress.place_in_queue = place;
  progress.text = kInterrupted;
  board_.progress(blockOf(waiting.goal), waiting.id, std::move(progress));
}

void SetAside::ended(blocks::GoalId goal, bool done, const Setup& setup) {
  if (goal != allowing_ || goal == 0) return;
  allowing_ = 0;
  if (done) allowed_ = setup;
}

std::optional<blocks::Failure> SetAside::objectionTo(const Setup& setup) const {
  if (allowed_ && !differenceIn(*allowed_, setup)) return std::nullopt;
  return differenceIn(position_->setup, setup);
}

std::optional<blocks::Block> SetAside::block() const {
  if (aside_.run) return aside_.run->block();
  return aside_.waiting.empty() ? std::nullopt : std::optional(blocks::blockOf(aside_.waiting.front().goal));
}

Aside SetAside::take(bool behind_segment, Instant now) {
  position_.reset();
  if (aside_.run) aside_.run->putBack(now);
  Aside aside = std::exchange(aside_, {});
  if (behind_segment && !aside.left.empty()) {
    aside.left.front().command = std::move(aside.left.front().at_segment_end);
  }
  return aside;
}

// --- Meanwhile.

void SetAside::push(Waiting waiting) {
  tell(waiting, static_cast<int>(aside_.waiting.size()) + 1);
  aside_.waiting.push_back(std::move(waiting));
}

bool SetAside::cancel(blocks::GoalId goal, const std::string& why, Instant now) {
  if (aside_.run && aside_.run->serves(goal)) {
    if (aside_.run->chain() != nullptr && aside_.run->chain()->takeOut(goal, why, now)) {
      tellReports(*aside_.run, aside_.holds, board_, actions_);
      return true;
    }
    dropWaiting(fmt::format("the command before it, {}, was cancelled", toString(aside_.run->block())));
    aside_.run->cancel(why, now);
    endRun(blocks::commandAborted(why), now);
    endIfOver();
    return true;
  }
  const auto found = std::find_if(aside_.waiting.begin(), aside_.waiting.end(),
                                  [goal](const Waiting& waiting) { return waiting.id == goal; });
  if (found == aside_.waiting.end()) return false;
  const blocks::Block block = blocks::blockOf(found->goal);
  aside_.waiting.erase(found);
  board_.end(block, goal, blocks::commandAborted(why));
  endIfOver();
  return true;
}

int SetAside::finish(blocks::FinishAfter after, const std::string& why, Instant now) {
  const int dropped = dropWaiting(why);
  if (aside_.run) {
    aside_.run->finish(after, now);
    tellReports(*aside_.run, aside_.holds, board_, actions_);
    if (aside_.run->outcome()) endRun({}, now);
  }
  endIfOver();
  return dropped;
}

void SetAside::drop(const std::string& why, Instant now) {
  dropWaiting(why);
  if (!aside_.run) aside_.left.clear();
  if (aside_.run) {
    aside_.run->interrupt(why, now);
    endRun(blocks::commandAborted(why), now);
  }
  endIfOver();
}

void SetAside::linkLost(const std::string& reason, Instant now) {
  if (!isThere()) return;
  dropWaiting("the link was lost: " + reason);
  if (!aside_.run) aside_.left.clear();
  if (aside_.run) {
    const blocks::Failure lost{blocks::motion_error::kLinkDropped, reason, ""};
    aside_.run->linkLost(reason, std::nullopt, now);
    const blocks::Block block = aside_.left.empty() ? aside_.run->block() : aside_.left.front().command.block;
    endRun(toOutcome(block, blocks::Ending::Aborted, lost), now);
  }
  endIfOver();
}

int SetAside::dropWaiting(const std::string& why) {
  const auto waiting = std::exchange(aside_.waiting, {});
  for (const Waiting& one : waiting) {
    board_.end(blocks::blockOf(one.goal), one.id, blocks::commandAborted(why));
  }
  return static_cast<int>(waiting.size());
}

/// Nothing more is sent of it, also not what it would set back behind itself.
void SetAside::endRun(const blocks::Outcome& of_commands, Instant now) {
  const auto run = std::exchange(aside_.run, nullptr);
  for (const Left& left : std::exchange(aside_.left, {})) {
    if (left.goal != 0 && !run->outcome()) run->commandEnded(left.command.key, of_commands, now);
  }
  const blocks::Failure never_sent{blocks::own_error::kShutDown, of_commands.error_description, ""};
  if (const auto next = run->outcome() ? std::nullopt : run->next()) {
    run->commandRefused(next->key, never_sent, now);
  }
  tellReports(*run, aside_.holds, board_, actions_);
  aside_.holds.clear();
  board_.end(run->block(), run->goal(), run->outcome().value_or(of_commands));
}

void SetAside::endIfOver() {
  if (isEmpty()) position_.reset();
}

}  // namespace cobot_command::command
