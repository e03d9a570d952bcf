// What an agent has against a frame that is to leave (cell.md, M28).
#pragma once

#include <optional>

#include "agent/path_tracker.h"
#include "agent/state_watch.h"

#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/cell/artifact/artifact.h"
#include "cobot_command/command/gate.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::cell {

/// Why the supervisor lets no frame of a robot leave, as far as it was heard; `is_joined`: it has let it in.
[[nodiscard]] std::optional<std::string> objectionOf(const StateWatch& states, bool is_joined);

/// What is known at that moment; of an agent, which has to live longer.
struct FrameGate {
  const Artifact& artifact;
  RobotIndex robot;
  const StateWatch& states;
  const robot::RobotWatch& watch;
  std::optional<Instant> measured_at;  ///< the newest joints
  bool is_joined;                      ///< the supervisor has let the robot in
  const PathTracker* tracker;          ///< nullptr: the robot is on no path
  const ArtifactFrame* permitted;      ///< nullptr: no permit is open

  [[nodiscard]] std::optional<blocks::Failure> objectionTo(const command::Departure& departure,
                                                           Instant now) const;

 private:
  [[nodiscard]] std::optional<std::string> objectionOfState() const;
  [[nodiscard]] std::optional<blocks::Failure> objectionToSetting(const command::Departure& departure,
                                                                  Instant now) const;
  [[nodiscard]] std::optional<blocks::Failure> objectionToStart(const command::Departure& departure) const;
};

}  // namespace cobot_command::cell
