#include "group_desk.h"

#include <tuple>

#include "cobot_command/command/waiting_goals.h"

namespace cobot_command::command {
namespace {

using Sequence = GroupState::Sequence;

/// A joint that differs by more is elsewhere.
constexpr double kElsewhere = degToRad(0.1);
constexpr double kMostHeld = static_cast<double>(kMostWaiting) + 1;

auto asTuple(const GroupState& s) {
  return std::tie(s.ri_state, s.out_of_sync, s.enabled, s.sequence, s.in_primary_position, s.queue_usage,
                  s.pending_errors, s.pending_warnings, s.trend, s.speed_override, s.effective_speed);
}

}  // namespace

bool operator==(const GroupState& a, const GroupState& b) {
  return asTuple(a) == asTuple(b);
}

void GroupDesk::tell() {
  GroupState state;
  state.ri_state = parts_.exchange.riState();
  state.out_of_sync = parts_.sync.whyNot();
  state.enabled = parts_.keeper.isRobotEnabled(parts_.robot);
  state.sequence = sequence();
  state.in_primary_position = isInPrimaryPosition(state.sequence);
  const SetAside& aside = parts_.arbiter.aside();
  const std::size_t held = parts_.arbiter.queue().size() + (parts_.arbiter.turns().run() != nullptr ? 1 : 0) +
                           aside.underWay() + aside.waiting();
  state.queue_usage = 100 * static_cast<double>(held) / kMostHeld;
  state.pending_errors = static_cast<int>(parts_.messages.pendingErrors());
  state.pending_warnings = static_cast<int>(parts_.messages.pendingWarnings());
  state.trend = parts_.robot.trend();
  state.speed_override = parts_.arbiter.speed().percent();
  state.effective_speed = parts_.arbiter.speed().effective();
  if (state == told_) return;
  told_ = state;
  actions_.emplace_back(GroupStateChanged{state});
}

Sequence GroupDesk::sequence() const {
  const bool is_there =
      parts_.arbiter.turns().isAnythingThere() || !parts_.arbiter.queue().empty() || parts_.arbiter.mayMove();
  if (parts_.guard.interrupts() || parts_.arbiter.aside().isThere()) return Sequence::Interrupted;
  if (!is_there) return Sequence::Idle;
  return parts_.robot.held() ? Sequence::Interrupted : Sequence::Executing;
}

bool GroupDesk::isInPrimaryPosition(Sequence sequence) {
  const auto joints = parts_.robot.joints();
  if (const auto& position = parts_.arbiter.aside().position()) {
    interrupted_at_ = position->joints;
  } else if (sequence != Sequence::Interrupted) {
    interrupted_at_.reset();
  } else if (!interrupted_at_ && joints && parts_.robot.moving() == false) {
    interrupted_at_ = joints;
  }
  return !interrupted_at_ || !joints || (*joints - *interrupted_at_).cwiseAbs().maxCoeff() <= kElsewhere;
}

}  // namespace cobot_command::command
