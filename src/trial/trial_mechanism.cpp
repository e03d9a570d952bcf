#include "cobot_command/trial/trial_mechanism.h"

#include <algorithm>
#include <cmath>

namespace cobot_command::trial {
namespace {

constexpr Duration kAdvancedEvery = std::chrono::milliseconds(20);
/// Of one whose file does not say how long its paths take.
constexpr double kUsualDuration = 3.0;  // [s]

/// The slowest of its paths: it has one speed.
double speedOf(const cell::ArtifactMechanism& made, const cell::RobotProgram& program) {
  double slowest = 0.0;
  for (std::size_t path = 0; path < made.paths.size(); ++path) {
    const double length =
        std::abs(made.stations[program.paths[path].to].value - made.stations[program.paths[path].from].value);
    const double seconds = made.paths[path].duration ? toSeconds(*made.paths[path].duration) : 0.0;
    const double speed = length / (seconds > 0.0 ? seconds : kUsualDuration);
    slowest = slowest == 0.0 ? speed : std::min(slowest, speed);
  }
  return slowest;
}

}  // namespace

TrialMechanism::TrialMechanism(std::shared_ptr<const cell::Artifact> artifact, std::size_t mechanism,
                               std::uint64_t session)
    : speed_(speedOf(artifact->mechanisms[mechanism],
                     artifact->program.robots[artifact->robots.size() + mechanism])) {
  const cell::RobotProgram& program = artifact->program.robots[artifact->robots.size() + mechanism];
  position_ = artifact->mechanisms[mechanism].stations[program.home].value;
  target_ = position_;
  agent_ = *cell::MechanismAgent::of(std::move(artifact), program.name, session);
}

void TrialMechanism::hear(const cell::CellStatus& state, std::uint64_t number, Instant now) {
  agent_->hear(state, number, now);
}

void TrialMechanism::advanceTo(Instant now) {
  if (advanced_at_ && now < *advanced_at_ + kAdvancedEvery) return;
  const double farthest = advanced_at_ ? speed_ * toSeconds(now - *advanced_at_) : 0.0;
  advanced_at_ = now;
  target_ = agent_->target().value_or(target_);
  const double way = target_ - position_;
  const double moved = std::clamp(way, -farthest, farthest);
  position_ += moved;
  agent_->measure(position_, moved != 0.0 && moved != way, now);
}

Instant TrialMechanism::nextEvent() const {
  return advanced_at_ ? *advanced_at_ + kAdvancedEvery : Instant{};
}

}  // namespace cobot_command::trial
