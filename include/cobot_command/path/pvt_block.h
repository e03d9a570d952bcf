// A piece of a path as one PVT: what a script command for each point cannot say, a PVT says exactly.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "cobot_command/common/time.h"
#include "cobot_command/motion/command.h"
#include "cobot_command/path/path_plan.h"
#include "cobot_command/script/script_command.h"

namespace cobot_command::path {

/// From rest to rest: points `first` to `last` of a plan.
struct PvtBlock {
  std::size_t first = 0;
  std::size_t last = 0;
  Duration start{};                           ///< since the path began
  std::vector<motion::PvtJointPoint> points;  ///< none: the block does not move
  std::map<std::size_t, std::size_t> ends;    ///< point of the plan -> how many of `points` it is done behind
};

/// The last point of the block that begins with `first`: the next one at which the arm rests.
[[nodiscard]] std::size_t endOfBlock(const PathPlan& plan, std::size_t first);

/// The plan in segments of whole milliseconds, at least `segment` long; ramps and overlaps begin and end with
/// one. Of those that are nearer together the ones count with which the cubics miss the plan the least.
/// Joints and speeds are those of the plan, rounded as they are sent.
[[nodiscard]] PvtBlock sampleBlock(const PathPlan& plan, std::size_t first, std::size_t last,
                                   Duration segment = motion::kLeastSegment);

/// Which points of a block get a tag, when it may have `most` (1 at least): each; else every so many-th, and
/// the last.
[[nodiscard]] std::vector<std::size_t> taggedPoints(std::size_t first, std::size_t last, std::size_t most);

/// Behind which points of a piece, its plan, it is told that it has come so far, at most `most` times: those
/// that end a goal, and others, evenly. Never the last one, which has the tag of the piece.
[[nodiscard]] std::vector<std::size_t> markedPoints(const PathPlan& plan, std::size_t most);

/// The lines of a block: enter, points, `tags` (point of the plan -> tag) behind what they tell of, exit; of
/// a block without a way the tags alone. Precondition: the tags are those of its points.
[[nodiscard]] std::vector<script::ScriptCommand> scriptOf(const PvtBlock& block,
                                                          const std::map<std::size_t, int>& tags);

}  // namespace cobot_command::path
