// The goals of the random events: what stands in them is drawn.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

#include "block_goals.h"

namespace cobot_command::testing {

class RandomGoals {
 public:
  /// Draws 0 to count - 1.
  using Pick = std::function<std::size_t(std::size_t count)>;
  explicit RandomGoals(Pick pick) : pick_(std::move(pick)) {}

  [[nodiscard]] blocks::ChangeBaseGoal base() const {
    blocks::ChangeBaseGoal goal;
    goal.buffer_mode = bufferMode();
    return goal;
  }
  /// Of so many of these moves; all but the last are blended, which have nothing behind them, or none is.
  [[nodiscard]] blocks::PickAndPlaceGoal cycle(const blocks::MoveAbsoluteGoal& move) const {
    blocks::PickAndPlaceGoal goal;
    blocks::PickAndPlaceStep step;
    step.move = move;
    step.dwell = static_cast<double>(pick_(2));
    if (isOneIn(2)) step.output = blocks::SetOutputGoal{0, "EndModule", 0, 1};
    goal.steps.assign(1 + pick_(3), step);
    const std::size_t blended = isOneIn(2) ? goal.steps.size() - 1 : 0;
    for (std::size_t i = 0; i < blended; ++i) {
      goal.steps[i] = {step.move, std::nullopt, std::nullopt, 0};
      goal.steps[i].move.blending_enable = true;
    }
    goal.cycles = static_cast<int>(pick_(3));
    goal.buffer_mode = bufferMode();
    return goal;
  }
  [[nodiscard]] blocks::LoadPathGoal path() const {
    auto goal = good<blocks::LoadPathGoal>();
    for (path::PathPoint& point : goal.path) point.termination_type = isOneIn(3) ? 6 : 0;
    goal.execution = static_cast<int>(pick_(3));
    goal.allow_approximation = isOneIn(2);
    goal.enable_tracking[0] = isOneIn(6);
    goal.buffer_mode = bufferMode();
    return goal;
  }
  /// What its client says of its own copies is what comes in and out of sync.
  [[nodiscard]] blocks::ExchangeSettings settings() const {
    auto settings = good<blocks::ExchangeConfigurationGoal>().settings;
    settings.life_sign_time_out = 60000;
    settings.sync_reaction = static_cast<int>(pick_(4));
    settings.sync_delay = static_cast<int>(100 * pick_(2));
    settings.delay_time = static_cast<int>(100 * pick_(2));
    settings.data_enable_sync.tools = true;
    settings.data_in_sync.tools = !isOneIn(3);
    settings.allow_dynamic_blending = isOneIn(2);
    return settings;
  }
  [[nodiscard]] blocks::ExchangeConfigurationGoal exchange() const {
    blocks::ExchangeConfigurationGoal goal;
    goal.settings = settings();
    return goal;
  }

 private:
  [[nodiscard]] bool isOneIn(std::size_t count) const { return pick_(count) == 0; }
  [[nodiscard]] int bufferMode() const { return static_cast<int>(pick_(3)); }

  Pick pick_;
};

}  // namespace cobot_command::testing
