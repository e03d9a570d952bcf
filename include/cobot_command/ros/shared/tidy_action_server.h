// An action server with the interface of actionlib's server, without those of its properties that lose goals,
// keep goals, or depend on the clocks of clients.
//
// - Goals and cancels have queues of their own, so that no cancel waits for goals. A cancel counts by
//   receipt: a goal received before it is cancelled, although its callback runs later.
// - A goal that has ended stays in the status list for some seconds; its content is not kept. These seconds
//   are those of a steady clock, because ROS time may stop.
// - The status is published with a queue of one, because each message includes the previous one.
// - The queues of actionlib have 50 places: in a burst of goals the first goals, and the first results too,
//   would be lost.
// - actionlib keeps a cancel of an unknown goal, for example of one that ended seconds ago, until five
//   seconds after the stamp of the cancel: without end if the stamp is zero, as in every usual cancel. The
//   list in each status message would grow without limit.
// - With actionlib a cancel with a stamp in the future, from a machine whose clock is ahead, would cancel all
//   goals received until that time. Here it counts until it was received.
// - With actionlib a goal that is cancelled before it is received ends without a reason.
// - actionlib publishes the status of goals five times per second for each action of a node, even without
//   subscribers, and wakes three threads each time.
//
// Threads: as in actionlib's server. Each of its two queues is served by one thread, which may be the same
// for both.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include <actionlib/server/action_server_base.h>
#include <actionlib_msgs/GoalID.h>
#include <actionlib_msgs/GoalStatus.h>
#include <actionlib_msgs/GoalStatusArray.h>
#include <boost/make_shared.hpp>
#include <ros/console.h>
#include <ros/message_event.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/steady_timer.h>
#include <ros/subscriber.h>

#include "cobot_command/ros/shared/own_handle.h"
#include "cobot_command/ros/shared/posted.h"
#include "cobot_command/ros/shared/receipts.h"
#include "cobot_command/ros/shared/serving_thread.h"

namespace cobot_command::ros_adapter {

// Texts of a result; both functions are specialized for an action of another package.
template <class Result>
[[nodiscard]] bool saysNothing(const Result& result) {
  return result.error_description.empty();
}
template <class Result>
void say(Result& result, const char* description, const char* remedy) {
  result.error_description = description;
  result.remedy = remedy;
}

/// The queues for the messages of an action. Both must outlive its server.
struct ActionQueues {
  NumberedQueue& goals;
  NumberedQueue& cancels;
  ServingThread* of_cancels = nullptr;  ///< serves `cancels`; nullptr: the thread of the goals does
};

template <class Action>
class TidyActionServer : public actionlib::ActionServerBase<Action> {
  using Base = actionlib::ActionServerBase<Action>;

 public:
  /// Serves `name`, relative to `node`, from start() on. Each callback runs within a callback of its queue.
  template <class OnGoal, class OnCancel>
  TidyActionServer(const ros::NodeHandle& node, const std::string& name, const ActionQueues& queues,
                   OnGoal on_goal, OnCancel on_cancel)
      : Base(std::move(on_goal), std::move(on_cancel), false),
        queues_(queues),
        action_(node, name),
        for_cancels_(node, name) {
    action_.setCallbackQueue(&queues_.goals);
    for_cancels_.setCallbackQueue(&queues_.cancels);
    tidying_ = action_.createSteadyTimer(
        ros::WallDuration(kTidyPeriod), [this](const ros::SteadyTimerEvent&) { tidy(); }, false, false);
    widenQueues(action_);
  }
  ~TidyActionServer() override {
    cancels_.shutdown();
    queues_.goals.removeByID(ownerOf(this));
  }

  /// For the goal whose callback this thread is running. True: a cancel received after the goal covers it.
  /// Call it when `on_cancel` can already find the goal: then no cancel is lost, and one may be found by
  /// both.
  [[nodiscard]] bool isCancelled() {
    const std::lock_guard<std::mutex> lock(cancels_mutex_);
    return std::any_of(kept_cancels_.begin(), kept_cancels_.end(), [this](const KeptCancel& cancel) {
      return cancel.receipt > currentReceipt() && covers(cancel.goals, incoming_);
    });
  }

 private:
  static constexpr double kTidyPeriod = 1.0;  // [s]
  // Number of goals that arrive, or of messages that are sent, at the same time.
  static constexpr int kQueueSize = 1000;
  using GoalEvent = ros::MessageEvent<const typename Base::ActionGoal>;

  static constexpr const char* kPublishing = "actionlib_server_pub_queue_size";
  static constexpr const char* kSubscribing = "actionlib_server_sub_queue_size";
  // Values of actionlib.
  static constexpr double kUsualFrequency = 5.0;  // [Hz]
  static constexpr double kUsualTimeout = 5.0;    // [s]

