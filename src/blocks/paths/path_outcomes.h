// How the goals of a chain end: done, stopped, or with one that failed.
#pragma once

#include <string>
#include <vector>

#include "chain/path_chain.h"

#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/path/deviation_watch.h"

namespace cobot_command::blocks {

struct PathStop {
  std::string why;           ///< and what became of the robot
  bool interrupted = false;  ///< by somebody else than its client
};

/// Of each goal of the chain, in their order. One that was interrupted before its last point was loaded has
/// an error of its own (1007), with the first point that was not.
[[nodiscard]] std::vector<Outcome> stoppedOutcomes(const PathChain& chain, const PathChain::Place& place,
                                                   const PathStop& stop);

/// The same: the first one failed, at its active point, and takes the others along.
[[nodiscard]] std::vector<Outcome> failedOutcomes(const PathChain& chain, const PathChain::Place& place,
                                                  Failure failure);

/// With all that is known of how the goal went.
[[nodiscard]] Outcome completed(Outcome outcome, const PathChain::Member& member,
                                const path::Deviation& deviation, Instant now);

}  // namespace cobot_command::blocks
