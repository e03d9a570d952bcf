// The sides of a run that paths, and jogs, are controlled by from outside of its goals.
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

/// How fast paths run, and could run.
struct PathPace {
  /// Of what the controller has first; nothing: it has nothing of them.
  std::optional<double> running;
  int next_point = -1;    ///< the first one that is not sent, in the array of its goal; -1: all are
  int active_point = -1;  ///< that moves the robot, or would next
  /// With which all that is not sent keeps the rated speeds of the joints.
  double highest = std::numeric_limits<double>::infinity();
  double highest_of_all = std::numeric_limits<double>::infinity();  ///< with what is sent
  bool can_restart = false;  ///< what the controller has can be taken back
  /// What was taken back is being stopped, or planned from where the robot stands.
  bool is_restarting = false;
};

/// Work that needs nothing of its run, for any thread; what it finds.
using PathWork = std::function<Detail()>;

class PathControlled {
 public:
  /// They are so now; told when its turn comes, and behind every event.
  virtual void use(const path::PathControls& controls, Instant now) = 0;
  /// What automatic tracking objects are to be switched to now, so that the next goal can load its points;
  /// nothing: they stay as they are.
  [[nodiscard]] virtual std::optional<path::TrackingFlags> wantedTracking() const = 0;
  [[nodiscard]] virtual PathPace pace() const = 0;
  /// What the controller has of it is being stopped, and has to be planned anew, with the rest, from where
  /// the robot comes to stand.
  virtual void restart() = 0;
  /// The controller has refused to enter a PVT: it makes none.
  [[nodiscard]] virtual bool isPvtRefused() const = 0;
  /// What has to be planned anew, as the feedrate is another one; asked for once. Until its answer nothing
  /// more is sent.
  [[nodiscard]] virtual std::optional<PathWork> takeReplan() = 0;
  /// The answer; none: it took too long. Returns what speaks against the new feedrate, so that what is loaded
  /// keeps its old one.
  [[nodiscard]] virtual std::optional<std::string> replanned(const Detail& found) = 0;
  /// As far as the robot has come until now.
  [[nodiscard]] virtual path::DrivenPath driven() const = 0;

 protected:
  ~PathControlled() = default;
};

/// The side of a run that is held to run by somebody outside of its goals.
class JogControlled {
 public:
  /// Somebody still holds it.
  virtual void keepAlive(Instant now) = 0;
  /// The controller has refused to take velocities: it has no licence for them.
  [[nodiscard]] virtual bool isVelocityRefused() const = 0;

 protected:
  ~JogControlled() = default;
};

}  // namespace cobot_command::blocks
