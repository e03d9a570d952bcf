#include "cobot_command/path/path_pieces.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "motion_refusal.h"
#include "pvt/pvt_phases.h"
#include "pvt/pvt_points.h"
#include <fmt/format.h>

#include "cobot_command/common/path_settings.h"
#include "cobot_command/motion/planner.h"
#include "cobot_command/motion/pvt.h"

namespace cobot_command::path {
namespace {

/// By counting alone: a path of hours is not sampled to be refused.
std::optional<PathRefusal> checkLength(const PathPlan& plan, const PieceLimits& limits) {
  if (plan.duration() == Duration::zero()) return std::nullopt;
  const std::size_t last = plan.points().size() - 1;
  std::size_t count = 0;
  Duration too_long{};  // in front of its end the first segment of too many moves the arm
  for (const PvtPhase& phase : phasesOf(plan, 0, last, limits.segment)) {
    const std::vector<Duration> ends = segmentsOf(phase, limits.segment);
    const bool is_room = count + ends.size() <= limits.most_points;
    if (!is_room && too_long == Duration::zero()) too_long = ends[limits.most_points - count];
    count += ends.size();
  }
  if (too_long == Duration::zero()) return std::nullopt;
  const std::size_t point = plan.placeAt(too_long - Duration(1)).point;
  return PathRefusal{path_error::kTooLong, plan.points()[point].index, -1,
                     fmt::format("the PVT up to the next rest would have {} points, allowed {}: stop the arm "
                                 "at or before this point, or divide the path to it",
                                 count, limits.most_points)};
}

/// What `why` says of the PVT, in the words of a path.
PathRefusal toRefusal(const motion::Refusal& why, const PathPiece& piece, const arm::JointVector& start,
                      const arm::ArmModel& arm) {
  motion::JointState state{start, arm::JointVector::Zero()};
  Duration begin{};
  for (const motion::PvtJointPoint& point : piece.block.points) {
    if (const auto offence = motion::checkPvtSegment(arm, state, point)) {
      return toRefusal(*offence, piece.plan, begin + fromSeconds(offence->time), arm);
    }
    begin += fromSeconds(point.duration);
    state = {point.position, point.velocity};
  }
  return {errorIdOf(why.reason), piece.plan.points().front().index, why.joint, why.message};
}

/// One after the other.
class Pieces {
 public:
  Pieces(const PathPlan& plan, const PathScene& scene, const PieceLimits& limits)
      : plan_(plan), scene_(scene), limits_(limits), start_(plan.at(Duration::zero()).position) {}

  [[nodiscard]] std::optional<PathRefusal> add(std::size_t first, std::size_t last) {
    PathPiece piece{plan_.part(first, last + 1), {}};
    if (auto refusal = checkLength(piece.plan, limits_)) return refusal;
    piece.block = sampleBlock(piece.plan, 0, last - first, limits_.segment);
    if (!piece.block.points.empty()) {
      const auto made = motion::plan(scene_.arm, start_, motion::Pvt{piece.block.points}, {});
      if (!made) return toRefusal(made.error(), piece, start_, scene_.arm);
      start_ = (*made)->end().position;
    }
    pieces_.push_back(std::move(piece));
    return std::nullopt;
  }
  [[nodiscard]] std::vector<PathPiece> take() { return std::move(pieces_); }

 private:
  const PathPlan& plan_;
  const PathScene& scene_;
  const PieceLimits& limits_;
  arm::JointVector start_;  // of the next piece
  std::vector<PathPiece> pieces_;
};

// What is set by default, in a room that knows no motion.
static_assert(PathSettings().segment == motion::kLeastSegment);

/// A shorter segment, or part of a millisecond, nobody could send.
PieceLimits sendable(PieceLimits limits) {
  limits.segment =
      std::max<Duration>(motion::kLeastSegment, std::chrono::ceil<std::chrono::milliseconds>(limits.segment));
  return limits;
}

}  // namespace

Result<std::vector<PathPiece>, PathRefusal> piecesOf(const PathPlan& plan, const PathScene& scene,
                                                     const PieceLimits& limits) {
  const PieceLimits used = sendable(limits);
  Pieces pieces(plan, scene, used);
  for (std::size_t first = 0; first < plan.points().size();) {
    const std::size_t last = endOfBlock(plan, first);
    if (auto refusal = pieces.add(first, last)) return refuse(std::move(*refusal));
    first = last + 1;
  }
  return pieces.take();
}

}  // namespace cobot_command::path
