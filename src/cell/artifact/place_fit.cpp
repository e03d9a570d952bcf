#include "cobot_command/cell/artifact/place_fit.h"

#include <algorithm>
#include <cmath>

namespace cobot_command::cell {
namespace {

/// Which part of a path it has passed nobody knows: all of it is where it may be.
bool mechanismFits(const ArtifactMechanism& made, const CellPlace& place, double position) {
  if (place.station) return std::abs(position - made.stations[*place.station].value) <= kMechanismWithin;
  const auto& pieces = made.paths[place.path].pieces;
  return std::any_of(pieces.begin(), pieces.end(), [&](const ArtifactAxisPiece& piece) {
    return position >= std::min(piece.from, piece.to) - kMechanismWithin &&
           position <= std::max(piece.from, piece.to) + kMechanismWithin;
  });
}

}  // namespace

PieceSpan piecesBehind(const ArtifactPath& path, const PathProgram& program, std::size_t behind) {
  PieceSpan span{0, path.pieces.size()};
  for (std::size_t step = 0; step < path.places.size(); ++step) {
    const ZonePlace& place = path.places[step];
    if (step < behind && !program.steps[step].books) span.first = std::max(span.first, place.piece + 1);
    if (step < behind || !program.steps[step].books) continue;
    const auto first = std::find_if(path.pieces.begin(), path.pieces.end(),
                                    [&](const ArtifactPiece& piece) { return piece.frame >= place.frame; });
    span.end = std::min(span.end, static_cast<std::size_t>(first - path.pieces.begin()));
  }
  return span;
}

bool placeFits(const Artifact& artifact, RobotIndex robot, const CellPlace& place,
               const arm::JointVector& joints) {
  if (robot >= artifact.robots.size()) {
    return mechanismFits(artifact.mechanisms[robot - artifact.robots.size()], place, joints[0]);
  }
  const ArtifactRobot& made = artifact.robots[robot];
  const double tracking = artifact.parameters.tracking;
  if (place.station) {
    const motion::JointRange station = motion::JointRange::of(made.stations[*place.station].joints);
    return station.contains(joints, std::max(kStandsWithin, tracking));
  }
  const ArtifactPath& path = made.paths[place.path];
  const PathProgram& program = artifact.program.robots[robot].paths[place.path];
  const PieceSpan span = piecesBehind(path, program, place.behind);
  if (span.first == 0 && motion::JointRange::of(made.stations[program.from].joints)
                             .contains(joints, std::max(kStandsWithin, tracking))) {
    return true;
  }
  for (std::size_t piece = span.first; piece < span.end; ++piece) {
    if (path.pieces[piece].range.contains(joints, tracking)) return true;
  }
  return false;
}

}  // namespace cobot_command::cell
