// Planning beside the core: a piece of work that needs nothing of the core, and its answer.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "cobot_command/arm/types.h"
#include "cobot_command/blocks/shared/outcome.h"

namespace cobot_command::command {

/// Counts up; 0: none.
using PlanJobId = std::uint64_t;

/// Each is to be worked on by itself, one plan after the other: what is to be sent now waits for nothing
/// else.
enum class PlanLane { Send, Other };

/// A command with its plan; for the core alone.
struct PlannedCommand;

struct PlanAnswer {
  blocks::Outcome outcome;                            ///< Rejected, or what was found
  std::vector<arm::Pose> tool_path;                   ///< the TCP in the robot base, for people; may be empty
  std::shared_ptr<PlannedCommand> command = nullptr;  ///< of one command that is to be sent
  blocks::Detail preview = {};                        ///< of a whole goal, for people; a kind of its block's
};

/// May be done on any thread, once. Ends early, with any answer, when nobody waits for it any more.
using PlanWork = std::function<PlanAnswer()>;

/// Who plans: the core itself, in the middle of the event; or the driver, which gets PlanAsked, and answers
/// with planned().
enum class Planning { AtOnce, Beside };

}  // namespace cobot_command::command
