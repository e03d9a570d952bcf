// One mechanism of a trial: its agent, and an axis that moves to the target that the agent permits.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "cobot_command/cell/agent/mechanism_agent.h"
#include "cobot_command/cell/artifact/artifact.h"

namespace cobot_command::trial {

class TrialMechanism {
 public:
  /// Starts at its home. Precondition: the artifact has that mechanism.
  TrialMechanism(std::shared_ptr<const cell::Artifact> artifact, std::size_t mechanism,
                 std::uint64_t session);

  /// Starts its program.
  void run() { agent_->run(true); }
  void stop() { agent_->stop(); }
  void hear(const cell::CellStatus& state, std::uint64_t number, Instant now);
  [[nodiscard]] std::optional<cell::RobotReport> takeReport(Instant now) { return agent_->takeReport(now); }
  /// Moves the axis until then, and measures its position.
  void advanceTo(Instant now);
  /// The time of its next action, if nothing else happens before.
  [[nodiscard]] Instant nextEvent() const;

  [[nodiscard]] double position() const { return position_; }  ///< [m or rad]
  [[nodiscard]] const cell::MechanismAgent& agent() const { return *agent_; }

 private:
  std::unique_ptr<cell::MechanismAgent> agent_;
  double speed_;  ///< [m/s or rad/s]
  double position_ = 0.0;
  double target_ = 0.0;
  std::optional<Instant> advanced_at_;
};

}  // namespace cobot_command::trial
