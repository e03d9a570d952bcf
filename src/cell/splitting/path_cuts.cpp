#include "splitting/path_cuts.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace cobot_command::cell {
namespace {

/// The pieces of a half are others than those of the whole, as it slows down: where one touches, the cut is
/// tried so many pieces farther back.
constexpr std::size_t kTries = 4;
/// Zones change with what is cut: so often is a path cut anew, a piece farther back.
constexpr std::size_t kMostBackOff = 3;

std::vector<Step> with(const std::vector<Step>& steps, std::size_t index, const StepCut& cut) {
  std::vector<Step> all = steps;
  all[index] = cut.before;
  all.insert(all.begin() + static_cast<std::ptrdiff_t>(index) + 1, cut.behind);
  return all;
}

bool touches(const PathClaim& claim, std::size_t frame, const VoxelSet& voxels) {
  return std::any_of(claim.pieces.begin(), claim.pieces.end(),
                     [&](const Piece& piece) { return piece.frame == frame && piece.claim.touches(voxels); });
}

/// Where the motion of a frame may be cut in front of a piece: the ends of the pieces before it, the last one
/// first.
std::vector<Duration> placesBefore(const PathClaim& claim, std::size_t frame, std::size_t piece) {
  std::vector<Duration> places;
  for (std::size_t index = piece; index-- > 0;) {
    const Piece& before = claim.pieces[index];
    if (before.frame != frame) break;
    if (before.kind == Piece::Kind::Motion) places.push_back(before.to);
  }
  return places;
}

}  // namespace

PathCuts::PathCuts(const SplitCell& stages, RobotIndex robot, std::size_t path)
    : robot_(robot),
      path_(path),
      given_(stages.cell.robots[robot].program[path].steps),
      given_stages_{stages.planned[robot].paths[path], stages.claims[robot].paths[path]} {
  for (std::size_t step = 0; step < given_.size(); ++step) {
    parts_.emplace_back();
    parts_.back().step = step;
  }
}

bool PathCuts::cut(SplitCell& stages) {
  if (is_closed_) return false;
  bool was_cut = false;
  // From the last one on: what is in front of a cut keeps its numbers.
  for (std::size_t frame = parts_.size(); frame-- > 0;) {
    for (const Entry& entry : entriesOf(stages, frame)) {
      if (!cutFrame(stages, frame, entry)) continue;
      was_cut = true;
      break;
    }
  }
  return was_cut;
}

std::vector<PathCuts::Entry> PathCuts::entriesOf(const SplitCell& stages, std::size_t frame) const {
  std::vector<Entry> entries;
  const PathClaim& claim = stages.claims[robot_].paths[path_];
  for (const ZoneIndex zone : bookedWith(stages, frame)) {
    const auto first = std::find_if(claim.pieces.begin(), claim.pieces.end(), [&](const Piece& piece) {
      return piece.frame == frame && piece.claim.touches(stages.zones[zone].voxels);
    });
    if (first == claim.pieces.end()) continue;
    entries.push_back({zone, static_cast<std::size_t>(first - claim.pieces.begin())});
  }
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& one, const Entry& other) { return one.piece < other.piece; });
  return entries;
}

bool PathCuts::cutFrame(SplitCell& stages, std::size_t frame, const Entry& entry) {
  const PathIn where{stages, robot_, path_};
  const std::vector<Step> steps = stages.cell.robots[robot_].program[path_].steps;
  const auto places = placesBefore(stages.claims[robot_].paths[path_], frame, entry.piece);
  for (std::size_t place = back_off_; place < places.size() && place < back_off_ + kTries; ++place) {
    // The second half is not sent later than this.
    if (places[place] < kLeastSaved) return false;
    const auto found = tryCut(stages, frame, places[place]);
    if (!found) continue;
    const std::vector<Step> halves = with(steps, frame, *found);
    const auto planned = planWith(where, halves);
    if (!planned) continue;
    const PlannedPath& path = planned->paths[path_];
    if (path.frames[frame + 1].begin - path.frames[frame].begin < kLeastSaved) return false;
    auto claim = claimWith(where, halves, *planned);
    if (!claim || touches(*claim, frame, stages.zones[entry.zone].voxels)) continue;
    takeOver(stages, robot_, path_, halves, {path, std::move(*claim)});
    note(frame, *found);
    return true;
  }
  return false;
}