  /// A value that is already set stays.
  static void widenQueues(const ros::NodeHandle& action) {
    for (const char* name : {kSubscribing, kPublishing}) {
      if (!action.hasParam(name)) action.setParam(name, kQueueSize);
    }
  }

  /// Topics and parameters are those of actionlib's own server.
  void initialize() override {
    const std::uint32_t sent = queueSize(kPublishing);
    const std::uint32_t received = queueSize(kSubscribing);
    results_ = action_.advertise<typename Base::ActionResult>("result", sent);
    feedback_ = action_.advertise<typename Base::ActionFeedback>("feedback", sent);
    const auto listened_to = [this](const ros::SingleSubscriberPublisher&) { adjustTelling(); };
    status_ = action_.advertise<actionlib_msgs::GoalStatusArray>("status", 1, listened_to, listened_to,
                                                                 ros::VoidConstPtr(), true);
    this->status_list_timeout_ = ros::Duration(action_.param("status_list_timeout", kUsualTimeout));
    if (const double frequency = statusFrequency(); frequency > 0) {
      telling_ = action_.createSteadyTimer(
          ros::WallDuration(1 / frequency), [this](const ros::SteadyTimerEvent&) { publishStatus(); }, false,
          false);
    }
    const boost::function<void(const GoalEvent&)> on_goal = [this](const GoalEvent& goal) { take(goal); };
    goals_ = action_.subscribe<typename Base::ActionGoal>("goal", received, on_goal);
    cancels_ = for_cancels_.subscribe<actionlib_msgs::GoalID>(
        "cancel", received, [this](const actionlib_msgs::GoalID::ConstPtr& goals) { take(goals); });
  }

  /// A cancel that was received before the goal may not have been processed yet.
  void take(const GoalEvent& goal) {
    if (queues_.of_cancels != nullptr) queues_.of_cancels->catchUp();
    incoming_ = goal.getMessage()->goal_id;
    // For cancels, the goal gets the time at which it was received.
    if (incoming_.stamp.isZero()) incoming_.stamp = goal.getReceiptTime();
    this->goalCallback(goal.getMessage());
    tidying_.start();
  }

  /// Stored before the known goals are checked: a goal that is not known yet will find it.
  void take(const actionlib_msgs::GoalID::ConstPtr& goals) {
    {
      const std::lock_guard<std::mutex> lock(cancels_mutex_);
      kept_cancels_.push_back({currentReceipt(), *goals});
    }
    this->cancelCallback(goals);
    forgetTheFuture();
    post(
        queues_.goals, [this] { tidying_.start(); }, this);  // timers belong to the thread of the goals
  }

  /// The rule of actionlib.
  [[nodiscard]] static bool covers(const actionlib_msgs::GoalID& cancelled,
                                   const actionlib_msgs::GoalID& goal) {
    if (cancelled.id.empty() && cancelled.stamp.isZero()) return true;
    if (!cancelled.id.empty() && cancelled.id == goal.id) return true;
    return !cancelled.stamp.isZero() && goal.stamp <= cancelled.stamp;
  }

  [[nodiscard]] std::uint32_t queueSize(const char* name) const {
    const int size = action_.param(name, kQueueSize);
    return static_cast<std::uint32_t>(size < 0 ? kQueueSize : size);
  }

  [[nodiscard]] double statusFrequency() const {
    double frequency = kUsualFrequency;
    std::string name;
    if (action_.getParam("status_frequency", frequency)) {
      ROS_WARN_NAMED("actionlib", "status_frequency is deprecated: use actionlib_status_frequency");
    } else if (action_.searchParam("actionlib_status_frequency", name)) {
      frequency = action_.param(name, kUsualFrequency);
    }
    return frequency;
  }

  void publishResult(const actionlib_msgs::GoalStatus& status, const typename Base::Result& result) override {
    const boost::recursive_mutex::scoped_lock lock(this->lock_);
    typename Base::ActionResult message;
    message.header.stamp = ros::Time::now();
    message.status = status;
    message.result = result;
    const bool recalled = status.status == actionlib_msgs::GoalStatus::RECALLED;
    if (recalled && saysNothing(message.result)) explain(message);
    results_.publish(message);
    forgetContent(status.goal_id.id);
    publishStatus();
  }

  /// With the lock. The content of a goal may have megabytes.
  void forgetContent(const std::string& id) {
    for (auto& tracker : this->status_list_) {
      if (tracker.status_.goal_id.id != id || !tracker.goal_) continue;
      const auto without = boost::make_shared<typename Base::ActionGoal>();
      without->header = tracker.goal_->header;
      without->goal_id = tracker.goal_->goal_id;
      tracker.goal_ = without;
    }
  }

