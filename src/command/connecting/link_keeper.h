// The connection to a controller: by the connect block, or kept by itself while no goal asks for one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "board/output_board.h"
#include "connecting/connect_run.h"
#include "links/links.h"

#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::command {

class LinkKeeper {
 public:
  /// All have to live longer.
  LinkKeeper(const link::LinkSettings& settings, Links& links, const robot::RobotWatch& robot,
             OutputBoard& board)
      : script_(links.script()), run_(settings, links.script(), links.status(), robot, board) {}

  /// What the connect block executes.
  [[nodiscard]] ConnectRun& run() { return run_; }
  [[nodiscard]] const ConnectRun& run() const { return run_; }

  /// It takes commands, and could carry them out: no emergency stop, and no error of the controller.
  [[nodiscard]] bool isRobotEnabled(const robot::RobotWatch& robot) const {
    return run_.ready() && !robot.emergencyStop() && !robot.showsError();
  }

  // --- Why not; empty: nothing speaks against it.
  /// `user`: what uses the link that there is; `may_move`: its robot, though no goal waits for that.
  [[nodiscard]] std::vector<blocks::Failure> objectionsTo(const blocks::ConnectGoal& goal,
                                                          const std::optional<blocks::Block>& user,
                                                          bool may_move) const;
  /// Nothing that the controller would take can be sent.
  [[nodiscard]] std::vector<blocks::Failure> objectionsToCommands() const;
  /// Not even a try can be made, for what must never be held back: there is no connection.
  [[nodiscard]] std::vector<blocks::Failure> objectionsToATry() const;

  void execute(blocks::GoalId id, const blocks::ConnectGoal& goal, Instant now);
  void cancel(Instant now);
  /// As long as no connect goal is Busy, and none was cancelled: who disconnects means it.
  void keep(const blocks::ConnectGoal& target);
  void keepNoMore() { kept_.reset(); }
  /// Opens again what is to be kept. True when there was something to do.
  bool keepOn(Instant now);

  /// The link was lost with a motion under way.
  void leftMoving() { left_moving_ = run_.target(); }
  /// Of a robot that may move, and that no link can stop; empty: there is none, as far as is known.
  [[nodiscard]] std::string textOfTheRobotLeft() const;
  /// That robot is in reach again.
  void lookForTheRobotLeft();
  /// By a connect goal that was cancelled, and no other has come since.
  [[nodiscard]] bool endedByCancel() const { return cancelled_ && !run_.busy(); }
  [[nodiscard]] std::string diagnosis() const;

 private:
  const link::ScriptLink& script_;
  ConnectRun run_;
  std::optional<blocks::ConnectGoal> kept_;
  bool cancelled_ = false;  ///< while there was something to keep
  std::optional<blocks::ConnectGoal> left_moving_;
};

}  // namespace cobot_command::command