std::optional<StepCut> PathCuts::tryCut(const SplitCell& stages, std::size_t frame, Duration time) const {
  const PlannedRobot& robot = stages.planned[robot_];
  const PlannedFrame& planned = robot.paths[path_].frames[frame];
  if (planned.motions.size() != 1) return std::nullopt;
  const Step& step = stages.cell.robots[robot_].program[path_].steps[frame];
  auto cut = cutStep(robot.arm, step, planned.motions.front(), stages.cell.parameters.speed_override, time);
  if (!cut) return std::nullopt;
  // What was cut before is off already.
  cut->measure.deviation += parts_[frame].deviation;
  cut->measure.turn += parts_[frame].turn;
  if (cut->measure.deviation > kMostDeviation || cut->measure.turn > kMostTurn) return std::nullopt;
  return cut;
}

void PathCuts::note(std::size_t step, const StepCut& cut) {
  Part& before = parts_[step];
  Part behind = before;
  behind.from = before.from + cut.progress * (before.to - before.from);
  behind.cut = cut.measure;
  for (Part* part : {&before, &behind}) {
    part->deviation = cut.measure.deviation;
    part->turn = cut.measure.turn;
  }
  before.to = behind.from;
  parts_.insert(parts_.begin() + static_cast<std::ptrdiff_t>(step) + 1, behind);
}

std::vector<ZoneIndex> PathCuts::bookedWith(const SplitCell& stages, std::size_t step) const {
  std::vector<ZoneIndex> zones;
  for (const Hold& hold : stages.held.robots[robot_].paths[path_].holds) {
    if (hold.first_frame == step) zones.push_back(hold.zone);
  }
  return zones;
}

Duration PathCuts::savedBy(const SplitCell& stages, std::size_t step) const {
  const auto& frames = stages.planned[robot_].paths[path_].frames;
  return frames[step].begin - frames[step - 1].begin;
}

bool PathCuts::pay(const SplitCell& stages) const {
  for (std::size_t step = 0; step < parts_.size(); ++step) {
    if (!parts_[step].cut) continue;
    if (bookedWith(stages, step).empty() || savedBy(stages, step) < kLeastSaved) return false;
  }
  return true;
}

void PathCuts::revert(SplitCell& stages, bool for_good) {
  takeOver(stages, robot_, path_, given_, given_stages_);
  *this = [&] {
    PathCuts whole(stages, robot_, path_);
    whole.back_off_ = back_off_ + 1;
    whole.is_closed_ = for_good || whole.back_off_ > kMostBackOff;
    return whole;
  }();
}

void PathCuts::report(SplitCell& stages) const {
  Path& path = stages.cell.robots[robot_].program[path_];
  for (std::size_t step = 0; step < parts_.size(); ++step) {
    const Part& part = parts_[step];
    if (!part.cut) continue;
    CutReport report{stages.cell.robots[robot_].name, path.name, part.step, step, {}, part.from,
                     savedBy(stages, step),           *part.cut};
    for (const ZoneIndex zone : bookedWith(stages, step)) report.zones.push_back(stages.zones[zone].name);
    const std::string& given = given_[part.step].name;
    path.steps[step - 1].name =
        fmt::format("{} (before {})", given.empty() ? fmt::format("step {}", part.step + 1) : given,
                    fmt::join(report.zones, " and "));
    stages.cuts.push_back(std::move(report));
  }
}

}  // namespace cobot_command::cell
