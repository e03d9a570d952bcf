// actionlib's server, where it loses goals or lives by the clocks of its clients.
//
// - Its queues have 50 places: of a burst of goals the first, and of their results too, would be lost.
// - A cancel of a goal that it does not know, as of one that ended seconds ago, is kept until five seconds
//   after the stamp of the cancel: for ever when the stamp is zero, as that of every usual cancel. The list
//   that each status message carries would never end to grow.
// - A cancel with a stamp in the future, from a machine whose clock is ahead, would cancel on arrival all
//   goals until then. Here it counts until it came.
// - A goal that was cancelled before it came ends without a word why.
//
// Threads: as actionlib's server; one thread spins.
#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include <actionlib/server/action_server.h>
#include <actionlib_msgs/GoalID.h>
#include <actionlib_msgs/GoalStatus.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>

namespace cobot_command::ros_adapter {

template <class Action>
class TidyActionServer : public actionlib::ActionServer<Action> {
  using Base = actionlib::ActionServer<Action>;

 public:
  /// Serves `name`, relative to `node`, from start() on.
  template <class OnGoal, class OnCancel>
  TidyActionServer(const ros::NodeHandle& node, const std::string& name, OnGoal on_goal, OnCancel on_cancel)
      : Base(node, name, std::move(on_goal), std::move(on_cancel), false),
        action_(node, name),
        tidying_(node.createSteadyTimer(ros::WallDuration(kTidyPeriod),
                                        [this](const ros::SteadyTimerEvent&) { tidy(); })) {
    widenQueues(action_);
    results_ =
        action_.advertise<typename Base::ActionResult>("result", action_.param(kPublishing, kQueueSize));
  }

  /// As actionlib's own, which is out of reach from here, but with the reason of what it ends by itself.
  void publishResult(const actionlib_msgs::GoalStatus& status, const typename Base::Result& result) override {
    const boost::recursive_mutex::scoped_lock lock(this->lock_);
    typename Base::ActionResult message;
    message.header.stamp = ros::Time::now();
    message.status = status;
    message.result = result;
    const bool recalled = status.status == actionlib_msgs::GoalStatus::RECALLED;
    if (recalled && result.error_description.empty()) explain(message);
    results_.publish(message);
    publishStatus();
  }

  void start() {
    Base::start();
    // Behind actionlib's own subscriber, so that it is called next, before any goal.
    cancels_ = action_.subscribe<actionlib_msgs::GoalID>(
        "cancel", kQueueSize, [this](const actionlib_msgs::GoalID::ConstPtr&) { forgetTheFuture(); });
  }

 private:
  using actionlib::ActionServerBase<Action>::publishStatus;

  static constexpr double kTidyPeriod = 1.0;  // [s]
  // Of goals that come, or messages that go, at once.
  static constexpr int kQueueSize = 1000;
  static constexpr const char* kPublishing = "actionlib_server_pub_queue_size";

  /// What somebody has set already stays.
  static void widenQueues(const ros::NodeHandle& action) {
    for (const char* name : {"actionlib_server_sub_queue_size", kPublishing}) {
      if (!action.hasParam(name)) action.setParam(name, kQueueSize);
    }
  }

  /// Nobody was told of that goal. actionlib has words of its own only for the stamp.
  static void explain(typename Base::ActionResult& message) {
    const bool by_stamp = !message.status.text.empty();
    message.result.error_description =
        by_stamp ? "cancelled before it came: a cancel took away all goals until its stamp, and that of this "
                   "goal is not later"
                 : "cancelled by its id before it came";
    message.result.remedy = by_stamp ? "Send it again as a new goal; compare the clocks of the clients"
                                     : "Send it again as a new goal";
  }

  void tidy() {
    const boost::recursive_mutex::scoped_lock lock(this->lock_);
    const ros::Time now = ros::Time::now();
    for (auto& tracker : this->status_list_) {
      if (!tracker.handle_tracker_.expired()) continue;  // its goal is still open
      ros::Time& since = tracker.handle_destruction_time_;
      if (since.isZero() || since > now) since = now;  // from here on actionlib's own five seconds
    }
    forgetTheFuture();  // a clock may have been set back
  }

  /// Cancels count until now, whatever their stamps say.
  void forgetTheFuture() {
    const boost::recursive_mutex::scoped_lock lock(this->lock_);
    this->last_cancel_ = std::min(this->last_cancel_, ros::Time::now());
  }

  ros::NodeHandle action_;
  ros::Publisher results_;
  ros::Subscriber cancels_;
  ros::SteadyTimer tidying_;
};

}  // namespace cobot_command::ros_adapter
