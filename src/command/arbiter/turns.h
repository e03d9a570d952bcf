// Whose turn it is: one run at a time is under way, and as many of its commands are at the controller as it
// says. Blended motions end with their acceptance, so the next one goes out while they still run.
#pragma once

#include <optional>
#include <string>

#include "arbiter/admission.h"
#include "arbiter/core_parts.h"
#include "arbiter/goal_plans.h"
#include "arbiter/occupancy.h"
#include "arbiter/stop_desk.h"
#include "paths/path_turn.h"
#include "queue/goal_queue.h"
#include "runs/command_window.h"
#include "sending/command_sender.h"

#include "cobot_command/blocks/shared/finish_after.h"
#include "cobot_command/blocks/shared/goal_values.h"
#include "cobot_command/blocks/shared/run.h"

namespace cobot_command::command {

class Turns {
 public:
  /// All have to live longer. `frames`: see CommandCore.
  Turns(const CoreParts& parts, const ArbiterDesks& desks, blocks::FrameFinder frames);

  /// The goal whose turn it is; nullptr: none.
  [[nodiscard]] const blocks::Run* run() const { return under_way_.run.get(); }
  [[nodiscard]] const Occupancy& occupancy() const { return occupancy_; }

  /// Begins what can begin.
  void dispatch(Instant now);
  /// Tells the goal what became of its commands, and ends it when it has ended.
  void settle(Instant now);
  /// Ends as CommandAborted, with a stop when it moves.
  void cancel(const std::string& why, Instant now);
  /// The same, now.
  void abandon(const std::string& why, Instant now);
  /// One goal of the run whose turn it is: alone, where nothing has to be stopped for that.
  [[nodiscard]] bool takeOut(blocks::GoalId goal, const std::string& why, Instant now);
  void finish(blocks::FinishAfter after, Instant now);
  /// With what waits, as CommandAborted; `newest`: see GoalQueue::dropAll().
  void abortAll(const std::string& why, blocks::GoalId newest, Instant now);
  /// The same, with a stop whatever there is.
  void stopAll(const std::string& why, blocks::GoalId newest, Instant now);
  void tellPlaces();

  // --- An interruption: what is under way is taken from the controller, to go on later.
  [[nodiscard]] const CommandSender& sender() const { return sender_; }
  /// Nothing is begun any more, until it is set aside or has ended for another reason.
  void stopForLater(const std::string& why, Instant now);
  [[nodiscard]] bool isStoppingForLater() const { return stops_for_later_; }
  [[nodiscard]] bool hasStoppedForLater() const;
  /// All that is under way and waits. Precondition: hasStoppedForLater().
  [[nodiscard]] Aside takeAside(Instant now);
  /// Precondition: nothing is under way, and nothing waits.
  void putBack(Aside aside, Instant now);
  /// A goal is under way, or what was taken from the controller is still to be sent.
  [[nodiscard]] bool isAnythingThere() const { return under_way_.run || sender_.goesOn(); }

  void queueDone() { sender_.queueDone(); }
  void stopEnded(const StopRun::Result& result, Instant now);
  void linkLost(const std::string& reason, Instant now);
  void robotChanged(Instant now);
  void advance(Instant now);
  [[nodiscard]] std::optional<Instant> nextDeadline() const;

 private:
  bool continueRun(Instant now);
  /// The same of what was taken from the controller.
  bool continueLeft(Instant now);
  /// Of a command that nobody is told of any more.
  void endNobodys(const CommandWindow::Ended& ended, Instant now);
  void refuseLeft(const Left& left, const blocks::Failure& failure, Instant now);
  /// What of it the run waits for ends so.
  void endLeft(const blocks::Outcome& outcome, Instant now);
  void interrupt(const std::string& why, Instant now);
  void cancelWindow(const std::string& why, Instant now);
  /// Its last command was blended and is done, but moves the robot still; the next one is not out yet.
  [[nodiscard]] bool isBetweenCommands() const;
  void stopBetweenCommands(const std::string& why, Instant now);
  void endCommand(CommandWindow::Ended ended, Instant now);
  void endRun(Instant now);

  CoreParts parts_;
  ArbiterDesks desks_;
  UnderWay under_way_;
  Occupancy occupancy_;
  CommandSender sender_;
  Admission admission_;
  /// A cancel of it between two commands: the stop that it waits for, and why.
  struct Stopping {
    StopRun::Number stop = 0;
    std::string why;
  };
  std::optional<Stopping> stopping_;
  bool stops_for_later_ = false;
  /// A command that the run waits for, and that nothing is at the controller of: stopped to go on later, or
  /// not sent again yet when it was cancelled, with others of its chain in front of it.
  struct Untold {
    blocks::CommandKey key = 0;
    blocks::Block block{};
  };
  std::optional<Untold> kept_;
  std::optional<Untold> owed_;
  bool finishes_behind_motion_ = false;  ///< it was to be finished between two commands
};

}  // namespace cobot_command::command
