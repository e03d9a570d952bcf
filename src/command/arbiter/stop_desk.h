// Who has the robot stopped, and what holds commands back: stops, whoever asked for them, and motions that no
// goal answers for.
#pragma once

#include <optional>
#include <string>

#include "arbiter/core_parts.h"
#include "runs/command_window.h"
#include "stops/stop_goals.h"
#include "stops/stop_run.h"

#include "cobot_command/robot/orphan_watch.h"

namespace cobot_command::command {

class StopDesk {
 public:
  /// `window`: what a stop ends. All have to live longer.
  StopDesk(const CoreParts& parts, StopRun& run, const CommandWindow& window)
      : parts_(parts), run_(run), window_(window), goals_(parts.board) {}

  void ask(Instant now);
  /// For motions that no goal waits for any more.
  void askIfMoving(Instant now);
  /// Whose stop that is which was asked for last. Precondition: accept() was called for it.
  void accept(blocks::GoalId goal) { goals_.accept(goal); }
  void answerWithTheLast(blocks::GoalId goal) { goals_.wait(goal, run_.last()); }
  /// That was asked for last.
  [[nodiscard]] StopRun::Number last() const { return run_.last(); }
  void abortGoals(const std::string& why) { goals_.abort(why); }
  /// A stop that has ended, with what that means for robot and forecast.
  [[nodiscard]] std::optional<StopRun::Result> takeResult(Instant now);

  [[nodiscard]] bool busy() const { return run_.busy(); }
  /// The stop block does.
  [[nodiscard]] bool executes() const { return !goals_.empty(); }
  /// Something may move, or be queued, that is not of what runs here: blended, from before, or another
  /// client's. Nobody can tell that of a robot that is not seen to stand.
  [[nodiscard]] bool mayMoveOtherwise() const;
  /// The robot may move, and no goal answers for it: nothing may queue behind that unseen.
  [[nodiscard]] bool holdsBack() const;
  [[nodiscard]] std::string heldBackBy() const;

  // --- A motion from before this connection: whoever commands has to know of it.
  [[nodiscard]] const robot::OrphanWatch& orphan() const { return orphan_; }
  void commanded() { orphan_.fire(robot::OrphanEvent::Commanded); }
  void watchOrphan(Instant now);

 private:
  void confirmed(const StopRun::Result& result);
  void failed(const StopRun::Result& result, Instant now);
  void warn(std::string text);

  CoreParts parts_;
  StopRun& run_;
  const CommandWindow& window_;
  StopGoals goals_;
  robot::OrphanWatch orphan_;
};

}  // namespace cobot_command::command
