// Planning in parallel with the core: a piece of work that needs nothing of the core, and its answer.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "cobot_command/arm/types.h"
#include "cobot_command/blocks/shared/outcome.h"

namespace cobot_command::command {

/// Increasing; 0: none.
using PlanJobId = std::uint64_t;

/// The lanes are processed independently, each one plan after the other: a command to send waits for no other
/// plans.
enum class PlanLane { Send, Other };

/// A command with its plan; used only by the core.
struct PlannedCommand;

struct PlanAnswer {
  blocks::Outcome outcome;                            ///< Rejected, or the result
  std::vector<arm::Pose> tool_path;                   ///< the TCP in the robot base, for people; may be empty
  std::shared_ptr<PlannedCommand> command = nullptr;  ///< of one command to send
  blocks::Detail preview = {};  ///< of a whole goal, for people; the type belongs to its block
};

/// May run on any thread, once. Ends early, with any answer, when its answer is no longer needed.
using PlanWork = std::function<PlanAnswer()>;

/// Who plans: the core itself, during the event; or the driver, which gets PlanAsked and answers with
/// planned().
enum class Planning { AtOnce, Beside };

}  // namespace cobot_command::command
