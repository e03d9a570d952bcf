// Interfaces of a run by which paths and jogs are controlled from outside their goals.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>

#include "cobot_command/blocks/shared/detail.h"
#include "cobot_command/common/time.h"
#include "cobot_command/path/driven_path.h"
#include "cobot_command/path/path_controls.h"

namespace cobot_command::blocks {

/// Feedrate of paths (1: 100 %): present and possible.
struct PathPace {
  /// Of the first motion that the controller has; nullopt: it has none.
  std::optional<double> running;
  int next_point = -1;    ///< first point that is not sent, in the array of its goal; -1: all are sent
  int active_point = -1;  ///< point that moves the robot, or will do so next
  /// Highest feedrate with which all points that are not sent keep the rated speeds of the joints.
  double highest = std::numeric_limits<double>::infinity();
  double highest_of_all = std::numeric_limits<double>::infinity();  ///< the same, including sent points
  bool can_restart = false;  ///< the motions of the controller can be withdrawn
  /// The withdrawn motions are being stopped, or planned from the position of the robot.
  bool is_restarting = false;
};

/// Work that needs nothing of its run, for any thread; returns what it found.
using PathWork = std::function<Detail()>;

class PathControlled {
 public:
  /// These controls apply now; called at the turn of the run, and after every event.
  virtual void use(const path::PathControls& controls, Instant now) = 0;
  /// The states to which automatic tracking objects must be switched now, so that the next goal can load its
  /// points; nullopt: they stay as they are.
  [[nodiscard]] virtual std::optional<path::TrackingFlags> wantedTracking() const = 0;
  [[nodiscard]] virtual PathPace pace() const = 0;
  /// The motions that the controller has are being stopped. They must be planned again, with the rest, from
  /// where the robot stops.
  virtual void restart() = 0;
  /// The controller has refused to enter a PVT: it executes none.
  [[nodiscard]] virtual bool isPvtRefused() const = 0;
  /// The work of planning again after a change of the feedrate; returned once. Nothing more is sent until
  /// replanned().
  [[nodiscard]] virtual std::optional<PathWork> takeReplan() = 0;
  /// The answer to takeReplan(); none: it took too long. Returns the objection to the new feedrate: what is
  /// loaded then keeps its old one.
  [[nodiscard]] virtual std::optional<std::string> replanned(const Detail& found) = 0;
  /// The path that the robot has driven up to now.
  [[nodiscard]] virtual path::DrivenPath driven() const = 0;

 protected:
  ~PathControlled() = default;
};

/// The interface of a run that runs only while an operator or client holds it (hold to run).
class JogControlled {
 public:
  /// A keep-alive was received.
  virtual void keepAlive(Instant now) = 0;
  /// The controller has refused velocities: it has no licence for them.
  [[nodiscard]] virtual bool isVelocityRefused() const = 0;

 protected:
  ~JogControlled() = default;
};

}  // namespace cobot_command::blocks
