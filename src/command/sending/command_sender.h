// The commands of the goal whose turn it is, on their way to the controller: each is planned and prepared,
// sent, and remembered for as long as the robot is at it. What was taken from the controller again is sent
// before anything else.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <utility>

#include "forecast/forecast.h"
#include "runs/command_window.h"
#include "sending/left.h"
#include "sending/next_command.h"
#include "sending/trail.h"

#include "cobot_command/blocks/shared/command.h"
#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::command {

class CommandSender {
 public:
  /// Both have to live longer.
  CommandSender(NextCommand next, const Forecast& forecast, CommandWindow& window)
      : next_(std::move(next)), forecast_(forecast), window_(window) {}

  // --- The next one.
  [[nodiscard]] NextCommand::State look(const blocks::Command& command, blocks::GoalId goal, Instant now) {
    return next_.look(command, goal, now);
  }
  /// What speaks against it, last of all. Precondition: look() did not say Planning, in this event.
  [[nodiscard]] std::optional<blocks::Failure> prepare(const blocks::Command& command, Instant now);
  /// Whether it can go out now.
  struct Readiness {
    bool is_known = false;                   ///< not as long as it is held back, or planned
    std::optional<blocks::Failure> failure;  ///< what speaks against it
  };
  /// Looks and prepares, unless something speaks against it already.
  [[nodiscard]] Readiness makeReady(const blocks::Command& command, blocks::GoalId goal,
                                    std::optional<blocks::Failure> objection, Instant now);
  /// What is planned of it is made anew when it goes on, with all the time that a plan has.
  Readiness holdBack();
  /// That it is told by. Precondition: it is prepared.
  [[nodiscard]] int acknowledgedId() { return next_.order().command_id_ack; }
  /// Precondition: it is prepared.
  /// `is_resumed`: behind an interruption, by what is left of it on the trail.
  void send(const blocks::Command& command, blocks::GoalId goal, bool is_resumed, Instant now);
  /// What was planned of it.
  void forget() { next_.forget(); }

  // --- What went out.
  void see(const robot::RobotWatch& robot, Instant now);
  void ended(const CommandWindow::Ended& ended);
  /// The robot stands, and nothing is left in its queue.
  void queueDone() { trail_.clear(); }
  /// The robot may still be at something of it.
  [[nodiscard]] bool hasSent() const { return !trail_.empty(); }
  /// Why what the robot is at could not be taken up again on its way; nothing: it could.
  [[nodiscard]] std::optional<std::string> objectionToResuming() const;
  /// What of it is left. Precondition: objectionToResuming() is nothing, and the robot stands.
  [[nodiscard]] std::deque<Left> takeLeft();

  // --- What nobody is told of: what was taken from the controller, and what tells the end of motions.
  /// Has the controller tell, by a script that is a tag alone, when all that it has has come to its end.
  void askForRest();
  void goOnWith(std::deque<Left> left);
  [[nodiscard]] bool goesOn() const { return !left_.empty(); }
  /// The first of it. Precondition: goesOn().
  [[nodiscard]] const Left& left() const { return left_.front(); }
  /// The first one was sent, or never will be.
  void leftDone() { left_.pop_front(); }
  [[nodiscard]] std::deque<Left> dropLeft() { return std::exchange(left_, {}); }
  /// Of a command that nobody is told of any more.
  [[nodiscard]] static bool isNobodys(blocks::CommandKey key) {
    return key >= kNobodysFirst && key - kNobodysFirst < kNobodysFirst;
  }

 private:
  /// Runs count theirs from below, and have single ones at the very end.
  static constexpr blocks::CommandKey kNobodysFirst = blocks::CommandKey{1} << 62U;

  NextCommand next_;
  const Forecast& forecast_;
  CommandWindow& window_;
  Trail trail_;
  std::deque<Left> left_;
  blocks::CommandKey nobodys_ = kNobodysFirst;
};

}  // namespace cobot_command::command
