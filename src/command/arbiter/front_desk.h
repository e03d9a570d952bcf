// What becomes of a goal that comes: checked, then refused or taken, each by the way that its block says. Of
// the blocks it knows only those that make, rule and end everything else.
#pragma once

#include <vector>

#include "arbiter/core_parts.h"
#include "arbiter/turns.h"
#include "paths/pause_desk.h"

namespace cobot_command::command {

class FrontDesk {
 public:
  /// All have to live longer.
  FrontDesk(const CoreParts& parts, const ArbiterDesks& desks, Turns& turns, PauseDesk& pause)
      : parts_(parts), desks_(desks), turns_(turns), pause_(pause) {}

  /// Executes it, has it wait, or ends it.
  void take(blocks::GoalId id, const blocks::Goal& goal, Instant now);

 private:
  void connect(blocks::GoalId id, const blocks::Goal& goal, Instant now);
  void stopOnRequest(blocks::GoalId id, const blocks::Goal& goal, Instant now);
  /// What goes out beside all others has a path of its own to the wire.
  void sendBeside(blocks::GoalId id, const blocks::Goal& goal, Instant now);
  /// Planned from where the robot will be, and answered.
  void answerByPlan(blocks::GoalId id, const blocks::Goal& goal, Instant now);
  void queueUp(blocks::GoalId id, const blocks::Goal& goal, const blocks::GoalTraits& traits, Instant now);
  void enqueue(blocks::GoalId id, const blocks::Goal& goal, blocks::BufferMode mode, Instant now);
  /// True when there are any: then it has ended with them.
  bool rejected(blocks::GoalId id, const blocks::Goal& goal, const std::vector<blocks::Failure>& failures);

  CoreParts parts_;
  ArbiterDesks desks_;
  Turns& turns_;
  PauseDesk& pause_;
  blocks::GoalId last_stop_ = 0;  ///< what was received before it begins nothing any more
};

}  // namespace cobot_command::command