  void publishFeedback(const actionlib_msgs::GoalStatus& status,
                       const typename Base::Feedback& feedback) override {
    const boost::recursive_mutex::scoped_lock lock(this->lock_);
    typename Base::ActionFeedback message;
    message.header.stamp = ros::Time::now();
    message.status = status;
    message.feedback = feedback;
    feedback_.publish(message);
  }

  void publishStatus() override {
    const boost::recursive_mutex::scoped_lock lock(this->lock_);
    if (!this->started_) return;
    actionlib_msgs::GoalStatusArray message;
    message.header.stamp = ros::Time::now();
    message.status_list.reserve(this->status_list_.size());
    for (const auto& tracker : this->status_list_) message.status_list.push_back(tracker.status_);
    goals_told_ = !message.status_list.empty();
    status_.publish(message);
  }

  /// A new subscriber gets the last published status, which may be old, and then the present one.
  void adjustTelling() {
    if (status_.getNumSubscribers() == 0) {
      telling_.stop();
      return;
    }
    publishStatus();
    telling_.start();
  }

  /// That goal was not reported to the core. actionlib has its own text only for the stamp.
  static void explain(typename Base::ActionResult& message) {
    const bool by_stamp = !message.status.text.empty();
    say(message.result,
        by_stamp ? "cancelled before the goal was received: an earlier cancel covers all goals up to its "
                   "stamp, and the stamp of this goal is not later"
                 : "cancelled by its id before the goal was received",
        by_stamp ? "Send it again as a new goal; compare the clocks of the clients"
                 : "Send it again as a new goal");
  }

  void tidy() {
    const boost::recursive_mutex::scoped_lock lock(this->lock_);
    forgetEnded();
    forgetTheFuture();  // a clock may have been set back
    const bool keeps_cancels = forgetCancels();
    // A new subscriber must not receive goals that ended long ago.
    if (status_.getNumSubscribers() == 0 && (goals_told_ || !this->status_list_.empty())) publishStatus();
    // Until the next goal or cancel: otherwise all servers without work would wake the node all the time.
    const bool is_tidy = this->status_list_.empty() && !goals_told_ && !keeps_cancels;
    if (is_tidy && this->last_cancel_.isZero()) tidying_.stop();
  }

  /// Removes goals that ended that time ago, and cancels whose goal was never received.
  void forgetEnded() {
    const ros::SteadyTime now = ros::SteadyTime::now();
    const double timeout = this->status_list_timeout_.toSec();
    std::map<std::string, ros::SteadyTime> ended;
    this->status_list_.remove_if([&](const auto& tracker) {
      if (!tracker.handle_tracker_.expired()) return false;  // its goal is still open
      const std::string& id = tracker.status_.goal_id.id;
      const auto known = ended_.find(id);
      const ros::SteadyTime since = known == ended_.end() ? now : known->second;
      if ((now - since).toSec() > timeout) return true;
      ended.emplace(id, since);
      return false;
    });
    ended_.swap(ended);
  }

  /// Removes cancels that no goal can need: the callbacks of all goals received before this one have run.
  /// True: some cancels are left.
  bool forgetCancels() {
    const std::lock_guard<std::mutex> lock(cancels_mutex_);
    const Receipt now = currentReceipt();
    kept_cancels_.erase(std::remove_if(kept_cancels_.begin(), kept_cancels_.end(),
                                       [now](const KeptCancel& cancel) { return cancel.receipt < now; }),
                        kept_cancels_.end());
    return !kept_cancels_.empty();
  }

  /// Cancels count until now, whatever their stamps.
  void forgetTheFuture() {
    const boost::recursive_mutex::scoped_lock lock(this->lock_);
    this->last_cancel_ = std::min(this->last_cancel_, ros::Time::now());
  }

  /// Kept as long as goals received before it may still wait.
  struct KeptCancel {
    Receipt receipt;
    actionlib_msgs::GoalID goals;
  };

  ActionQueues queues_;
  OwnHandle action_;
  OwnHandle for_cancels_;
  actionlib_msgs::GoalID incoming_;  ///< the goal whose callback runs
  std::mutex cancels_mutex_;
  std::vector<KeptCancel> kept_cancels_;
  std::map<std::string, ros::SteadyTime> ended_;  ///< end of goals that are still in the status list
  ros::Publisher results_;
  ros::Publisher feedback_;
  ros::Publisher status_;
  ros::Subscriber goals_;
  ros::Subscriber cancels_;
  ros::SteadyTimer telling_;  ///< of the status; runs while there are subscribers
  bool goals_told_ = false;   ///< the last published status had goals
  ros::SteadyTimer tidying_;  ///< runs while there is anything to remove
};

}  // namespace cobot_command::ros_adapter
