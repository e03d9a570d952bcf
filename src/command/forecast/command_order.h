// What goes over the wire for a command, and what the core has to know of it until its end.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "forecast/plan.h"

#include "cobot_command/blocks/shared/block.h"
#include "cobot_command/blocks/shared/command.h"
#include "cobot_command/blocks/shared/goal_values.h"
#include "cobot_command/blocks/shared/order.h"
#include "cobot_command/common/time.h"
#include "cobot_command/robot/arrival.h"

namespace cobot_command::command {

struct CommandOrder : blocks::Order {
  blocks::Block block{};
  blocks::GoalId goal = 0;
  blocks::CommandKey key = 0;
  int command_id_ack = 0;
  std::optional<int> tag;      ///< open in the ledger; none: done as soon as it is accepted
  std::vector<int> mark_tags;  ///< the same of each of its marks
  [[nodiscard]] bool hasMark(int mark_tag) const {
    return std::find(mark_tags.begin(), mark_tags.end(), mark_tag) != mark_tags.end();
  }
  bool exits_node = false;        ///< ScriptExit() is to stand behind its lines
  bool exits_afterwards = false;  ///< the node is to be left with a script of its own once it is done
  bool beside = false;            ///< goes out beside what is on the wire, whatever state the robot is in
  std::optional<Duration> reply_timeout;     ///< other than that of the link
  std::optional<Duration> evidence_timeout;  ///< the same: to be seen at its target, behind its tag
  std::optional<Plan> plan;
  std::optional<Origin> origin;           ///< that it was planned from
  std::string unplanned;                  ///< why there is none, where there should be one
  std::optional<arm::JointVector> start;  ///< where what is in front leaves the arm, as far as it is planned
  std::optional<robot::Target> target;    ///< where it leaves the robot, if that is certain
  std::vector<arm::Pose> tool_path;       ///< as planned, for people
};

/// The order goes out from `now`. Precondition: it was planned, not refused, from the same start.
void takePlan(CommandOrder& order, PlannedCommand& planned, const Origin& now);

/// Behind each mark its tag. Precondition: there are as many.
void addMarks(CommandOrder& order);

/// The queue tag, when one is open for it, and the exit from the node.
void addLastLines(CommandOrder& order);

}  // namespace cobot_command::command
