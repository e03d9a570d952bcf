// The goals that wait for their turn, in their order, and what falls with whom.
//
// They wait here, not in the controller: there, nothing could be taken out of the queue again.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "board/output_board.h"
#include "forecast/plan.h"
#include "forecast/plan_desk.h"

#include "cobot_command/command/actions.h"
#include "cobot_command/command/waiting_goals.h"
#include "cobot_command/tables/table_store.h"

namespace cobot_command::command {

/// Counts up, in the order in which goals come.
using Ticket = std::uint64_t;

/// A goal that was checked, and is not on the wire yet.
struct Waiting {
  /// Its turn has come once it is planned, in front of its first command.
  enum class Turn { NotYet, PlansCommand, PlansWhole };

  blocks::GoalId id = 0;
  blocks::Goal goal;
  Ticket ticket = 0;
  bool takes_over = false;    ///< once the stop that is under way for it is confirmed
  int told_place = 0;         ///< in the queue, as last reported; 0: not yet
  std::optional<Origin> end;  ///< where it will leave the robot, as far as that can be foreseen
  Turn turn = Turn::NotYet;
  std::optional<blocks::Outcome> found;  ///< when it was planned as a whole
  tables::Hold hold = nullptr;           ///< on the entries that its plan was made with
};

class GoalQueue {
 public:
  /// All have to live longer. `newest`: see CommandCore; may be empty.
  GoalQueue(OutputBoard& board, PlanDesk& plans, std::vector<Action>& actions, NewestGoal newest)
      : board_(board), plans_(plans), actions_(actions), newest_(std::move(newest)) {}

  /// A goal was submitted, of whatever kind.
  void came(blocks::GoalId id) {
    newest_submitted_ = std::max(newest_submitted_, id);
    ++last_ticket_;
  }
  [[nodiscard]] Ticket lastTicket() const { return last_ticket_; }
  /// The newest that has come anywhere.
  [[nodiscard]] blocks::GoalId newest() const { return newest_ ? newest_() : newest_submitted_; }

  [[nodiscard]] bool empty() const { return waiting_.empty(); }
  [[nodiscard]] std::size_t size() const { return waiting_.size(); }
  /// As motionsOf() counts them.
  [[nodiscard]] int motions() const;
  /// Precondition of all three: not empty.
  [[nodiscard]] Waiting& front() { return waiting_.front(); }
  [[nodiscard]] const Waiting& front() const { return waiting_.front(); }
  [[nodiscard]] const Waiting& back() const { return waiting_.back(); }
  [[nodiscard]] Waiting* find(blocks::GoalId id);
  /// The last one with an earlier ticket; nullptr: none waits.
  [[nodiscard]] const Waiting* lastBefore(Ticket ticket) const;
  /// The first one is planned, as its turn has come.
  [[nodiscard]] bool plansTheNext() const { return !empty() && front().turn != Waiting::Turn::NotYet; }

  /// The goal that came last.
  void push(Waiting waiting);
  /// It is its turn. Precondition: not empty.
  [[nodiscard]] Waiting take();
  /// The one that came last. Precondition: not empty.
  [[nodiscard]] Waiting takeLast();
  /// What was planned of the first one, as its turn seemed to have come, does not hold any more.
  void forgetTurn();
  /// The same, but for one that is a single command: whose plan that is, is asked for each time.
  void forgetWholePlan();
  /// All of them, to wait elsewhere: nothing that was planned of them holds any more.
  [[nodiscard]] std::deque<Waiting> takeAll();
  /// In front of those that wait.
  void putBackAll(std::deque<Waiting> waiting);
  /// One that was taken is the first again.
  void putBack(Waiting waiting) { waiting_.push_front(std::move(waiting)); }
  /// When it waits: one goal, that was cancelled, and what was to join its chain behind it.
  bool drop(blocks::GoalId id, const std::string& why);
  /// Those of that block that are the first ones.
  void dropFirst(blocks::Block block, const std::string& why);
  /// It cannot be made. Precondition: it waits.
  void refuse(blocks::GoalId id, blocks::Outcome refusal);
  /// All up to `newest`, the last that had come when `why` did, those that wait in front of the core too.
  void dropAll(const std::string& why, blocks::GoalId newest);
  /// The same but for the one that is about to be sent. Returns how many have ended here.
  int dropBehindTurn(const std::string& why, blocks::GoalId newest);
  /// With all that came until now, as nobody can know yet what makes them fall.
  void dropAll(const std::string& why) { dropAll(why, newest()); }
  /// Behind a stop that was not confirmed: all, and a take-over, which waited for it, fails.
  void dropUnstopped(const std::string& why);
  /// Why a goal that comes now fell before it came; nothing: it did not.
  [[nodiscard]] std::optional<std::string> fell(blocks::GoalId id, const blocks::Goal& goal) const;
  /// Of a goal that was taken out.
  void forgetPlan(blocks::GoalId id) { plans_.drop(id); }
  /// What was foreseen for those that wait stands on what was in front of them.
  void forgetForecasts();
  /// What they wait for is another thing now.
  void retell() { retells_ = true; }
  /// To each whose place is another one, but for the one that is about to be sent; `text`: for people.
  void tellPlaces(const std::function<std::string(int place)>& text);

 private:
  [[nodiscard]] std::deque<Waiting>::iterator at(blocks::GoalId id);
  [[nodiscard]] std::optional<Waiting> takeFirstIf(bool (*is_meant)(const Waiting&));
  void end(const std::deque<Waiting>::iterator& waiting, blocks::Outcome outcome);

  OutputBoard& board_;
  PlanDesk& plans_;
  std::vector<Action>& actions_;
  std::deque<Waiting> waiting_;
  NewestGoal newest_;
  blocks::GoalId newest_submitted_ = 0;
  Ticket last_ticket_ = 0;
  CommandsFell fell_{0, ""};  ///< the last that fell
  bool retells_ = false;
};

}  // namespace cobot_command::command
