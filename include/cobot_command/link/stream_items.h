// The items of the status stream that this layer reads: why each is needed, and what is impossible without
// it. This is the only definition; doc/real-robot.md, diagnosis, messages and refusals are made from it or
// checked against it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/link/robot_status.h"

namespace cobot_command::link {

enum class ItemNeed {
  Ready,   ///< without it the robot cannot be known to be ready to move
  Always,  ///< every data table should have it
  Choice   ///< only for those who need it
};

struct StreamItem {
  std::string_view name;
  ItemNeed need = ItemNeed::Choice;
  std::string_view without;  ///< consequence if the data table does not have it, for people
};

/// In the order of doc/real-robot.md. Several items of one kind, such as inputs, are one row with the name of
/// the first one.
[[nodiscard]] const std::vector<StreamItem>& streamItems();

/// Items that every data table should have, but this frame does not. Items that it has but that are
/// unreadable are not included (RobotStatus::unreadable).
[[nodiscard]] std::vector<StreamItem> missingItems(const RobotStatus& status);
/// Only those without which the robot cannot be known to be ready to move.
[[nodiscard]] std::vector<StreamItem> missingForReady(const RobotStatus& status);

/// "Joint_Angle (no joint_states, ...), ESTOP (...)"; empty: none.
[[nodiscard]] std::string describe(const std::vector<StreamItem>& missing);
/// "Joint_Angle, ESTOP".
[[nodiscard]] std::string namesOf(const std::vector<StreamItem>& items);
/// What to do so that the items are streamed.
[[nodiscard]] std::string remedyForMissingItems();
/// Text for a refusal because of that missing item, which is one of streamItems().
[[nodiscard]] std::string lackOf(std::string_view item);

}  // namespace cobot_command::link
