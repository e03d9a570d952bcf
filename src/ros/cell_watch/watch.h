// The monitor of a cell on a thread of its own: joint states and positions in, distances and stops out.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "cell_watch/believed_places.h"
#include "cell_watch/mover_namespaces.h"
#include "cell_watch/pictures/watch_view.h"
#include "cell_watch/stop_line.h"
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/service_server.h>
#include <ros/spinner.h>
#include <ros/steady_timer.h>
#include <ros/subscriber.h>
#include <sensor_msgs/JointState.h>
#include <std_msgs/Float64.h>
#include <std_srvs/Trigger.h>

#include "cobot_command/CellReport.h"
#include "cobot_command/CellState.h"
#include "cobot_command/cell/monitor/monitor.h"
#include "cobot_command/ros/shared/own_handle.h"

namespace cobot_command::ros_adapter {

class Watch {
 public:
  /// Of a robot that is heard for the first time, the prefix of its names. On the watch's thread.
  using PrefixTold = std::function<void(std::size_t robot, const std::string& prefix)>;

  /// Topics and services are relative to `node`. Without `places` all robots carry all that they may,
  /// and may go anywhere.
  Watch(const ros::NodeHandle& node, cell::Monitor monitor, MoverNamespaces namespaces,
        std::optional<BelievedPlaces> places, PrefixTold prefix_told);
  ~Watch();  ///< stop()
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  void start();
  /// Nothing is watched any more. It may be called again.
  void stop();
  /// As it was told last. From any thread.
  [[nodiscard]] WatchView view() const;

 private:
  /// Makes one for what is measured of it, on whatever thread. What it hears, its queue serves.
  [[nodiscard]] MadeBeside<ros::Subscriber>::Make listeningTo(std::size_t mover);
  void take(std::size_t robot, const sensor_msgs::JointState& message);
  void takePosition(std::size_t mechanism, double position);
  void hear(const ros::MessageEvent<cobot_command::CellReport const>& event);
  void hearState(const ros::MessageEvent<cobot_command::CellState const>& event);
  /// Has the monitor take it for carrying what it carries, and doing what it may do, by what is known now.
  void believe(std::size_t mover, Instant now);
  /// What is too old to be relied on is believed no longer.
  void forget(Instant now);
  bool reset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  /// Looks, where that is due, does what follows, and has itself called again.
  void advance(Instant now);
  void carryOut();
  void stopAll(const std::string& why);
  void tell(Instant now);
  /// For people; empty: its program has it carry nothing.
  [[nodiscard]] std::string carriedBy(std::size_t mover) const;
  void arm(Instant now);

  OwnHandle node_;
  /// Shared with the threads that make subscribers, which the master may keep until this has long ended.
  std::shared_ptr<ros::CallbackQueue> queue_ = std::make_shared<ros::CallbackQueue>();
  cell::Monitor monitor_;
  MoverNamespaces namespaces_;
  std::optional<BelievedPlaces> places_;
  std::vector<std::optional<BelievedPlaces::Belief>>
      beliefs_;  ///< by mover; nothing: it carries all that it may, and may go anywhere
  PrefixTold prefix_told_;
  std::vector<bool> is_prefix_told_;
  std::vector<std::unique_ptr<StopLine>> stop_lines_;
  std::vector<MadeBeside<ros::Subscriber>> measured_;
  ros::Subscriber reports_;
  ros::Subscriber states_;
  ros::ServiceServer reset_;
  ros::Publisher distances_;
  ros::SteadyTimer timer_;
  std::optional<Instant> armed_;
  bool is_news_ = true;  ///< since it was told last
  Instant told_at_{};
  Instant published_at_{};
  std::unique_ptr<ros::AsyncSpinner> spinner_;

  mutable std::mutex mutex_;  // guards the next one
  WatchView view_;
};

}  // namespace cobot_command::ros_adapter
