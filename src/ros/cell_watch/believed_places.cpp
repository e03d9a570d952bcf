#include "cell_watch/believed_places.h"

#include <algorithm>

#include "cobot_command/cell/artifact/place_fit.h"
#include "cobot_command/cell/artifact/place_parts.h"

namespace cobot_command::ros_adapter {
namespace {

/// Of a robot that was not heard for longer nobody knows where it is.
constexpr Duration kStale = cell::MonitorSettings().stale_after;

/// In the others not all robots are where the state has them.
bool arePlacesCertain(const cobot_command::CellState& state) {
  using State = cobot_command::CellState;
  return state.mode == State::READY || state.mode == State::RUNNING || state.mode == State::HOLDING;
}

/// One that is lost, moved by people, off its path or failed may have gone on, or been given something.
bool isByItsProgram(const cobot_command::CellRobot& robot) {
  using State = cobot_command::CellRobot;
  return robot.state == State::READY || robot.state == State::MOVING || robot.state == State::WAITING;
}

/// By joint, the fastest that it is on any of its paths: pieces are boxes that contain all of a motion, so
/// that it is no faster than across one in its time.
std::vector<double> mostSpeedsOf(const cell::ArtifactRobot& robot) {
  std::vector<double> most(arm::kJointCount, 0.0);
  for (const cell::ArtifactPath& path : robot.paths) {
    for (const cell::ArtifactPiece& piece : path.pieces) {
      const double seconds = toSeconds(piece.to - piece.from);
      if (piece.kind == cell::Piece::Kind::Rest || seconds <= 0.0) continue;
      const arm::JointVector width = piece.range.upper - piece.range.lower;
      for (std::size_t joint = 0; joint < most.size(); ++joint) {
        most[joint] = std::max(most[joint], width[static_cast<Eigen::Index>(joint)] / seconds);
      }
    }
  }
  return most;
}

}  // namespace

Result<BelievedPlaces, std::vector<std::string>> BelievedPlaces::of(
    std::shared_ptr<const cell::Artifact> artifact) {
  auto model = cell::modelOf(artifact->program);
  if (!model) return refuse(model.error());
  return BelievedPlaces(std::move(artifact), std::move(*model));
}

BelievedPlaces::BelievedPlaces(std::shared_ptr<const cell::Artifact> artifact, cell::CellModel model)
    : artifact_(std::move(artifact)),
      model_(std::make_unique<const cell::CellModel>(std::move(model))),
      movers_(artifact_->program.robots.size()) {
  for (std::size_t mover = 0; mover < movers_.size(); ++mover) {
    for (const cell::CellPlace& place : model_->places[mover]) movers_[mover].places[place.name] = &place;
    if (mover >= artifact_->robots.size()) continue;  // nobody knows how fast a mechanism is
    movers_[mover].most_speeds = mostSpeedsOf(artifact_->robots[mover]);
  }
}

void BelievedPlaces::hear(const cobot_command::CellState& state, const std::string& publisher, Instant now) {
  if (isFromAnother(state, publisher)) {
    heard_another_ = now;
    if (source_ && now - source_->heard <= artifact_->parameters.lease) return;
    source_.reset();  // it is silent: the other one may take its place
  }
  if (state.hash != artifact_->digest) return;
  const std::pair number(state.epoch, state.number);
  if (source_ && number <= source_->number) return;  // late, or doubled
  source_ = Source{publisher, state.instance, number, now};
  place(state);
}

bool BelievedPlaces::isFromAnother(const cobot_command::CellState& state,
                                   const std::string& publisher) const {
  if (state.hash != artifact_->digest) return true;
  return source_ && (state.instance != source_->instance || publisher != source_->publisher);
}

void BelievedPlaces::place(const cobot_command::CellState& state) {
  for (Mover& mover : movers_) mover.place = nullptr;
  if (!arePlacesCertain(state)) return;
  for (std::size_t index = 0; index < movers_.size(); ++index) {
    const std::string& name = artifact_->program.robots[index].name;
    const auto told = std::find_if(state.robots.begin(), state.robots.end(),
                                   [&](const cobot_command::CellRobot& one) { return one.name == name; });
    if (told == state.robots.end() || !isByItsProgram(*told)) continue;
    const auto place = movers_[index].places.find(told->place);
    if (place != movers_[index].places.end()) movers_[index].place = place->second;
  }
}

std::optional<std::size_t> BelievedPlaces::indexOf(const std::string& mover) const {
  for (std::size_t index = 0; index < movers_.size(); ++index) {
    if (artifact_->program.robots[index].name == mover) return index;
  }
  return std::nullopt;
}

bool BelievedPlaces::mayCarry(const std::string& robot) const {
  const auto index = indexOf(robot);
  return index && *index < artifact_->robots.size() && !artifact_->robots[*index].parts.empty();
}

void BelievedPlaces::measured(const std::string& mover, const arm::JointVector& joints, Instant now) {
  const auto index = indexOf(mover);
  if (!index) return;
  movers_[*index].joints = joints;
  movers_[*index].measured = now;
}

std::optional<BelievedPlaces::Belief> BelievedPlaces::beliefOf(const std::string& mover, Instant now) const {
  const Duration lease = artifact_->parameters.lease;
  const auto index = indexOf(mover);
  if (!index || !source_ || (heard_another_ && now - *heard_another_ <= lease)) return std::nullopt;
  const Mover& known = movers_[*index];
  if (!known.measured) return std::nullopt;
  const Instant until = std::min(source_->heard + lease, *known.measured + kStale);
  if (now > until) return std::nullopt;
  auto parts = partsOf(*index, known);
  if (!parts) return std::nullopt;
  return Belief{std::move(*parts), {known.place->holds, known.most_speeds}, until};
}

std::optional<cell::Carried> BelievedPlaces::partsOf(cell::RobotIndex index, const Mover& mover) const {
  if (mover.place == nullptr) return std::nullopt;
  // The state may be newer than the joints by what the robot has told last, maybe several releases at once.
  cell::CellPlace place = *mover.place;
  cell::Carried parts = carriedAt(index, place);
  while (!cell::placeFits(*artifact_, index, place, mover.joints)) {
    if (place.station || place.behind == 0) return std::nullopt;
    --place.behind;
    parts.merge(carriedAt(index, place));
  }
  return parts;
}

cell::Carried BelievedPlaces::carriedAt(cell::RobotIndex index, const cell::CellPlace& place) const {
  if (index >= artifact_->robots.size()) return {};
  return cell::carriedAt(*artifact_, index, place);
}

}  // namespace cobot_command::ros_adapter
