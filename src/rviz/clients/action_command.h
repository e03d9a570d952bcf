// A Command over actionlib. Its callbacks come on the thread that spins ROS's global queue: in RViz that of
// the user interface.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "clients/command.h"
#include "clients/outcome.h"
#include <actionlib/client/action_client.h>

namespace cobot_command::rviz_plugin {

/// What becomes of a goal of which the node says nothing for two seconds. One that it takes up later moves a
/// robot that nobody expects to move; a stop is never too late.
enum class Unanswered { TakenBack, Kept };

template <class Action>
class ActionCommand : public Command {
  ACTION_DEFINITION(Action)
  using Client = actionlib::ActionClient<Action>;
  using Handle = typename Client::GoalHandle;

 public:
  ActionCommand(const ros::NodeHandle& node, const std::string& name,
                Unanswered unanswered = Unanswered::TakenBack)
      : name_(node.resolveName(name)), client_(node, name), unanswered_(unanswered) {}

  /// As soon as the node is there: where it just starts, or RViz does, that takes a moment. A node that does
  /// not come is an error of this goal, as it would never hear of it.
  void send(const Goal& goal) {
    ++newest_;
    looks_without_node_ = 0;
    CommandState sent;
    sent.phase = CommandState::Phase::Busy;
    sent.text = "waiting for the command node";
    waiting_ = goal;
    become(sent);
    if (!client_.isServerConnected()) return;
    sendCancelOfAll();
    sendWaiting();
  }

  void withdraw() override {
    if (!waiting_) return;
    waiting_.reset();
    become({}, {});
  }

  void cancelAll() override {
    withdraw();
    cancels_all_ = true;
    if (client_.isServerConnected()) sendCancelOfAll();
  }

  void cancel() override {
    withdraw();
    for (Handle& handle : handles_) {
      if (handle.getCommState() != actionlib::CommState::DONE) handle.cancel();
    }
  }

  void look() override {
    if (client_.isServerConnected()) {
      looks_without_node_ = 0;
      sendCancelOfAll();
      noteReturn();
      if (waiting_) sendWaiting();
      lookForAnswer();
      return;
    }
    // Where a node is started again its topics are gone for a moment.
    if (!isBusy() || ++looks_without_node_ < kPatience) return;
    if (waiting_) {
      waiting_.reset();
      become(failed(Cause::NoNode, "There is no command node that provides " + name_,
                    "Start the command node, or choose another robot"),
             {});
      return;
    }
    handles_.clear();
    ++newest_;
    become(failed(Cause::NodeGone, kGone, "Check that the robot is at standstill; restart the node"), {});
  }

 private:
  /// Looks, of which there are ten in a second.
  static constexpr int kPatience = 20;
  static constexpr const char* kGone = "The command node is gone; the outcome of the command is unknown";
  using Cause = CommandState::Cause;

  /// The node is there, again or at last: what was said of its absence is not so any more.
  void noteReturn() {
    if (isBusy()) return;
    if (state().cause == Cause::NoNode) become({}, {});
    if (state().cause == Cause::NodeGone) {
      become(failed(Cause::Other, kGone,
                    "Check that the robot is at standstill, and how far the command was executed"),
             {});
    }
  }

  /// One that found no node yet: of a robot that has just been chosen.
  void sendCancelOfAll() {
    if (std::exchange(cancels_all_, false)) client_.cancelAllGoals();
  }

  void sendWaiting() {
    forgetEnded();
    const unsigned number = newest_;
    const Goal goal = *waiting_;
    waiting_.reset();
    looks_for_answer_ = 0;
    CommandState sent = state();
    sent.text = "sent";
    become(sent);
    handles_.push_back(client_.sendGoal(
        goal, [this, number](const Handle& handle) { follow(handle, number); },
        [this, number](const Handle& /*handle*/, const FeedbackConstPtr& feedback) {
          hear(*feedback, number);
        }));
  }

