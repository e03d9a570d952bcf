#include "agent/state_watch.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::cell {

bool StateWatch::hear(const CellStatus& state, std::uint64_t number, Instant now) {
  if (state.hash != hash_) {
    heard_other_ = now;
    other_ = fmt::format("the supervisor has another artifact ({}, and this is {})",
                         foreignText(state.hash.substr(0, 8)), hash_.substr(0, 8));
    return false;
  }
  // One that has none could not read its journal yet.
  if (heard_ && state_.instance != 0 && state.instance != state_.instance) {
    heard_other_ = now;
    other_ = "there is a second supervisor, or one whose journal is gone";
    return false;
  }
  if (heard_ && std::pair(state.epoch, number) <= std::pair(state_.epoch, number_)) return false;
  state_ = state;
  number_ = number;
  heard_ = now;
  return true;
}

const RobotStatus* StateWatch::mine() const {
  if (!heard_) return nullptr;
  const auto mine = std::find_if(state_.robots.begin(), state_.robots.end(),
                                 [this](const RobotStatus& robot) { return robot.name == robot_; });
  return mine == state_.robots.end() ? nullptr : &*mine;
}

std::optional<std::string> StateWatch::objection(Instant now) const {
  if (heard_other_ && now - *heard_other_ <= lease_) return other_;
  if (!heard_) return heard_other_ ? other_ : "no supervisor was heard";
  if (now - *heard_ > lease_) {
    return fmt::format("the supervisor is silent for {:.1f} s", toSeconds(now - *heard_));
  }
  return std::nullopt;
}

std::optional<Instant> StateWatch::expires() const {
  return heard_ ? std::optional(*heard_ + lease_ + Duration(1)) : std::nullopt;
}

}  // namespace cobot_command::cell
