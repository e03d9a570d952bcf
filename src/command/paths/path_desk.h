// What paths are controlled by from outside of their goals: kept, changed and told.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/blocks/connect.h"
#include "cobot_command/blocks/shared/path_controlled.h"
#include "cobot_command/command/actions.h"
#include "cobot_command/command/path_requests.h"
#include "cobot_command/command/speed_override.h"
#include "cobot_command/path/driven_path.h"
#include "cobot_command/path/path_controls.h"

namespace cobot_command::command {

class PathDesk {
 public:
  /// Both have to live longer.
  PathDesk(const SpeedOverride& speed, std::vector<Action>& actions) : speed_(speed), actions_(actions) {}

  /// As they were set.
  [[nodiscard]] const path::PathControls& controls() const { return controls_; }
  /// As paths are planned and sent: the speed override counts for them, too.
  [[nodiscard]] path::PathControls served() const;
  /// Nothing: it is so now; else why not.
  [[nodiscard]] std::optional<std::string> switchTracking(const TrackingSwitch& request);
  void setFeedrate(double feedrate);
  void stop(bool stopped);
  void hold(bool held);
  /// The controller makes no PVT, by what it has said since the link was made.
  [[nodiscard]] bool isPvtRefused() const { return pvt_refused_; }
  void disconnected() { pvt_refused_ = false; }
  /// Tells a run how it is controlled now, behind every event; what it wants of automatic objects, it gets.
  void serve(blocks::PathControlled& run, Instant now);

  // --- The way that the robot has driven of the last path that moved it.
  /// That run, on that controller, is over, or set aside.
  void leave(const blocks::PathControlled& run, const blocks::ConnectGoal& controller);
  /// The robot was brought to there, along the way.
  void bringTo(Duration place);
  /// nullptr: none is remembered of that controller.
  [[nodiscard]] std::shared_ptr<const path::DrivenPath> driven(const blocks::ConnectGoal& controller) const;

 private:
  void switchAutomatic(const path::TrackingFlags& wanted);
  void use(const path::PathControls& controls);

  const SpeedOverride& speed_;
  std::vector<Action>& actions_;
  path::PathControls controls_;
  bool pvt_refused_ = false;
  std::shared_ptr<const path::DrivenPath> driven_;
  blocks::ConnectGoal driven_on_;
};

}  // namespace cobot_command::command
