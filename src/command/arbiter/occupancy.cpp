#include "arbiter/occupancy.h"

#include <utility>

#include <fmt/format.h>

#include "cobot_command/blocks/list/goal_rules.h"
#include "cobot_command/blocks/shared/error_catalogue.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/robot_failure.h"

namespace cobot_command::command {

std::optional<blocks::Block> Occupancy::busyWith() const {
  if (stops_.executes()) return StopGoals::kBlock;
  if (run_) return run_->block();
  if (!queue_.empty()) return blockOf(queue_.front().goal);
  return std::nullopt;
}

std::vector<blocks::Failure> Occupancy::objectionsToAny(blocks::BufferMode mode, bool needs_automatic) const {
  std::vector<blocks::Failure> failures = parts_.keeper.objectionsToCommands();
  if (failures.empty() && !parts_.keeper.run().ready()) {
    return {
        {blocks::motion_error::kNotConnected, "the first status frame has not arrived yet", "Wait for it"}};
  }
  const bool connected = failures.empty() || failures.front().error_id != blocks::motion_error::kNotConnected;
  if (!connected) {
    // It closes the script port, and is then the reason for some blocks.
    if (parts_.robot.emergencyStop()) failures.push_back({blocks::own_error::kEmergencyStop, "", ""});
    return failures;
  }
  const auto busy = busyWith();
  if (mode == blocks::BufferMode::Refuse && busy) {
    failures.push_back({blocks::motion_error::kOtherBlockBusy, toString(*busy), ""});
  }
  if (mode == blocks::BufferMode::Buffered && waiting() >= kMostWaiting) {
    failures.push_back(blocks::tooManyWait(waiting()));
  }
  if (parts_.robot.emergencyStop()) failures.push_back({blocks::own_error::kEmergencyStop, "", ""});
  if (parts_.robot.inError()) failures.push_back(blocks::robotError(parts_.robot));
  if (needs_automatic && parts_.robot.manualMode() && !parts_.settings.path.in_manual_mode) {
    failures.push_back({blocks::own_error::kManualMode, "", ""});
  }
  if (mode == blocks::BufferMode::Refuse && stops_.holdsBack() && !stops_.busy()) {
    failures.push_back({blocks::own_error::kOrphanMoves, stops_.heldBackBy(), ""});
  }
  return failures;
}

std::optional<Origin> Occupancy::originBehind(Ticket ticket, Instant now) const {
  if (const Waiting* const before = queue_.lastBefore(ticket)) return before->end;
  if (!run_ || run_->leavesTheRobot()) return parts_.forecast.origin(now);
  return run_->isOneCommand() ? window_.end(now) : std::nullopt;
}

Origin Occupancy::originNow(Instant now) const {
  if (window_.empty()) return parts_.forecast.origin(now);
  if (auto end = window_.end(now)) return *std::move(end);
  Origin unknown = parts_.forecast.origin(now);
  unknown.start.joints.reset();
  unknown.behind.reset();
  return unknown;
}

std::size_t Occupancy::waiting() const {
  return queue_.size() + aside_.waiting() + (run_ && run_->chain() != nullptr ? run_->chain()->waiting() : 0);
}

blocks::BufferMode Occupancy::modeOf(blocks::Block block, const blocks::GoalTraits& traits) const {
  const bool refuses = traits.buffer_mode == blocks::BufferMode::Refuse;
  if (!refuses || !traits.chains || stops_.executes()) return traits.buffer_mode;
  const auto last = queue_.empty() ? busyWith() : blockOf(queue_.back().goal);
  return last == block ? blocks::BufferMode::Buffered : traits.buffer_mode;
}

blocks::Detail Occupancy::chainFor(blocks::Block block) const {
  const blocks::GoalChain* const chain = run_ && queue_.empty() ? run_->chain() : nullptr;
  return chain != nullptr && chain->isJoinedBy(block) ? chain->end() : blocks::Detail();
}

std::vector<blocks::Failure> Occupancy::objectionsTo(const Waiting& next) const {
  const blocks::GoalRules rules(next.goal);
  std::vector<blocks::Failure> failures =
      objectionsToAny(blocks::BufferMode::Aborting, rules.traits().needs_automatic);
  const bool has_waited = next.told_place > 0;
  if (failures.empty() && has_waited) {
    if (auto moved = rules.findMovedFrame(frames_)) failures.push_back(std::move(*moved));
  }
  sortByTable(blockOf(next.goal), failures);
  return failures;
}

std::optional<blocks::Failure> Occupancy::objectionTo(const blocks::Command& command) const {
  std::vector<blocks::Failure> failures =
      objectionsToAny(blocks::BufferMode::Aborting, command.traits.needs_automatic);
  sortByTable(command.block, failures);
  if (!failures.empty()) return std::move(failures.front());
  return command.find_moved_frame ? command.find_moved_frame(frames_) : std::nullopt;
}

/// Whether a motion that is under way stands again can only be told where there is a stream.
bool Occupancy::isHeldBack(const Waiting& next) const {
  const bool robot_stands = !parts_.forecast.loose().mayMove() || !parts_.robot.tellsMotion();
  return parts_.speed.isZero() ||
         parts_.permit.holdsBack(blocks::GoalRules(next.goal).traits(), robot_stands);
}

bool Occupancy::hasToAwaitRest(const Waiting& next) const {
  return blocks::GoalRules(next.goal).traits().awaits_rest && parts_.forecast.loose().endsByItself();
}

bool Occupancy::robotStands() const {
  return !stops_.busy() && !parts_.forecast.loose().mayMove() && parts_.robot.moving() != true;
}

std::string Occupancy::textOfPlace(int place) const {
  if (parts_.permit.interrupts()) return parts_.permit.text();
  if (parts_.speed.isZero()) return "waits until the speed override is above 0 %";
  if (parts_.hold.isHolding()) return "waits for the next motion";
  if (place > 1) return "waits for its turn, after several others";
  if (run_) return "waits for its turn, after one other";
  if (queue_.plansTheNext()) return "is planned as a whole, before its first move";
  return stops_.holdsBack() ? fmt::format("waits until the robot is at standstill: {}", stops_.heldBackBy())
                            : "waits for its turn, until the robot is at standstill";
}

}  // namespace cobot_command::command
