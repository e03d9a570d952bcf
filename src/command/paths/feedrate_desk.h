// The feedrate of paths: changed for what is not sent yet, and at 0 by a Pause() for what the controller has.
#pragma once

#include <cstdint>

#include "forecast/forecast.h"
#include "paths/path_desk.h"
#include "paths/path_turn.h"
#include "paths/pause_desk.h"
#include "runs/command_window.h"

#include "cobot_command/command/path_requests.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::command {

class FeedrateDesk {
 public:
  /// What it uses of the core; all have to live longer.
  struct Core {
    PathDesk& desk;
    PathTurn& turn;
    PauseDesk& pause;
    CommandWindow& window;
    Forecast& forecast;
    const robot::RobotWatch& robot;
  };
  explicit FeedrateDesk(const Core& core) : core_(core) {}

  void set(const FeedrateRequest& request, const FeedrateReply& reply, Instant now);

 private:
  struct Waiting {
    FeedrateReply reply;
    FeedrateAnswer answer;  ///< when the controller takes it
    bool restarts = false;
  };

  void stop(const blocks::PathPace& pace, Waiting waiting, Instant now);
  void letGo(const blocks::PathPace& pace, double feedrate, Waiting waiting, Instant now);
  void restart(const blocks::PathPace& pace, double feedrate, Waiting waiting, Instant now);
  static void answerTo(const Waiting& waiting, const PauseDesk::Answer& answer, bool replaces);

  Core core_;
  std::uint64_t requests_ = 0;  ///< to stop or to go on, whatever became of them
};

}  // namespace cobot_command::command
