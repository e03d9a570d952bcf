#include "cell_watch/carried_parts.h"

#include <algorithm>

#include "cobot_command/cell/artifact/place_fit.h"
#include "cobot_command/cell/artifact/place_parts.h"
#include "cobot_command/cell/monitor/monitor.h"

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

}  // namespace

Result<CarriedParts, std::vector<std::string>> CarriedParts::of(
    std::shared_ptr<const cell::Artifact> artifact) {
  auto model = cell::modelOf(artifact->program);
  if (!model) return refuse(model.error());
  return CarriedParts(std::move(artifact), std::move(*model));
}

CarriedParts::CarriedParts(std::shared_ptr<const cell::Artifact> artifact, cell::CellModel model)
    : artifact_(std::move(artifact)),
      model_(std::make_unique<const cell::CellModel>(std::move(model))),
      robots_(artifact_->robots.size()) {
  for (std::size_t robot = 0; robot < robots_.size(); ++robot) {
    for (const cell::CellPlace& place : model_->places[robot]) robots_[robot].places[place.name] = &place;
  }
}

void CarriedParts::hear(const cobot_command::CellState& state, const std::string& publisher, Instant now) {
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

bool CarriedParts::isFromAnother(const cobot_command::CellState& state, const std::string& publisher) const {
  if (state.hash != artifact_->digest) return true;
  return source_ && (state.instance != source_->instance || publisher != source_->publisher);
}

void CarriedParts::place(const cobot_command::CellState& state) {
  for (Robot& robot : robots_) robot.place = nullptr;
  if (!arePlacesCertain(state)) return;
  for (std::size_t index = 0; index < robots_.size(); ++index) {
    const std::string& name = artifact_->program.robots[index].name;
    const auto told = std::find_if(state.robots.begin(), state.robots.end(),
                                   [&](const cobot_command::CellRobot& one) { return one.name == name; });
    if (told == state.robots.end() || !isByItsProgram(*told)) continue;
    const auto place = robots_[index].places.find(told->place);
    if (place != robots_[index].places.end()) robots_[index].place = place->second;
  }
}

std::optional<std::size_t> CarriedParts::indexOf(const std::string& robot) const {
  for (std::size_t index = 0; index < robots_.size(); ++index) {
    if (artifact_->program.robots[index].name == robot) return index;
  }
  return std::nullopt;
}

bool CarriedParts::mayCarry(const std::string& robot) const {
  const auto index = indexOf(robot);
  return index && !artifact_->robots[*index].parts.empty();
}

void CarriedParts::measured(const std::string& robot, const arm::JointVector& joints, Instant now) {
  const auto index = indexOf(robot);
  if (!index) return;
  robots_[*index].joints = joints;
  robots_[*index].measured = now;
}

std::optional<CarriedParts::Belief> CarriedParts::beliefOf(const std::string& robot, Instant now) const {
  const Duration lease = artifact_->parameters.lease;
  const auto index = indexOf(robot);
  if (!index || !source_ || (heard_another_ && now - *heard_another_ <= lease)) return std::nullopt;
  const Robot& known = robots_[*index];
  if (!known.measured) return std::nullopt;
  const Instant until = std::min(source_->heard + lease, *known.measured + kStale);
  if (now > until) return std::nullopt;
  auto parts = partsOf(*index, known);
  return parts ? std::optional(Belief{std::move(*parts), until}) : std::nullopt;
}

std::optional<cell::Carried> CarriedParts::partsOf(cell::RobotIndex index, const Robot& robot) const {
  if (robot.place == nullptr) return std::nullopt;
  // The state may be newer than the joints by what the robot has told last, maybe several releases at once.
  cell::CellPlace place = *robot.place;
  cell::Carried parts = cell::carriedAt(*artifact_, index, place);
  while (!cell::placeFits(*artifact_, index, place, robot.joints)) {
    if (place.station || place.behind == 0) return std::nullopt;
    --place.behind;
    parts.merge(cell::carriedAt(*artifact_, index, place));
  }
  return parts;
}

}  // namespace cobot_command::ros_adapter
