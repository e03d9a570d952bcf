// The feedrate of paths: changed for what is not sent yet, and at 0 by a Pause() for what the controller has.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "paths/path_desk.h"
#include "paths/path_turn.h"
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
    CommandWindow& window;
    Forecast& forecast;
    robot::RobotWatch& robot;
    std::vector<Action>& actions;
    /// Why nothing can be sent to the controller.
    std::function<std::vector<blocks::Failure>()> objections;
  };
  explicit FeedrateDesk(Core core) : core_(std::move(core)) {}

  void set(const FeedrateRequest& request, const FeedrateReply& reply, Instant now);
  /// Somebody else pauses the project, too: that is his to end.
  void pausedByOthers() { others_pause_ = hold_ != Hold::None; }

  /// A Pause() or Resume() of this desk has ended: what was sent beside for no goal.
  void ended(const CommandWindow::Ended& ended);
  /// The project may have been let go by others, or stopped.
  void robotChanged();
  /// Whether the project is paused behind the next link nobody knows here; paths wait all the same.
  void linkLost() { forget(); }

 private:
  /// Of the pause that this desk has asked for; with no answer yet: Pausing, Resuming.
  enum class Hold { None, Pausing, Paused, Resuming };
  struct Waiting {
    blocks::CommandKey key = 0;
    FeedrateReply reply;
    FeedrateAnswer answer;  ///< when the controller takes it
    bool restarts = false;
  };

  void stop(const blocks::PathPace& pace, Waiting waiting, Instant now);
  void letGo(const blocks::PathPace& pace, double feedrate, Waiting waiting, Instant now);
  void restart(const blocks::PathPace& pace, double feedrate, Waiting waiting, Instant now);
  /// Pausing or Resuming from now on.
  void send(Hold hold, Waiting waiting, Instant now);
  void changeTo(Hold hold);
  /// Why the robot stands all the same; empty: nothing is known that holds it.
  [[nodiscard]] std::string heldByOthers() const;
  void forget();

  Core core_;
  std::vector<Waiting> waiting_;
  blocks::CommandKey last_ = 0;  ///< of what was sent last, whose answer counts
  Hold hold_ = Hold::None;
  bool seen_ = false;          ///< the status stream has shown that pause
  bool others_pause_ = false;  ///< the same project, behind that
};

}  // namespace cobot_command::command
