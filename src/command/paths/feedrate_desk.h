// The feedrate of paths: changed for what is not sent yet, and at 0 by a Pause() for what the controller has.
#pragma once

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
  /// All have to live longer.
  FeedrateDesk(PathDesk& desk, const PathTurn& turn, CommandWindow& window, robot::RobotWatch& robot,
               std::vector<Action>& actions)
      : desk_(desk), turn_(turn), window_(window), robot_(robot), actions_(actions) {}

  void set(const FeedrateRequest& request, const FeedrateReply& reply, Instant now);

  /// A Pause() or Resume() of this desk has ended: what was sent beside for no goal.
  void ended(const CommandWindow::Ended& ended);
  /// The project may have been let go by others.
  void robotChanged();
  void linkLost();

 private:
  struct Waiting {
    blocks::CommandKey key = 0;
    FeedrateReply reply;
    FeedrateAnswer answer;  ///< when the controller takes it
  };

  void stop(const blocks::PathPace& pace, Waiting waiting, Instant now);
  void letGo(const blocks::PathPace& pace, double feedrate, Waiting waiting, Instant now);
  void send(script::ScriptCommand command, Waiting waiting, Instant now);
  /// The project is paused by this desk, as the controller has told.
  void setPaused(bool paused);

  PathDesk& desk_;
  const PathTurn& turn_;
  CommandWindow& window_;
  robot::RobotWatch& robot_;
  std::vector<Action>& actions_;
  std::vector<Waiting> waiting_;
  blocks::CommandKey last_ = 0;  ///< odd: a Pause(), even: a Resume()
  bool asked_ = false;           ///< a Pause() was sent, and no Resume() behind it
  bool paused_ = false;
  bool seen_ = false;  ///< the status stream has shown that pause
};

}  // namespace cobot_command::command
