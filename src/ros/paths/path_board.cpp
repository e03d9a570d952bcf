#include "paths/path_board.h"

#include <algorithm>
#include <utility>

namespace cobot_command::ros_adapter {

PathBoard::Shown* PathBoard::find(blocks::GoalId goal) {
  const auto found =
      std::find_if(shown_.begin(), shown_.end(), [goal](const Shown& one) { return one.goal == goal; });
  return found == shown_.end() ? nullptr : &*found;
}

void PathBoard::show(blocks::GoalId goal, path::PathPreview preview) {
  end(goal);
  dropEnded();
  shown_.push_back({goal, std::move(preview)});
}

void PathBoard::setActive(blocks::GoalId goal, int index) {
  if (Shown* const one = find(goal)) one->active = index;
}

void PathBoard::end(blocks::GoalId goal) {
  Shown* const one = find(goal);
  if (one == nullptr) return;
  one->active = -1;
  one->ended = true;
}

void PathBoard::dropEnded() {
  shown_.erase(std::remove_if(shown_.begin(), shown_.end(), [](const Shown& one) { return one.ended; }),
               shown_.end());
}

std::optional<Eigen::Vector3d> PathBoard::activePlace() const {
  for (const Shown& one : shown_) {
    for (const auto& point : one.preview.points) {
      if (one.active >= 0 && point.index == one.active) return point.place;
    }
  }
  return std::nullopt;
}

}  // namespace cobot_command::ros_adapter
