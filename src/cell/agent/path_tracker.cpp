#include "agent/path_tracker.h"

#include <algorithm>

#include "cobot_command/cell/artifact/place_fit.h"

namespace cobot_command::cell {
namespace {

/// A motion that goes the same way from any place of it: straight in joint space. Of others the way from
/// within is another one than that which was claimed.
bool goesOnFromWithin(const ArtifactFrame& frame) {
  return frame.lines.size() == 1 && frame.lines.front().rfind("PTP(\"J", 0) == 0;
}

}  // namespace

PathTracker::PathTracker(const ArtifactPath& path, const arm::JointVector& start, double tracking)
    : path_(&path), start_(start), tracking_(tracking) {}

std::optional<PathTracker> PathTracker::located(const ArtifactPath& path, const PathProgram& program,
                                                const arm::JointVector& start, double tracking,
                                                std::size_t behind, const arm::JointVector& joints) {
  PathTracker tracker(path, start, tracking);
  const PieceSpan span = piecesBehind(path, program, behind);
  if (span.first == 0 && tracker.isAtStart(joints)) return tracker;
  for (std::size_t index = span.first; index < span.end; ++index) {
    const ArtifactPiece& piece = path.pieces[index];
    if (!piece.range.contains(joints, tracking)) continue;
    tracker.piece_ = index;
    tracker.next_frame_ = piece.frame + 1;
    if (tracker.isAtEnd(joints)) return tracker;
    if (piece.kind != Piece::Kind::Motion || !goesOnFromWithin(path.frames[piece.frame])) continue;
    tracker.next_frame_ = piece.frame;
    tracker.resumes_within_ = piece.range;
    return tracker;
  }
  return std::nullopt;
}

void PathTracker::sent() {
  ++next_frame_;
  is_done_ = false;
  is_at_rest_ = false;
  resumes_within_.reset();
}

bool PathTracker::isAtStart(const arm::JointVector& joints) const {
  return motion::JointRange::of(start_).contains(joints, tracking_);
}

std::size_t PathTracker::endOfSent() const {
  const auto end = std::find_if(path_->pieces.begin(), path_->pieces.end(),
                                [this](const ArtifactPiece& piece) { return piece.frame >= next_frame_; });
  return static_cast<std::size_t>(end - path_->pieces.begin());
}

bool PathTracker::see(const arm::JointVector& joints) {
  if (resumes_within_) return resumes_within_->contains(joints, tracking_);
  if (next_frame_ == 0) return isAtStart(joints);
  const std::size_t end = endOfSent();
  for (std::size_t index = piece_; index < end; ++index) {
    if (!path_->pieces[index].range.contains(joints, tracking_)) continue;
    piece_ = index;
    is_at_rest_ = true;
    for (std::size_t behind = index; behind < end; ++behind) {
      is_at_rest_ = is_at_rest_ && path_->pieces[behind].range.contains(joints, tracking_);
    }
    return true;
  }
  return false;
}

std::optional<std::size_t> PathTracker::piece() const {
  if (next_frame_ == 0 && !resumes_within_) return std::nullopt;
  if (!is_at_rest_) return piece_;
  return is_done_ ? endOfSent() - 1 : std::max(piece_, firstRest());
}

std::size_t PathTracker::firstRest() const {
  const auto first =
      std::find_if(path_->pieces.begin(), path_->pieces.end(), [this](const ArtifactPiece& piece) {
        return piece.frame + 1 == next_frame_ && piece.kind == Piece::Kind::Rest;
      });
  return static_cast<std::size_t>(first - path_->pieces.begin());
}

bool PathTracker::willTouch(ZoneIndex zone) const {
  if (!piece()) return true;
  const std::size_t end = std::max(endOfSent(), piece_ + 1);
  for (std::size_t index = *piece(); index < end && index < path_->pieces.size(); ++index) {
    const auto& zones = path_->pieces[index].zones;
    if (std::binary_search(zones.begin(), zones.end(), zone)) return true;
  }
  return false;
}

bool PathTracker::isAtEnd(const arm::JointVector& joints) const {
  if (resumes_within_) return false;
  if (next_frame_ == 0) return isAtStart(joints);
  const std::size_t end = endOfSent();
  return end > 0 && path_->pieces[end - 1].range.contains(joints, tracking_);
}

Duration PathTracker::remaining() const {
  if (next_frame_ == 0 || resumes_within_) return Duration::zero();
  const ArtifactFrame& frame = path_->frames[next_frame_ - 1];
  const ArtifactPiece& piece = path_->pieces[piece_];
  const Duration whole = frame.end - frame.begin;
  if (piece.frame + 1 < next_frame_) return whole;
  const bool has_moved = piece.kind != Piece::Kind::Rest;
  return has_moved ? std::max(Duration::zero(), whole - piece.to) : Duration::zero();
}

}  // namespace cobot_command::cell
