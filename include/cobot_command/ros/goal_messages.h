// Goal messages -> goals of the core. Numbers are passed on as they came: the core checks them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

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
#include "cobot_command/common/result.h"

namespace cobot_command::ros_adapter {

/// Where a tf frame is; or in plain words why that is not known.
struct FramePlace {
  std::optional<arm::Pose> in_robot_base;  ///< [m]
  std::string fault;
};
/// Finds the frame of a header, at its stamp; zero: the latest. Answers at once.
using FrameLookup = std::function<FramePlace(const std_msgs::Header&)>;

/// The steps of a file; or in plain words, with its name, why there are none.
using StepsAnswer = Result<std::vector<blocks::PickAndPlaceStep>, std::string>;
/// Finds the file at a location. Answers at once: nothing means that it is still being read.
using StepsLookup = std::function<std::optional<StepsAnswer>(const std::string& location)>;

/// What a goal may name that is not in its message.
struct Lookups {
  FrameLookup frames;
  StepsLookup steps;
};

[[nodiscard]] blocks::ConnectGoal toGoal(const cobot_command::ConnectGoal& message, const Lookups& lookups);
[[nodiscard]] blocks::MoveAbsoluteGoal toGoal(const cobot_command::MoveAbsoluteGoal& message,
                                              const Lookups& lookups);
[[nodiscard]] blocks::MoveRelativeGoal toGoal(const cobot_command::MoveRelativeGoal& message,
                                              const Lookups& lookups);
[[nodiscard]] blocks::MoveCircleGoal toGoal(const cobot_command::MoveCircleGoal& message,
                                            const Lookups& lookups);
[[nodiscard]] blocks::ChangeBaseGoal toGoal(const cobot_command::ChangeBaseGoal& message,
                                            const Lookups& lookups);
[[nodiscard]] blocks::ChangeTcpGoal toGoal(const cobot_command::ChangeTCPGoal& message,
                                           const Lookups& lookups);
[[nodiscard]] blocks::ProgramControlGoal toGoal(const cobot_command::ProgramControlGoal& message,
                                                const Lookups& lookups);
[[nodiscard]] blocks::StopGoal toGoal(const cobot_command::StopGoal& message, const Lookups& lookups);
[[nodiscard]] blocks::ExitListenNodeGoal toGoal(const cobot_command::ExitListenNodeGoal& message,
                                                const Lookups& lookups);
[[nodiscard]] blocks::RunScriptGoal toGoal(const cobot_command::RunScriptGoal& message,
                                           const Lookups& lookups);
[[nodiscard]] blocks::CheckSequenceGoal toGoal(const cobot_command::CheckSequenceGoal& message,
                                               const Lookups& lookups);
[[nodiscard]] blocks::PickAndPlaceGoal toGoal(const cobot_command::PickAndPlaceGoal& message,
                                              const Lookups& lookups);

}  // namespace cobot_command::ros_adapter
