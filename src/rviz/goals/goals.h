// Forms as the goals of the actions. Every field is written out; what a form does not have stays as a new
// message has it.
#pragma once

#include "forms/cycle.h"
#include "forms/form.h"
#include <cobot_command/ChangeBaseGoal.h>
#include <cobot_command/ChangeTCPGoal.h>
#include <cobot_command/CheckSequenceGoal.h>
#include <cobot_command/ConnectGoal.h>
#include <cobot_command/ExchangeConfigurationGoal.h>
#include <cobot_command/JogGoal.h>
#include <cobot_command/LoadPathGoal.h>
#include <cobot_command/MoveAbsoluteGoal.h>
#include <cobot_command/MoveCircleGoal.h>
#include <cobot_command/MoveRelativeGoal.h>
#include <cobot_command/PickAndPlaceGoal.h>

namespace cobot_command::rviz_plugin {

[[nodiscard]] cobot_command::ConnectGoal toConnect(const Form& form);
[[nodiscard]] cobot_command::ChangeBaseGoal toChangeBase(const Form& form);
[[nodiscard]] cobot_command::ChangeTCPGoal toChangeTcp(const Form& form);
[[nodiscard]] cobot_command::MoveAbsoluteGoal toMoveAbsolute(const Form& form);
[[nodiscard]] cobot_command::MoveRelativeGoal toMoveRelative(const Form& form);
[[nodiscard]] cobot_command::MoveCircleGoal toMoveCircle(const Form& form);
[[nodiscard]] cobot_command::LoadPathGoal toLoadPath(const Form& form, bool check_only);
[[nodiscard]] cobot_command::ExchangeConfigurationGoal toInterface(const Form& form);
[[nodiscard]] cobot_command::PickAndPlaceGoal toPickAndPlace(const Cycle& cycle, bool check_only);
/// `axis`: 0..5, X Y Z RX RY RZ, or J1..J6 of joints. `direction`: 1 or -1.
[[nodiscard]] cobot_command::JogGoal toJog(const Form& form, int axis, int direction);

/// One step for check_sequence, which tells the offending point of what it refuses.
[[nodiscard]] cobot_command::CheckSequenceGoal toCheck(const cobot_command::MoveAbsoluteGoal& goal);
[[nodiscard]] cobot_command::CheckSequenceGoal toCheck(const cobot_command::MoveRelativeGoal& goal);
[[nodiscard]] cobot_command::CheckSequenceGoal toCheck(const cobot_command::MoveCircleGoal& goal);

}  // namespace cobot_command::rviz_plugin
