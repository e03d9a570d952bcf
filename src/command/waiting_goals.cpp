#include "cobot_command/command/waiting_goals.h"

#include "cobot_command/blocks/list/goal_rules.h"
#include "cobot_command/blocks/shared/failure.h"

namespace cobot_command::command {

bool fallsWithOthers(const blocks::Goal& goal) {
  const blocks::GoalTraits traits = blocks::GoalRules(goal).traits();
  return traits.way == blocks::Way::Queue && !traits.check_only;
}

blocks::Outcome refusedAsTooMany(blocks::Block block, std::size_t waiting) {
  return blocks::toRejection(block, {blocks::tooManyWait(waiting)});
}

}  // namespace cobot_command::command
