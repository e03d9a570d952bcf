// The items of the status stream: names and values as the vendor's ROS driver needs them (fact sheet 3.2).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/protocol/status_items.h"
#include "cobot_command/simulator/robot_state.h"
#include "cobot_command/simulator/settings.h"

namespace cobot_command::simulator {

/// All that the items are made from.
struct ItemSource {
  const arm::ArmModel& arm;
  const Settings& settings;
  const RobotState& state;
  const FaultSwitch& hidden;  ///< its text names items that are not there
};

/// Is there an item of that name, hidden or not?
[[nodiscard]] bool isItem(std::string_view name);

/// The items of a periodic frame, Robot_Link first.
[[nodiscard]] std::vector<protocol::StatusItem> streamedItems(const ItemSource& source);

/// Any known item, streamed or not; nothing when there is none of that name, or it is hidden.
[[nodiscard]] std::optional<protocol::StatusItem> itemNamed(std::string_view name, const ItemSource& source);

}  // namespace cobot_command::simulator
