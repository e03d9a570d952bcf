// What the pendant changes in the project: how its TCPs and bases are taught.
#pragma once

#include "robot/project_data.h"

#include "cobot_command/simulator/operator_action.h"
#include "cobot_command/simulator/operator_reply.h"

namespace cobot_command::simulator {

/// Both as it is now and as it was taught; or not at all, and why.
[[nodiscard]] OperatorReply teach(ProjectData& project, const SetTcp& action);
[[nodiscard]] OperatorReply teach(ProjectData& project, const SetBase& action);
[[nodiscard]] OperatorReply teach(ProjectData& project, const SetLoad& action);

}  // namespace cobot_command::simulator
