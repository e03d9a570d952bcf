// The items of the status stream that are read here: what each is needed for, and what cannot be done without
// it. The one place that says so; doc/real-robot.md, diagnosis, messages and refusals are made from it, or
// held against it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/link/robot_status.h"

namespace cobot_command::link {

enum class ItemNeed {
  Ready,   ///< without it nobody can say that the robot is ready to move
  Always,  ///< every data table should have it
  Choice   ///< of whoever needs it
};

struct StreamItem {
  std::string_view name;
  ItemNeed need = ItemNeed::Choice;
  std::string_view without;  ///< what is so where the data table does not have it, for people
};

/// In the order of doc/real-robot.md. Several of one kind, such as inputs, are one row with the name of the
/// first.
[[nodiscard]] const std::vector<StreamItem>& streamItems();

/// Those that every data table should have, and this frame did not; what it has and cannot be read is no part
/// of it (RobotStatus::unreadable).
[[nodiscard]] std::vector<StreamItem> missingItems(const RobotStatus& status);
/// Only those without which nobody can say that the robot is ready to move.
[[nodiscard]] std::vector<StreamItem> missingForReady(const RobotStatus& status);

/// "Joint_Angle (no joint_states, ...), ESTOP (...)"; empty: none.
[[nodiscard]] std::string describe(const std::vector<StreamItem>& missing);
/// "Joint_Angle, ESTOP".
[[nodiscard]] std::string namesOf(const std::vector<StreamItem>& items);
/// What has to be done so that they come.
[[nodiscard]] std::string remedyForMissingItems();
/// For whoever is refused something for want of that item, one of streamItems().
[[nodiscard]] std::string lackOf(std::string_view item);

}  // namespace cobot_command::link
