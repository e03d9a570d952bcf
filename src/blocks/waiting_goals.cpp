#include "cobot_command/blocks/waiting_goals.h"

#include <variant>

#include "failure.h"

#include "cobot_command/common/overloaded.h"

namespace cobot_command::blocks {

bool fallsWithOthers(const Goal& goal) {
  return std::visit(Overloaded{
                        [](const MoveAbsoluteGoal& g) { return !g.check_only; },
                        [](const MoveRelativeGoal& g) { return !g.check_only; },
                        [](const MoveCircleGoal& g) { return !g.check_only; },
                        [](const PickAndPlaceGoal& g) { return !g.check_only; },
                        [](const ConnectGoal&) { return false; },
                        [](const ProgramControlGoal&) { return false; },
                        [](const StopGoal&) { return false; },
                        [](const CheckSequenceGoal&) { return false; },
                        [](const auto&) { return true; },
                    },
                    goal);
}

Outcome refusedAsTooMany(Block block, std::size_t waiting) {
  return toRejection(block, {tooManyWait(waiting)});
}

}  // namespace cobot_command::blocks
