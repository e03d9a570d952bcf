// One function block as an action server: it passes goals to the core, and returns their results.
//
// A goal is PENDING until its turn, and may end before. A cancel of all goals (empty GoalID) arrives as one
// cancel for each goal.
//
// The id of a goal is the number of its receipt. So the ids show which goals were received before a stop or a
// cancel, whichever of them is processed first.
//
// Threads: goals arrive on one, cancels on another, and the core's thread calls accepted(), progressed() and
// ended(). All of this may happen at the same time. The bridge never holds its own lock while it calls the
// action server.
#pragma once

#include <algorithm>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include <ros/node_handle.h>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/outcome.h"
#include "cobot_command/ros/command/goal_intake.h"
#include "cobot_command/ros/shared/conversions.h"
#include "cobot_command/ros/shared/tidy_action_server.h"

namespace cobot_command::ros_adapter {

/// The receiver of goals and cancels.
struct GoalSink {
  std::function<void(IncomingGoal)> submit;
  /// `newest`: the newest goal that was received before the cancel.
  std::function<void(blocks::GoalId id, blocks::GoalId newest)> cancel;
};

/// Where an action's messages are processed, and where its goals go.
struct GoalWay {
  ActionQueues queues;
  GoalSink sink;
};

/// Data for results and feedback, in addition to the values of the core.
struct FillSite {
  const JointNames& joint_names;  ///< of planned motions
  const ClockPair& clocks;
};

/// The goal of a message. A block whose messages name joints has an overload of its own that replaces
/// toGoal().
template <class Message>
[[nodiscard]] auto readGoal(const Message& message, const Lookups& lookups, const JointNames& /*names*/) {
  return toGoal(message, lookups);
}

/// Receives the core's reports about the goals of one block. A report about an unknown goal, or one that has
/// ended, is ignored.
class GoalListener {
 public:
  virtual ~GoalListener() = default;
  virtual void accepted(blocks::GoalId id) = 0;
  virtual void progressed(blocks::GoalId id, const blocks::Progress& progress, const ClockPair& clocks) = 0;
  virtual void ended(blocks::GoalId id, const blocks::Outcome& outcome, const ClockPair& clocks) = 0;
};

template <class Action>
class ActionBridge : public GoalListener {
 public:
  /// Serves the action `name`, relative to `node`, until it is destroyed. `joint_names`: of planned motions.
  ActionBridge(const ros::NodeHandle& node, const std::string& name, JointNames joint_names, GoalWay way)
      : joint_names_(std::move(joint_names)),
        sink_(std::move(way.sink)),
        server_(
            node, name, way.queues, [this](Handle handle) { onGoal(handle); },
            [this](Handle handle) { onCancel(handle); }) {
    server_.start();
  }

  void accepted(blocks::GoalId id) override {
    Handle handle;
    if (find(id, handle)) handle.setAccepted();
  }

  void progressed(blocks::GoalId id, const blocks::Progress& progress, const ClockPair& clocks) override {
    Handle handle;
    if (!find(id, handle)) return;
    Feedback feedback;
    fill(feedback, progress, FillSite{joint_names_, clocks});
    handle.publishFeedback(feedback);
  }

  void ended(blocks::GoalId id, const blocks::Outcome& outcome, const ClockPair& clocks) override {
    Handle handle;
    if (!take(id, handle)) return;
    Result result;
    fill(result, outcome, FillSite{joint_names_, clocks});
    const bool ran = outcome.ending == blocks::Ending::Done || outcome.ending == blocks::Ending::Aborted;
    if (ran && isPending(handle)) handle.setAccepted();  // actionlib requires ACTIVE before these ends
    switch (outcome.ending) {
      case blocks::Ending::Done:
        handle.setSucceeded(result, outcome.error_description);
        break;
      case blocks::Ending::Rejected:
        handle.setRejected(result, outcome.error_description);
        break;
      case blocks::Ending::Aborted:
        handle.setAborted(result, outcome.error_description);
        break;
      case blocks::Ending::CommandAborted:
        handle.setCanceled(result, outcome.error_description);
        break;
    }
  }

 private:
  using Server = TidyActionServer<Action>;
  using Handle = typename Server::GoalHandle;
  using Result = typename Server::Result;
  using Feedback = typename Server::Feedback;

  struct Open {
    blocks::GoalId id;
    std::string name;  ///< the client's id of the goal
    Handle handle;
  };

  static bool isPending(const Handle& handle) {
    const auto status = handle.getGoalStatus().status;
    return status == actionlib_msgs::GoalStatus::PENDING || status == actionlib_msgs::GoalStatus::RECALLING;
  }

  void onGoal(Handle handle) {
    const blocks::GoalId id = currentReceipt();
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      open_.push_back({id, handle.getGoalID().id, handle});
    }
    sink_.submit({id,
                  [goal = handle.getGoal(), names = joint_names_](const Lookups& lookups) -> blocks::Goal {
                    return readGoal(*goal, lookups, names);
                  },
                  [this] { return server_.isCancelled(); }});
  }

  void onCancel(Handle handle) {
    const std::string name = handle.getGoalID().id;
    blocks::GoalId id = 0;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      const auto found =
          std::find_if(open_.begin(), open_.end(), [&](const Open& o) { return o.name == name; });
      if (found == open_.end()) return;
      id = found->id;
    }
    sink_.cancel(id, currentReceipt());
  }

  bool find(blocks::GoalId id, Handle& handle) { return lookUp(id, handle, false); }
  bool take(blocks::GoalId id, Handle& handle) { return lookUp(id, handle, true); }

  bool lookUp(blocks::GoalId id, Handle& handle, bool forget) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = std::find_if(open_.begin(), open_.end(), [&](const Open& o) { return o.id == id; });
    if (found == open_.end()) return false;
    handle = found->handle;
    if (forget) open_.erase(found);
    return true;
  }

  JointNames joint_names_;
  GoalSink sink_;
  std::mutex mutex_;
  std::vector<Open> open_;
  Server server_;  // last: its callbacks use all of the above
};

}  // namespace cobot_command::ros_adapter
