// actionlib's server, where it loses goals or lives by the clocks of its clients.
//
// - Its queues have 50 places: of a burst of goals the first, and of their results too, would be lost.
// - A cancel of a goal that it does not know, as of one that ended seconds ago, is kept until five seconds
//   after the stamp of the cancel: for ever when the stamp is zero, as that of every usual cancel. The list
//   that each status message carries would never end to grow.
// - A cancel with a stamp in the future, from a machine whose clock is ahead, would cancel on arrival all
//   goals until then. Here it counts until it came.
// - A goal that was cancelled before it came ends without a word why.
// - It tells the status of its goals five times a second, whether anybody listens or not: with all actions of
//   a node that wakes three threads 75 times a second.
//
// Threads: as actionlib's server; one thread spins.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include <actionlib/server/action_server_base.h>
#include <actionlib_msgs/GoalID.h>
#include <actionlib_msgs/GoalStatus.h>
#include <actionlib_msgs/GoalStatusArray.h>
#include <ros/console.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/steady_timer.h>
#include <ros/subscriber.h>
#include <ros/timer.h>

namespace cobot_command::ros_adapter {

// The words of a result; for one of another package's action both are specialized.
template <class Result>
[[nodiscard]] bool saysNothing(const Result& result) {
  return result.error_description.empty();
}
template <class Result>
void say(Result& result, const char* description, const char* remedy) {
  result.error_description = description;
  result.remedy = remedy;
}

template <class Action>
class TidyActionServer : public actionlib::ActionServerBase<Action> {
  using Base = actionlib::ActionServerBase<Action>;

 public:
  /// Serves `name`, relative to `node`, from start() on.
  template <class OnGoal, class OnCancel>
  TidyActionServer(const ros::NodeHandle& node, const std::string& name, OnGoal on_goal, OnCancel on_cancel)
      : Base(std::move(on_goal), std::move(on_cancel), false),
        action_(node, name),
        tidying_(node.createSteadyTimer(
            ros::WallDuration(kTidyPeriod), [this](const ros::SteadyTimerEvent&) { tidy(); }, false, false)) {
    widenQueues(action_);
  }

 private:
  static constexpr double kTidyPeriod = 1.0;  // [s]
  // Of goals that come, or messages that go, at once.
  static constexpr int kQueueSize = 1000;
  static constexpr const char* kPublishing = "actionlib_server_pub_queue_size";
  static constexpr const char* kSubscribing = "actionlib_server_sub_queue_size";
  // Those of actionlib.
  static constexpr double kUsualFrequency = 5.0;  // [Hz]
  static constexpr double kUsualTimeout = 5.0;    // [s]

  /// What somebody has set already stays.
  static void widenQueues(const ros::NodeHandle& action) {
    for (const char* name : {kSubscribing, kPublishing}) {
      if (!action.hasParam(name)) action.setParam(name, kQueueSize);
    }
  }

  /// Topics and parameters as those of actionlib's own server.
  void initialize() override {
    const std::uint32_t sent = queueSize(kPublishing);
    const std::uint32_t heard = queueSize(kSubscribing);
    results_ = action_.advertise<typename Base::ActionResult>("result", sent);
    feedback_ = action_.advertise<typename Base::ActionFeedback>("feedback", sent);
    const auto listened_to = [this](const ros::SingleSubscriberPublisher&) { adjustTelling(); };
    status_ = action_.advertise<actionlib_msgs::GoalStatusArray>("status", sent, listened_to, listened_to,
                                                                 ros::VoidConstPtr(), true);
    this->status_list_timeout_ = ros::Duration(action_.param("status_list_timeout", kUsualTimeout));
    if (const double frequency = statusFrequency(); frequency > 0) {
      telling_ = action_.createTimer(
          ros::Duration(1 / frequency), [this](const ros::TimerEvent&) { publishStatus(); }, false, false);
    }
    goals_ = action_.subscribe<typename Base::ActionGoal>(
        "goal", heard, [this](const typename Base::ActionGoal::ConstPtr& goal) {
          this->goalCallback(goal);
          tidying_.start();
        });
    cancels_ = action_.subscribe<actionlib_msgs::GoalID>(
        "cancel", heard, [this](const actionlib_msgs::GoalID::ConstPtr& goal) {
          this->cancelCallback(goal);
          forgetTheFuture();
          tidying_.start();
        });
  }

  [[nodiscard]] std::uint32_t queueSize(const char* name) const {
    const int size = action_.param(name, kQueueSize);
    return static_cast<std::uint32_t>(size < 0 ? kQueueSize : size);
  }

  [[nodiscard]] double statusFrequency() const {
    double frequency = kUsualFrequency;
    std::string name;
    if (action_.getParam("status_frequency", frequency)) {
      ROS_WARN_NAMED("actionlib", "status_frequency is deprecated: set actionlib_status_frequency");
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
    publishStatus();
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

  /// Each goal that has ended long enough ago for the last time.
  void publishStatus() override {
    const boost::recursive_mutex::scoped_lock lock(this->lock_);
    if (!this->started_) return;
    actionlib_msgs::GoalStatusArray message;
    message.header.stamp = ros::Time::now();
    message.status_list.reserve(this->status_list_.size());
    for (const auto& tracker : this->status_list_) message.status_list.push_back(tracker.status_);
    this->status_list_.remove_if([&](const auto& tracker) {
      const ros::Time& since = tracker.handle_destruction_time_;
      return !since.isZero() && since + this->status_list_timeout_ < message.header.stamp;
    });
    goals_told_ = !message.status_list.empty();
    status_.publish(message);
  }

  /// Who begins to listen gets the last status that was told, which may be old, and then one of now.
  void adjustTelling() {
    if (status_.getNumSubscribers() == 0) {
      telling_.stop();
      return;
    }
    publishStatus();
    telling_.start();
  }

  /// Nobody was told of that goal. actionlib has words of its own only for the stamp.
  static void explain(typename Base::ActionResult& message) {
    const bool by_stamp = !message.status.text.empty();
    say(message.result,
        by_stamp ? "cancelled before it came: a cancel took away all goals until its stamp, and that of this "
                   "goal is not later"
                 : "cancelled by its id before it came",
        by_stamp ? "Send it again as a new goal; compare the clocks of the clients"
                 : "Send it again as a new goal");
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
    // Whoever comes next shall not hear of goals that are long gone.
    if (status_.getNumSubscribers() == 0 && (goals_told_ || !this->status_list_.empty())) publishStatus();
    // Until the next goal or cancel: fifteen servers that look after nothing would wake the node all the
    // time.
    if (this->status_list_.empty() && !goals_told_ && this->last_cancel_.isZero()) tidying_.stop();
  }

  /// Cancels count until now, whatever their stamps say.
  void forgetTheFuture() {
    const boost::recursive_mutex::scoped_lock lock(this->lock_);
    this->last_cancel_ = std::min(this->last_cancel_, ros::Time::now());
  }

  ros::NodeHandle action_;
  ros::Publisher results_;
  ros::Publisher feedback_;
  ros::Publisher status_;
  ros::Subscriber goals_;
  ros::Subscriber cancels_;
  ros::Timer telling_;        ///< of the status; runs while somebody listens
  bool goals_told_ = false;   ///< the last status that was told had some
  ros::SteadyTimer tidying_;  ///< runs while there is anything to tidy
};

}  // namespace cobot_command::ros_adapter
