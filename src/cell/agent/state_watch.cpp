#include "agent/state_watch.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::cell {

void StateWatch::told(std::uint64_t report, Instant now) {
  while (!reports_.empty() && now - reports_.begin()->second > lease_) reports_.erase(reports_.begin());
  reports_.emplace(report, now);
}

bool StateWatch::hear(const CellStatus& state, std::uint64_t number, Instant now) {
  if (state.hash != hash_) {
    heard_other_ = now;
    other_ = fmt::format("the supervisor uses another artifact ({}, this node has {})",
                         foreignText(state.hash.substr(0, 8)), hash_.substr(0, 8));
    return false;
  }
  // One that has none could not read its journal yet.
  if (heard_ && instance_ != 0 && state.instance != instance_) {
    heard_other_ = now;
    other_ = "there is a second supervisor, or a supervisor that lost its journal";
    return false;
  }
  if (heard_ && std::pair(state.epoch, number) <= std::pair(epoch_, number_)) return false;
  const auto mine = std::find_if(state.robots.begin(), state.robots.end(),
                                 [this](const RobotStatus& robot) { return robot.name == robot_; });
  mine_ = mine == state.robots.end() ? std::nullopt : std::optional(*mine);
  instance_ = state.instance;
  epoch_ = state.epoch;
  number_ = number;
  mode_ = state.mode;
  is_finishing_ = state.is_finishing;
  heard_ = now;
  const auto known = isOfThisSession() ? reports_.find(mine_->report) : reports_.end();
  if (known != reports_.end()) known_at_ = known->second;
  return true;
}

std::optional<std::string> StateWatch::silence(Instant now) const {
  if (heard_other_ && now - *heard_other_ <= lease_) return other_;
  if (!heard_) return heard_other_ ? other_ : "no message of a supervisor was received";
  if (now - *heard_ > lease_) {
    return fmt::format("no message of the supervisor for {:.1f} s", toSeconds(now - *heard_));
  }
  return std::nullopt;
}

std::optional<std::string> StateWatch::objection(Instant now) const {
  if (auto silent = silence(now)) return silent;
  if (!isOfThisSession()) return std::nullopt;  // that it is not let in is said elsewhere
  if (!known_at_) return "the supervisor has not received the robot's last reports";
  if (now - *known_at_ > lease_) {
    return fmt::format("the supervisor's last report of the robot is {:.1f} s old",
                       toSeconds(now - *known_at_));
  }
  return std::nullopt;
}

}  // namespace cobot_command::cell
