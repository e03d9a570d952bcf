// A core with an exchange_configuration goal, and what it tells.
#pragma once

#include "block_goals.h"
#include "core_rig.h"

#include "cobot_command/blocks/exchange_configuration.h"

namespace cobot_command::testing {

struct ExchangeRig : CoreRig {
  explicit ExchangeRig(std::optional<arm::ArmModel> arm = std::nullopt,
                       link::LinkSettings settings = CoreRig::noStatus())
      : CoreRig(std::move(arm), settings) {}

  blocks::GoalId exchange(const std::function<void(blocks::ExchangeConfigurationGoal&)>& change = {}) {
    auto goal = good<blocks::ExchangeConfigurationGoal>();
    if (change) change(goal);
    return submit(goal);
  }
  /// Of the settings alone.
  blocks::GoalId exchangeWith(const std::function<void(blocks::ExchangeSettings&)>& change) {
    return exchange([&](blocks::ExchangeConfigurationGoal& goal) { change(goal.settings); });
  }
  command::ExchangeAnswer update(const std::function<void(blocks::ExchangeSettings&)>& change) {
    auto settings = good<blocks::ExchangeConfigurationGoal>().settings;
    change(settings);
    command::ExchangeAnswer answer = core.updateExchange(settings, now);
    pump();
    return answer;
  }
  /// As told last.
  blocks::ExchangeReport report(blocks::GoalId id) {
    return progress(id).empty() ? blocks::ExchangeReport()
                                : progress(id).back().detail.as<blocks::ExchangeReport>();
  }
  [[nodiscard]] int errorOf(blocks::GoalId id) const {
    return outcome(id) == nullptr ? -1 : outcome(id)->error_id;
  }
  /// The end's own.
  [[nodiscard]] blocks::ExchangeReport last(blocks::GoalId id) const {
    return outcome(id) == nullptr ? blocks::ExchangeReport()
                                  : outcome(id)->detail.as<blocks::ExchangeReport>();
  }
};

}  // namespace cobot_command::testing
