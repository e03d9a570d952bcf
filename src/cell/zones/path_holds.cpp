#include "zones/path_holds.h"

#include <algorithm>

namespace cobot_command::cell {
namespace {

/// When a piece is over, since the path began, if nothing waits.
Duration endOf(const Piece& piece, const PlannedPath& path) {
  const PlannedFrame& frame = path.frames[piece.frame];
  Duration end = frame.begin + piece.to;
  for (std::size_t motion = 0; motion < piece.motion; ++motion) {
    end += frame.motions[motion].trajectory->duration();
  }
  return piece.kind == Piece::Kind::Rest ? std::max(end, frame.end) : end;
}

std::size_t firstPieceOf(std::size_t frame, const PathClaim& claim) {
  const auto first = std::find_if(claim.pieces.begin(), claim.pieces.end(),
                                  [frame](const Piece& piece) { return piece.frame == frame; });
  return static_cast<std::size_t>(first - claim.pieces.begin());
}

}  // namespace

std::vector<Hold> holdsOnPath(const PathInZone& in_zone) {
  std::vector<Hold> holds;
  if (in_zone.at_begin) holds.push_back({0, std::nullopt, 0, 0});
  const auto& pieces = in_zone.claim.pieces;
  for (std::size_t index = 0; index < pieces.size(); ++index) {
    // The rest at its end is that at the station, but for the rounding of both.
    const bool is_at_station = index + 1 == pieces.size() && pieces[index].kind == Piece::Kind::Rest;
    const bool touches = is_at_station ? in_zone.at_end : pieces[index].claim.touches(in_zone.voxels);
    if (!touches) continue;
    const std::size_t frame = pieces[index].frame;
    if (!holds.empty()) {
      const Piece& last = pieces[*holds.back().last_piece];
      // Within a frame nothing can be booked, so that what it enters again it keeps.
      const bool goes_on =
          last.frame == frame || in_zone.path->frames[frame].begin - endOf(last, *in_zone.path) < kLeastRest;
      if (goes_on) {
        holds.back().last_piece = index;
        continue;
      }
    }
    holds.push_back({0, frame, firstPieceOf(frame, in_zone.claim), index});
  }
  if (in_zone.at_end) holds.back().last_piece.reset();
  return holds;
}

}  // namespace cobot_command::cell
