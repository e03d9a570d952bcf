// Goal messages -> goals of the core. Numbers are passed on as they came: the core checks them.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <std_msgs/Header.h>

#include "cobot_command/ChangeBaseGoal.h"
#include "cobot_command/ChangeTCPGoal.h"
#include "cobot_command/CheckSequenceGoal.h"
#include "cobot_command/ConnectGoal.h"
#include "cobot_command/ExitListenNodeGoal.h"
#include "cobot_command/MoveAbsoluteGoal.h"
#include "cobot_command/MoveCircleGoal.h"
#include "cobot_command/MoveRelativeGoal.h"
#include "cobot_command/PickAndPlaceGoal.h"
#include "cobot_command/ProgramControlGoal.h"
#include "cobot_command/RunScriptGoal.h"
#include "cobot_command/StopGoal.h"
#include "cobot_command/arm/types.h"
#include "cobot_command/blocks/goal.h"

namespace cobot_command::ros_adapter {

/// Where a tf frame is; or in plain words why that is not known.
struct FramePlace {
  std::optional<arm::Pose> in_robot_base;  ///< [m]
  std::string fault;
};
/// Finds the frame of a header, at its stamp; zero: the latest. Answers at once.
using FrameLookup = std::function<FramePlace(const std_msgs::Header&)>;

[[nodiscard]] blocks::ConnectGoal toGoal(const cobot_command::ConnectGoal& message,
                                         const FrameLookup& frames);
[[nodiscard]] blocks::MoveAbsoluteGoal toGoal(const cobot_command::MoveAbsoluteGoal& message,
                                              const FrameLookup& frames);
[[nodiscard]] blocks::MoveRelativeGoal toGoal(const cobot_command::MoveRelativeGoal& message,
                                              const FrameLookup& frames);
[[nodiscard]] blocks::MoveCircleGoal toGoal(const cobot_command::MoveCircleGoal& message,
                                            const FrameLookup& frames);
[[nodiscard]] blocks::ChangeBaseGoal toGoal(const cobot_command::ChangeBaseGoal& message,
                                            const FrameLookup& frames);
[[nodiscard]] blocks::ChangeTcpGoal toGoal(const cobot_command::ChangeTCPGoal& message,
                                           const FrameLookup& frames);
[[nodiscard]] blocks::ProgramControlGoal toGoal(const cobot_command::ProgramControlGoal& message,
                                                const FrameLookup& frames);
[[nodiscard]] blocks::StopGoal toGoal(const cobot_command::StopGoal& message, const FrameLookup& frames);
[[nodiscard]] blocks::ExitListenNodeGoal toGoal(const cobot_command::ExitListenNodeGoal& message,
                                                const FrameLookup& frames);
[[nodiscard]] blocks::RunScriptGoal toGoal(const cobot_command::RunScriptGoal& message,
                                           const FrameLookup& frames);
[[nodiscard]] blocks::CheckSequenceGoal toGoal(const cobot_command::CheckSequenceGoal& message,
                                               const FrameLookup& frames);
/// Reads steps_file, when it is given.
[[nodiscard]] blocks::PickAndPlaceGoal toGoal(const cobot_command::PickAndPlaceGoal& message,
                                              const FrameLookup& frames);

}  // namespace cobot_command::ros_adapter