  /// A connection tells nothing: it lives on for minutes with a node that hangs, or a cable that is out.
  void lookForAnswer() {
    if (!isBusy() || waiting_ || looks_for_answer_ < 0) return;
    if (++looks_for_answer_ < kPatience) return;
    looks_for_answer_ = -1;
    if (unanswered_ == Unanswered::TakenBack) {
      cancel();
      ++newest_;
      become(failed(Cause::TakenBack, "The command node does not answer; the command was withdrawn",
                    "Check the node and its network; the robot may continue as before"),
             {});
      return;
    }
    CommandState silent = state();
    silent.unanswered = true;
    silent.text = "sent, but the command node does not answer: the robot may continue as before";
    become(silent);
  }

  static CommandState failed(Cause cause, std::string description, std::string remedy) {
    CommandState state;
    state.phase = CommandState::Phase::Error;
    state.cause = cause;
    state.description = std::move(description);
    state.remedy = std::move(remedy);
    return state;
  }

  static CommandState::Phase phaseOf(const actionlib::TerminalState& end) {
    switch (end.state_) {
      case actionlib::TerminalState::SUCCEEDED:
        return CommandState::Phase::Done;
      case actionlib::TerminalState::PREEMPTED:
      case actionlib::TerminalState::RECALLED:
        return CommandState::Phase::Aborted;
      default:
        return CommandState::Phase::Error;
    }
  }

  void hear(const Feedback& feedback, unsigned number) {
    if (number != newest_ || !isBusy()) return;
    CommandState now = state();
    now.unanswered = false;
    looks_for_answer_ = -1;
    outcome::readFeedback(feedback, now);
    become(now);
  }

  void hearOfIt() {
    looks_for_answer_ = -1;
    if (!state().unanswered) return;
    CommandState now = state();
    now.unanswered = false;
    now.text = "taken";
    become(now);
  }

  /// The node answers at last to a goal that was taken back meanwhile.
  void hearOfTakenBack(const Handle& handle, unsigned number) {
    if (state().cause != Cause::TakenBack || number + 1 != newest_) return;
    const auto comm = handle.getCommState();
    if (comm == actionlib::CommState::WAITING_FOR_GOAL_ACK ||
        comm == actionlib::CommState::WAITING_FOR_CANCEL_ACK) {
      return;
    }
    CommandState ended;
    ended.phase = CommandState::Phase::Aborted;
    ended.description = "It was withdrawn because the command node did not answer for two seconds";
    become(ended, {});
  }

  void follow(const Handle& handle, unsigned number) {
    if (number != newest_) {
      hearOfTakenBack(handle, number);
      return;
    }
    if (handle.getCommState() != actionlib::CommState::DONE) {
      if (handle.getCommState() != actionlib::CommState::WAITING_FOR_GOAL_ACK) hearOfIt();
      return;
    }
    CommandState ended = state();
    ended.unanswered = false;
    ended.phase = phaseOf(handle.getTerminalState());
    ended.refused = handle.getTerminalState() == actionlib::TerminalState::REJECTED;
    ended.text.clear();
    ended.progress = -1;
    ended.step = -1;
    const ResultConstPtr result = handle.getResult();
    if (!result) {
      become(
          failed(Cause::Other, "The goal was lost: the command node was restarted", "Send the command again"),
          {});
      return;
    }
    outcome::readResult(*result, ended);
    become(ended, outcome::readPlan(*result));
  }

  void forgetEnded() {
    handles_.erase(
        std::remove_if(handles_.begin(), handles_.end(),
                       [](const Handle& h) { return h.getCommState() == actionlib::CommState::DONE; }),
        handles_.end());
  }

  std::string name_;
  Client client_;
  std::optional<Goal> waiting_;  ///< for the node
  bool cancels_all_ = false;     ///< waits for the node, too
  std::vector<Handle> handles_;  ///< before the client in destruction, as they want it
  unsigned newest_ = 0;          ///< which goal is shown: the one that was sent last
  int looks_without_node_ = 0;
  int looks_for_answer_ = -1;  ///< since it was sent; -1: it was answered
  Unanswered unanswered_;
};

}  // namespace cobot_command::rviz_plugin
