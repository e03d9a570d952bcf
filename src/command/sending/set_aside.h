// What was interrupted: the goal that was under way, what is left of its commands, and the goals behind it.
// None of them is told of anything until they go on, and each still gets its one end here.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "board/output_board.h"
#include "queue/goal_queue.h"
#include "sending/left.h"

#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/blocks/shared/finish_after.h"
#include "cobot_command/command/actions.h"
#include "cobot_command/command/interruption.h"

namespace cobot_command::command {

/// What its goals are told of the run, and what is new of it for everybody.
/// Returns how much is left of what the run itself is for, if it has told that now.
std::optional<Duration> tellReports(blocks::Run& run, std::map<blocks::GoalId, tables::Hold>& holds,
                                    OutputBoard& board, std::vector<Action>& actions);

/// How the robot is set up otherwise than when it was interrupted; nothing: it is so.
[[nodiscard]] std::optional<blocks::Failure> differenceIn(const Setup& then, const Setup& now);

class SetAside {
 public:
  /// Both have to live longer.
  SetAside(OutputBoard& board, std::vector<Action>& actions) : board_(board), actions_(actions) {}

  // --- Interrupted, and going on.
  void put(Aside aside, PrimaryPosition position, Instant now);
  [[nodiscard]] bool isThere() const { return position_.has_value(); }
  /// Nothing unless isThere().
  [[nodiscard]] const std::optional<PrimaryPosition>& position() const { return position_; }
  /// It may go on as the robot is set up when that goal is done, whatever that was before.
  void allowSetupBehind(blocks::GoalId goal) { allowing_ = goal; }
  void ended(blocks::GoalId goal, bool done, const Setup& setup);
  /// Why it may not go on so; nothing: it may. Precondition: isThere().
  [[nodiscard]] std::optional<blocks::Failure> objectionTo(const Setup& setup) const;
  /// Nothing of it can go on.
  [[nodiscard]] bool isEmpty() const { return !aside_.run && aside_.waiting.empty() && aside_.left.empty(); }
  /// Goals that are under way (0, 1), and that wait.
  [[nodiscard]] std::size_t underWay() const { return aside_.run ? 1 : 0; }
  [[nodiscard]] std::size_t waiting() const { return aside_.waiting.size(); }
  [[nodiscard]] std::optional<blocks::Block> block() const;
  /// As it goes on now: from the place, or `behind_segment`, from the end of the motion that was interrupted.
  [[nodiscard]] Aside take(bool behind_segment, Instant now);

  // --- Meanwhile.
  /// Behind those that wait.
  void push(Waiting waiting);
  /// False: it has not that goal. The one that is under way takes those that wait with it.
  bool cancel(blocks::GoalId goal, const std::string& why, Instant now);
  /// As GoalQueue::dropBehindTurn(), and the one that is under way ends in its own time.
  int finish(blocks::FinishAfter after, const std::string& why, Instant now);
  /// All end as CommandAborted.
  void drop(const std::string& why, Instant now);
  void linkLost(const std::string& reason, Instant now);

 private:
  void tell(Waiting& waiting, int place);
  int dropWaiting(const std::string& why);
  /// `of_commands`: what the commands that it waits for ended with.
  void endRun(const blocks::Outcome& of_commands, Instant now);
  void endIfOver();

  OutputBoard& board_;
  std::vector<Action>& actions_;
  Aside aside_;
  std::optional<PrimaryPosition> position_;
  blocks::GoalId allowing_ = 0;
  std::optional<Setup> allowed_;
};

}  // namespace cobot_command::command
