#include "cobot_command/cell/artifact/place_parts.h"

#include <algorithm>
#include <string>
#include <vector>

#include "cobot_command/cell/artifact/place_fit.h"

namespace cobot_command::cell {
namespace {

/// Frames of a path, from `first` to before `end`.
struct FrameSpan {
  std::size_t first = 0;
  std::size_t end = 0;
};

FrameSpan framesOf(const ArtifactPath& path, const PieceSpan& pieces) {
  if (pieces.end == 0) return {};  // it has not set out yet
  // Where it may be in no piece any more it stands at the end of the last one.
  const std::size_t first = std::min(pieces.first, pieces.end - 1);
  return {path.pieces[first].frame, path.pieces[pieces.end - 1].frame + 1};
}

}  // namespace

Carried carriedAt(const Artifact& artifact, RobotIndex robot, const CellPlace& place) {
  const ArtifactRobot& made = artifact.robots[robot];
  Carried all;
  const auto add = [&all](const std::vector<std::string>& parts) { all.insert(parts.begin(), parts.end()); };
  if (place.station) {
    add(made.stations[*place.station].carried);
    return all;
  }
  const ArtifactPath& path = made.paths[place.path];
  const PathProgram& program = artifact.program.robots[robot].paths[place.path];
  const FrameSpan frames = framesOf(path, piecesBehind(path, program, place.behind));
  if (frames.first == 0) add(made.stations[program.from].carried);
  for (std::size_t frame = frames.first; frame < frames.end; ++frame) add(path.frames[frame].carried);
  // At the end of a frame it takes what the next one carries.
  const bool is_last = frames.end >= path.frames.size();
  add(is_last ? made.stations[program.to].carried : path.frames[frames.end].carried);
  return all;
}

}  // namespace cobot_command::cell
