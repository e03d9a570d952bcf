#include "claims/sweep.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cobot_command/cell/sweep/displacement.h"

namespace cobot_command::cell {
namespace {

using motion::Interval;

/// Shorter, and nothing was proved: the motion is refused.
constexpr Duration kShortest = std::chrono::microseconds(1);

Interval firstHalf(const Interval& time) {
  return {time.from, time.from + (time.to - time.from) / 2};
}
Interval secondHalf(const Interval& time) {
  return {time.from + (time.to - time.from) / 2, time.to};
}

}  // namespace

RobotClaim Sweep::pieces() {
  RobotClaim claim;
  claim.name = planned_.name;
  for (const PlannedStation& station : planned_.stations) {
    claim.stations.push_back(
        rest(station.joints, {Piece::Kind::Rest, 0, 0, bodies_.carrying(station.carried)}));
  }
  for (std::size_t path = 0; path < planned_.paths.size(); ++path) {
    claim.paths.push_back(piecesOf(path));
  }
  return claim;
}

PathClaim Sweep::piecesOf(std::size_t index) {
  const PlannedPath& path = planned_.paths[index];
  path_ = &robot_.program[index];
  pieces_.clear();
  last_ = nullptr;
  standing_ = planned_.stations[path.from].joints;
  for (std::size_t frame = 0; frame < path.frames.size() && faults_.empty(); ++frame) claimFrame(path, frame);
  return {std::exchange(pieces_, {})};
}

void Sweep::claimFrame(const PlannedPath& path, std::size_t index) {
  const PlannedFrame& frame = path.frames[index];
  Made made{Piece::Kind::Motion, index, 0, bodies_.carrying(frame.carried)};
  for (const PlannedMotion& motion : frame.motions) {
    // Frames without a motion in between, such as those that change the base, do not keep it from blending.
    if (last_ != nullptr && last_->blend) claimCorner(*last_, motion, made);
    claimMotion(*motion.trajectory, made, {Duration::zero(), motion.trajectory->duration()});
    last_ = &motion;
    standing_ = motion.trajectory->end().position;
    ++made.motion;
  }
  if (made.motion > 0) --made.motion;
  claimRests(path, made);
}

/// It stands there as long as the next frame is not sent, whatever comes then; with what it has not set down
/// yet, with that and what it has taken, and with what it goes on with: what it has set down keeps a zone no
/// longer than until then.
void Sweep::claimRests(const PlannedPath& path, const Made& made) {
  const bool is_last = made.frame + 1 == path.frames.size();
  const std::set<std::string>& before = path.frames[made.frame].carried;
  const std::set<std::string>& behind = is_last ? path.carried_at_end : path.frames[made.frame + 1].carried;
  std::set<std::string> both = before;
  both.insert(behind.begin(), behind.end());
  Made of_rest = made;
  of_rest.kind = Piece::Kind::Rest;
  std::vector<std::set<std::string>> all{before, both, behind};
  all.erase(std::unique(all.begin(), all.end()), all.end());
  for (const auto& carried : all) {
    of_rest.bodies = bodies_.carrying(carried);
    pieces_.push_back(rest(standing_, of_rest));
  }
}

void Sweep::claimMotion(const motion::Trajectory& trajectory, const Made& made, Interval time) {
  if (!faults_.empty()) return;
  const auto range = trajectory.jointRange(time.from, time.to);
  const bool is_shortest = time.to - time.from <= kShortest;
  if (!range && is_shortest) return fault(made.frame, range.error());
  if (range && add(*range, made, time, is_shortest)) return;
  claimMotion(trajectory, made, firstHalf(time));
  claimMotion(trajectory, made, secondHalf(time));
}

void Sweep::claimCorner(const PlannedMotion& before, const PlannedMotion& next, const Made& made) {
  const motion::Corner corner{*before.trajectory, *next.trajectory, before.tcp};
  const motion::CornerReach reach = motion::cornerReach(planned_.arm, corner, *before.blend);
  if (reach.before <= Duration::zero() || reach.next <= Duration::zero()) return;
  Made of_corner = made;
  of_corner.kind = Piece::Kind::Corner;
  const Duration end = before.trajectory->duration();
  claimCornerPart(corner, of_corner, reach, {end - reach.before, end}, {Duration::zero(), reach.next});
}

void Sweep::claimCornerPart(const motion::Corner& corner, const Made& made, const motion::CornerReach& reach,
                            Interval of_before, Interval of_next) {
  // Of its reach the next motion has never made a larger share than that before it. Times are rounded down
  // where they are halved.
  constexpr Duration kRounded(4);
  const double left = toSeconds(corner.before.duration() - of_before.to);
  const double made_of_before = 1.0 - (left - toSeconds(kRounded)) / toSeconds(reach.before);
  if (!faults_.empty() || toSeconds(of_next.from - kRounded) > made_of_before * toSeconds(reach.next)) return;
  const auto range = motion::cornerRange(corner.before, of_before, corner.next, of_next);
  const bool is_shortest =
      of_before.to - of_before.from <= kShortest && of_next.to - of_next.from <= kShortest;
  if (!range && is_shortest) return fault(made.frame, range.error());
  if (range && add(*range, made, of_next, is_shortest)) return;
  for (const Interval& before : {firstHalf(of_before), secondHalf(of_before)}) {
    for (const Interval& next : {firstHalf(of_next), secondHalf(of_next)}) {
      claimCornerPart(corner, made, reach, before, next);
    }
  }
}

Piece Sweep::rest(const arm::JointVector& joints, const Made& made) const {
  Piece piece;
  piece.kind = made.kind;
  piece.frame = made.frame;
  piece.motion = made.motion;
  piece.posture = ArmPosture{motion::JointRange::of(joints), made.bodies};
  return piece;
}

bool Sweep::add(const motion::JointRange& range, const Made& made, Interval time, bool at_any_rate) {
  const PlacedRobot placed = made.bodies->at(range.centre());
  const double displacement = largestDisplacement(*made.bodies, placed, 0.5 * range.widths());
  if (displacement > parameters_.step_bound && !at_any_rate) return false;
  Piece piece;
  piece.kind = made.kind;
  piece.frame = made.frame;
  piece.motion = made.motion;
  piece.from = time.from;
  piece.to = time.to;
  piece.displacement = displacement;
  piece.posture = ArmPosture{range, made.bodies};
  pieces_.push_back(std::move(piece));
  return true;
}

void Sweep::fault(std::size_t frame, const motion::Unbounded& unbounded) {
  const Step& step =
      path_
          ->steps[planned_.paths[static_cast<std::size_t>(path_ - robot_.program.data())].frames[frame].step];
  faults_.push_back({step.place.file, step.place.line, step.place.column,
                     "programs." + robot_.name + "." + path_->name + ".steps[" + std::to_string(frame) + "]",
                     unbounded.message, "", ""});
}

}  // namespace cobot_command::cell
