// A goal of an action as its page shows it: sent, followed to its end, cancelled. The outputs are those of
// the function blocks.
#pragma once

#include <functional>
#include <string>

#include "clients/plan.h"

namespace cobot_command::rviz_plugin {

struct CommandState {
  enum class Phase { Idle, Busy, Done, Error, Aborted };
  /// Of an error that is not the robot's, and goes when its cause does.
  enum class Cause { Other, NoNode, NodeGone, TakenBack };

  Phase phase = Phase::Idle;
  int error_id = 0;  ///< 0: none
  std::string description;
  std::string remedy;
  int command_id_ack = 0;  ///< 0: none
  std::string text;        ///< what goes on, in plain words
  double progress = -1;    ///< 0..1; -1: nobody knows
  int step = -1;           ///< of a cycle, from 0; -1: none is under way
  Cause cause = Cause::Other;
  bool refused = false;     ///< an error, and nothing was begun
  bool unanswered = false;  ///< it was sent two seconds ago, and the node has not said a word of it
  double planned = 0;       ///< [s] 0: not known
  double actual = 0;        ///< [s] 0: not known
};

class Command {
 public:
  Command() = default;
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;
  virtual ~Command() = default;

  /// Of all goals that this one has sent; takes back what still waits for the node.
  virtual void cancel() = 0;
  /// Of the goals of all clients, which may be of before this one was there.
  virtual void cancelAll() = 0;
  /// Takes back a goal that still waits for the node.
  virtual void withdraw() = 0;
  /// From time to time: notices that the node has gone, whose goals then never end.
  virtual void look() = 0;

  [[nodiscard]] const CommandState& state() const { return state_; }
  [[nodiscard]] bool isBusy() const { return state_.phase == CommandState::Phase::Busy; }
  /// Of the goal that ended last.
  [[nodiscard]] const Plan& plan() const { return plan_; }
  /// How it ended is of no interest any more: what it was about has changed.
  void forget() {
    if (!isBusy() && state_.phase != CommandState::Phase::Idle) become({}, {});
  }
  /// Called on the thread of the user interface.
  void onChange(std::function<void()> listener) { listener_ = std::move(listener); }

 protected:
  void become(CommandState state);
  void become(CommandState state, Plan plan);

 private:
  CommandState state_;
  Plan plan_;
  std::function<void()> listener_;
};

}  // namespace cobot_command::rviz_plugin
