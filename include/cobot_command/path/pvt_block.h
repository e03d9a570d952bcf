// A piece of a path as one PVT. A PVT reproduces exactly what one script command per point cannot express.
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
  std::vector<motion::PvtJointPoint> points;  ///< empty: the block does not move
  std::map<std::size_t, std::size_t> ends;    ///< point of the plan -> number of `points` that complete it
};

/// The last point of the block that starts with `first`: the next point on which the arm stops.
[[nodiscard]] std::size_t endOfBlock(const PathPlan& plan, std::size_t first);

/// Divides the plan into segments of whole milliseconds, at least `segment` long. Ramps and overlaps start
/// and end at segment boundaries. If boundaries are too close together, those are used with which the cubics
/// deviate least from the plan. Joints and speeds are those of the plan, rounded as they are sent.
[[nodiscard]] PvtBlock sampleBlock(const PathPlan& plan, std::size_t first, std::size_t last,
                                   Duration segment = motion::kLeastSegment);

/// The points of a block that get a tag, at most `most` (at least 1): every point, or every n-th point and
/// the last.
[[nodiscard]] std::vector<std::size_t> taggedPoints(std::size_t first, std::size_t last, std::size_t most);

/// The points of a piece, given by its plan, after which progress is reported, at most `most`: those that end
/// a goal, and others at equal intervals. Never the last one, which has the tag of the piece.
[[nodiscard]] std::vector<std::size_t> markedPoints(const PathPlan& plan, std::size_t most);

/// The lines of a block: enter, points, exit. `tags` (point of the plan -> tag) are inserted after the point
/// that they report. For a block without motion only the tags. Precondition: the tags are those of its
/// points.
[[nodiscard]] std::vector<script::ScriptCommand> scriptOf(const PvtBlock& block,
                                                          const std::map<std::size_t, int>& tags);

}  // namespace cobot_command::path
